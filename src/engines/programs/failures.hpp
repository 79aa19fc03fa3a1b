#pragma once

#include <string>

#include "engines/programs/protocol.hpp"
#include "plumbline/engine.hpp"

namespace plumbline::programs {

/// Why there is no result, as a finding about the whole complex.
Explained explained(const Failure& failure, const std::string& engine);

}  // namespace plumbline::programs
