#include "plumbline/ladder.hpp"

#include "core.hpp"

namespace plumbline::python {

void bind_ladder(nb::module_&) {}

}  // namespace plumbline::python
