#include "cli/engine_settings.hpp"

#include "cli/commands.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {

EngineSettings engine_settings(const std::vector<std::string>& settings, const Engine& engine,
                               const SegmentSet& input) {
  EngineSettings result;
  Parameters& parameters = result.parameters;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) {
      throw Error(ErrorCode::BadInput, "--set needs NAME=VALUE", {}, setting);
    }
    const std::string name = setting.substr(0, equals), text = setting.substr(equals + 1);
    if (name == "radius") result.radius_from = is_preset(text) ? text : "number";
    if (name != "radius" || !is_preset(text)) {
      parameters[name] = parameter_value(engine, name, text);
      continue;
    }
    parameter_value(engine, name, "0");  // refused where the engine has no radius
    if (const auto radius = preset_radius(text, input)) parameters[name] = *radius;
  }
  return result;
}

}  // namespace plumbline::cli
