#include <array>
#include <cmath>

#include "plumbline/edits.hpp"

namespace plumbline {

std::string to_text(EditKind kind) {
  constexpr std::array<const char*, kEditKinds> kNames = {"merge", "dissolve", "grow",    "bridge",
                                                          "joint", "door",     "trim",    "sliver",
                                                          "weld",  "snap",     "simplify"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::string to_text(FaceFate fate) {
  constexpr std::array<const char*, 5> kNames = {"closed", "split", "joined", "opened", "changed"};
  return kNames.at(static_cast<std::size_t>(fate));
}

std::string tolerance_text(const Rational& tolerance) {
  const double rounded = nearest_double(tolerance);
  if (!std::isfinite(rounded)) return exact_text(tolerance);
  const std::string text = shortest_text(rounded);
  return parse_decimal(text) == tolerance ? text : exact_text(tolerance);
}

}  // namespace plumbline
