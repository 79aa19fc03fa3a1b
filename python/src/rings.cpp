#include "plumbline/rings.hpp"

#include "core.hpp"

namespace plumbline::python {

void bind_rings(nb::module_&) {}

}  // namespace plumbline::python
