#include "plumbline/rooms.hpp"

#include "core.hpp"

namespace plumbline::python {

void bind_rooms(nb::module_&) {}

}  // namespace plumbline::python
