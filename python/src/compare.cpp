#include "plumbline/compare.hpp"

#include "core.hpp"

namespace plumbline::python {

void bind_compare(nb::module_&) {}

}  // namespace plumbline::python
