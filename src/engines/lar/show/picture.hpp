#pragma once

#include "engines/lar/show/scene.hpp"
#include "plumbline/engines/lar_show.hpp"

namespace plumbline::svg {

/// The picture of a scene. Throws: Error BadInput as `to_svg` of lar_show.hpp.
std::string picture(const Scene& scene, const LarPicture& options);

}  // namespace plumbline::svg
