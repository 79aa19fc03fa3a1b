#include "plumbline/check.hpp"

#include "core.hpp"

namespace plumbline::python {

void bind_check(nb::module_&) {}

}  // namespace plumbline::python
