#include "plumbline/chains/triangulate.hpp"

#include "core.hpp"

namespace plumbline::python {

void bind_triangulate(nb::module_&) {}

}  // namespace plumbline::python
