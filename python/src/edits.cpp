#include "plumbline/edits.hpp"

#include "core.hpp"

namespace plumbline::python {

void bind_edits(nb::module_&) {}

}  // namespace plumbline::python
