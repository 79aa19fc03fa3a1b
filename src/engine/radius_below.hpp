#pragma once

#include <string>

namespace plumbline::engine_steps {

/// The advice to take a radius below this distance, which is rounded down: every radius below the
/// number that is written is below the distance itself.
std::string radius_below(double distance);

}  // namespace plumbline::engine_steps
