#include "plumbline/output.hpp"

#include "core.hpp"

namespace plumbline::python {

void bind_output(nb::module_&) {}

}  // namespace plumbline::python
