#pragma once

#include "engines/lar/show/scene.hpp"
#include "plumbline/engines/inters.hpp"

namespace plumbline::svg {

/// The scene of the trace, which must outlive it. Solid faces are the cells of the containment
/// lattice or, where there is none, the faces of the result; bridges are those of the original.
Scene scene(const inters::Trace& trace);

}  // namespace plumbline::svg
