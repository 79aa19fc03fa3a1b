#pragma once

#include <string>
#include <vector>

#include "output/svg/kit.hpp"

namespace plumbline {

/// Where a finding is drawn, and its number.
struct FindingPlace {
  PointD place;
  std::size_t number;
};

/// A ring around each place, each with its number beside it, as SVG elements. Numbers at the same
/// place share one label. Up to kAllNumbered findings are all numbered; of more, those whose labels
/// overlap no other.
std::string labelled_rings(const std::vector<FindingPlace>& places, const svg::Box& panel);
inline constexpr std::size_t kAllNumbered = 60;

}  // namespace plumbline
