#include "plumbline/diagnose.hpp"

#include "core.hpp"

namespace plumbline::python {

void bind_diagnose(nb::module_&) {}

}  // namespace plumbline::python
