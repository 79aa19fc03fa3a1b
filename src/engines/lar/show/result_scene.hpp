#pragma once

#include "engines/lar/show/scene.hpp"
#include "plumbline/engines/lar.hpp"

namespace plumbline::svg {

/// The scene of the result, which must outlive it. The clusters are those of the first round; solid
/// faces are those of the complex, each boundary one polyline that walks every bridge twice.
Scene scene(const lar::Result& result);

}  // namespace plumbline::svg
