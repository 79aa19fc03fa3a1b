#include "engine/radius_below.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace plumbline::engine_steps {
namespace {

/// Three digits are off by at most this part of a number.
constexpr double kHalfUnit = 0.005;

}  // namespace

std::string radius_below(double distance) {
  std::string number = fmt::format("{:.3g}", distance);
  if (std::strtod(number.c_str(), nullptr) > distance) {
    number = fmt::format("{:.3g}", distance * (1 - kHalfUnit));
  }
  return fmt::format("a radius below {} keeps them apart", number);
}

}  // namespace plumbline::engine_steps
