#include "plumbline/repair.hpp"

#include "core.hpp"

namespace plumbline::python {

void bind_repair(nb::module_&) {}

}  // namespace plumbline::python
