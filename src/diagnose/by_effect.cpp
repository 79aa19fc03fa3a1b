// Which defects matter most: by what they do to faces.

#include <algorithm>
#include <numeric>
#include <tuple>

#include "plumbline/diagnose.hpp"

namespace plumbline {
namespace {

// A face of so many squares of the search distance is more than a sliver.
constexpr double kLeastArea = 100;

/// The less, the more it matters what kind it is.
int rank(const Defect& defect, double within) {
  if (defect.open_area && *defect.open_area >= kLeastArea * within * within) return 0;
  switch (defect.kind) {
    case DefectKind::InvalidRing:
      return 1;
    case DefectKind::Gap:
    case DefectKind::Undershoot:
      return 2;
    case DefectKind::NearMiss:
    case DefectKind::Sliver:
      return 3;
    case DefectKind::Overshoot:
    case DefectKind::ShortEdge:
    case DefectKind::NearlyParallel:
      return 4;
    case DefectKind::Duplicate:
    case DefectKind::Overlap:
      return 5;
    case DefectKind::Dangle:
    case DefectKind::Bridge:
      return 6;
  }
  return 7;
}

}  // namespace

std::vector<std::size_t> by_effect(const Diagnosis& diagnosis) {
  std::vector<std::size_t> order(diagnosis.defects.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const double within = nearest_double(diagnosis.within);
  const auto key = [&](std::size_t i) {
    const Defect& defect = diagnosis.defects[i];
    return std::tuple(rank(defect, within), -defect.open_area.value_or(0), i);
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
  return order;
}

}  // namespace plumbline
