#pragma once

#include "core.hpp"
#include "plumbline/structure.hpp"

namespace plumbline::python {

/// What makes a Structure, Struct by Struct.
void bind_making(nb::class_<Structure>& type);

}  // namespace plumbline::python
