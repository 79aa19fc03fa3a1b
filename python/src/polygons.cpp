#include "plumbline/polygons.hpp"

#include "core.hpp"

namespace plumbline::python {

void bind_polygons(nb::module_&) {}

}  // namespace plumbline::python
