#include "plumbline/engine.hpp"

#include "core.hpp"

namespace plumbline::python {

void bind_engine(nb::module_&) {}

}  // namespace plumbline::python
