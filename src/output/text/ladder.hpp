#pragma once

#include <string>

#include "plumbline/check.hpp"

namespace plumbline {

/// The radii for which an engine is right, as a line.
std::string right_radii_text(const RightRadii& radii, const std::string& engine);

}  // namespace plumbline
