#include "plumbline/arrange.hpp"
#include "plumbline/engine.hpp"

namespace plumbline {

ExactComplex Run::continued(const StageOutput& output, std::size_t threads) const {
  return arrange(output.work, threads);
}

std::optional<std::string> Run::suspect(const Cause& /*cause*/) const { return std::nullopt; }

Cause Run::refined(const Finding& /*finding*/, Cause cause) const { return cause; }

}  // namespace plumbline
