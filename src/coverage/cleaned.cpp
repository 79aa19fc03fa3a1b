// Gives faces to polygons: overlaps first, so that gaps see to whom they went.

#include <algorithm>
#include <map>
#include <utility>

#include "coverage/steps.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

using coverage_steps::across;

constexpr double kSameLength = 1e-12;  // relative; sums of a million lengths keep it

/// What the choice of a polygon needs to know.
class Chooser {
 public:
  Chooser(const Coverage& coverage, CoveragePolicy policy)
      : coverage_(coverage),
        policy_(policy),
        areas_(polygon_areas(coverage)),
        edges_(coverage_steps::edges_of_faces(coverage.complex)) {
    for (std::size_t f = 0; f < coverage.owners.size(); ++f) {
      owners_.emplace_back(coverage.owners[f].begin(), coverage.owners[f].end());
    }
  }

  /// Of these polygons, which ascend.
  RegionId best_of(FaceId face, const std::vector<RegionId>& polygons) const {
    const auto by_area = [this](RegionId a, RegionId b) { return areas_[a] < areas_[b]; };
    switch (policy_) {
      case CoveragePolicy::LongestBorder:
        return of_longest_border(face, polygons);
      case CoveragePolicy::Largest:
        return *std::max_element(polygons.begin(), polygons.end(), by_area);
      case CoveragePolicy::Smallest:
        return *std::min_element(polygons.begin(), polygons.end(), by_area);
      case CoveragePolicy::First:
        break;
    }
    return polygons.front();
  }

  void give(FaceId face, RegionId to) { owners_[face] = {to}; }

  Lists<RegionId> owners() const {
    Lists<RegionId> result;
    for (const auto& of : owners_) result.push_back(of);
    return result;
  }

 private:
  RegionId of_longest_border(FaceId face, const std::vector<RegionId>& polygons) const {
    std::map<RegionId, double> borders;
    for (const EdgeId e : edges_[face]) {
      const double length = coverage_steps::length(coverage_.complex, e);
      for (const RegionId r : owners_[across(coverage_.complex, e, face)]) borders[r] += length;
    }
    RegionId best = polygons.front();
    for (const RegionId r : polygons) {
      const bool is_longer = borders[r] > borders[best] * (1 + kSameLength);
      const bool is_as_long = borders[r] * (1 + kSameLength) >= borders[best];
      if (is_longer || (is_as_long && areas_[r] > areas_[best])) best = r;
    }
    return best;
  }

  const Coverage& coverage_;
  CoveragePolicy policy_;
  std::vector<Rational> areas_;
  Lists<EdgeId> edges_;
  std::vector<std::vector<RegionId>> owners_;  ///< per face, as of now
};

std::vector<RegionId> without_faces(const Lists<RegionId>& owners, std::size_t polygon_count) {
  std::vector<bool> has_face(polygon_count);
  for (const RegionId r : owners.flat()) has_face[r] = true;
  std::vector<RegionId> result;
  for (std::size_t r = 0; r < polygon_count; ++r) {
    if (!has_face[r]) result.emplace_back(r);
  }
  return result;
}

}  // namespace

std::string to_text(CoveragePolicy policy) {
  return std::string(kCoveragePolicies[static_cast<std::size_t>(policy)]);
}

CoveragePolicy coverage_policy(std::string_view word) {
  const auto found = std::find(std::begin(kCoveragePolicies), std::end(kCoveragePolicies), word);
  if (found == std::end(kCoveragePolicies)) {
    throw Error(ErrorCode::BadInput, "a policy is one of longest-border, largest, smallest, first",
                {}, std::string(word));
  }
  return static_cast<CoveragePolicy>(found - std::begin(kCoveragePolicies));
}

CleanCoverage cleaned(const Coverage& coverage, const SegmentSet& input,
                      const std::vector<CoverageFault>& faults, const CleanOptions& options) {
  CleanCoverage result;
  Chooser chooser(coverage, options.policy);
  const auto give = [&](CoverageFaultKind kind) {
    const std::size_t first = result.changes.size();
    for (const CoverageFault& fault : faults) {
      if (fault.kind != kind || !is_within(fault, options)) continue;
      result.changes.push_back({fault, chooser.best_of(fault.face, fault.polygons)});
    }
    for (std::size_t i = first; i < result.changes.size(); ++i) {
      chooser.give(result.changes[i].fault.face, result.changes[i].to);
    }
  };
  give(CoverageFaultKind::Overlap);
  give(CoverageFaultKind::Gap);
  const Lists<RegionId> owners = chooser.owners();
  result.coverage = coverage_steps::straightened(
      coverage_steps::by_owners(coverage.complex, owners, coverage.polygons), input);
  const std::vector<RegionId> before = without_faces(coverage.owners, coverage.polygons.size());
  const std::vector<RegionId> after = without_faces(owners, coverage.polygons.size());
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(),
                      std::back_inserter(result.vanished));
  return result;
}

}  // namespace plumbline
