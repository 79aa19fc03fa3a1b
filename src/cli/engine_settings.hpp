#pragma once

#include <string>
#include <vector>

#include "plumbline/engine.hpp"

namespace plumbline::cli {

/// What --set says of an engine.
struct EngineSettings {
  Parameters parameters;
  std::string radius_from = "drawing";  ///< "number", or a preset
};

/// Of texts NAME=VALUE; of one name the last counts. Presets of the radius are for this input;
/// without one they are just known. Throws: Error BadInput for what the engine has not.
EngineSettings engine_settings(const std::vector<std::string>& settings, const Engine& engine,
                               const SegmentSet& input);

}  // namespace plumbline::cli
