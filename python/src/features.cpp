#include "plumbline/features.hpp"

#include "core.hpp"

namespace plumbline::python {

void bind_features(nb::module_&) {}

}  // namespace plumbline::python
