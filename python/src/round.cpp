#include "plumbline/round.hpp"

#include "core.hpp"

namespace plumbline::python {

void bind_round(nb::module_&) {}

}  // namespace plumbline::python
