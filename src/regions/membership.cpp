// What is known of a face, from neighbour to neighbour.

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "plumbline/error.hpp"
#include "plumbline/regions.hpp"

namespace plumbline {
namespace {

/// A step of SplitMix64 (Steele, Lea and Flood 2014): numbers that look random.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

/// Per face those that are told from it.
Lists<FaceId> told_from(const LabelledComplex& labelled) {
  std::vector<std::vector<FaceId>> found(labelled.from.size());
  for (const FaceId f : labelled.order) {
    if (labelled.from[f].valid()) found[labelled.from[f]].push_back(f);
  }
  Lists<FaceId> result;
  for (const auto& of : found) result.push_back(of);
  return result;
}

}  // namespace

std::string to_text(FillRule rule) {
  switch (rule) {
    case FillRule::EvenOdd:
      return "evenodd";
    case FillRule::NonZero:
      return "nonzero";
    case FillRule::Positive:
      return "positive";
    case FillRule::Negative:
      break;
  }
  return "negative";
}

Membership::Membership(const LabelledComplex& labelled)
    : labelled_(&labelled), winding_(labelled.regions.size()) {
  std::map<std::string, std::uint32_t> numbers;
  for (const Region& region : labelled.regions) {
    const auto [found, is_new] =
        numbers.try_emplace(region.name, static_cast<std::uint32_t>(names_.size()));
    if (is_new) names_.push_back(region.name);
    name_of_.push_back(found->second);
  }
  name_count_.resize(names_.size());
}

void Membership::apply(std::span<const WindingChange> changes, int sign) {
  for (const auto& [region, by] : changes) {
    const bool was = contains(region);
    winding_[region] += std::int64_t{sign} * by;
    const bool is = contains(region);
    if (was == is) continue;
    const std::size_t step = is ? 1 : std::size_t(-1);
    count_ += step;
    name_count_[name_of_[region]] += step;
    key_.first ^= mixed(2 * region);
    key_.second ^= mixed(2 * region + 1);
  }
}

void for_each_face(const LabelledComplex& labelled,
                   const std::function<void(FaceId, const Membership&)>& visit) {
  const Lists<FaceId> children = told_from(labelled);
  Membership membership(labelled);
  struct Open {
    FaceId face;
    std::size_t next = 0;  ///< of its children
  };
  std::vector<Open> path;
  const auto enter = [&](FaceId f) {
    membership.apply(labelled.changes[f], 1);
    visit(f, membership);
    path.push_back({f});
  };
  enter(kUnbounded);
  while (!path.empty()) {
    const auto of = children[path.back().face];
    if (path.back().next < of.size()) {
      enter(of[path.back().next++]);
    } else {
      membership.apply(labelled.changes[path.back().face], -1);
      path.pop_back();
    }
  }
}

Lists<RegionId> regions_of_faces(const LabelledComplex& labelled) {
  std::vector<std::vector<RegionId>> found(labelled.from.size());
  for_each_face(labelled, [&](FaceId f, const Membership& membership) {
    std::vector<RegionId> inside;
    if (labelled.from[f].valid()) inside = found[labelled.from[f]];
    for (const auto& [region, by] : labelled.changes[f]) {
      const auto place = std::lower_bound(inside.begin(), inside.end(), region);
      const bool was = place != inside.end() && *place == region;
      if (membership.contains(region) == was) continue;
      if (was) {
        inside.erase(place);
      } else {
        inside.insert(place, region);
      }
    }
    found[f] = std::move(inside);
  });
  Lists<RegionId> result;
  for (const auto& of : found) result.push_back(of);
  return result;
}

FaceSet select(const LabelledComplex& labelled,
               const std::function<bool(const Membership&)>& predicate) {
  FaceSet result(labelled.from.size());
  for_each_face(labelled, [&](FaceId f, const Membership& m) { result[f] = predicate(m); });
  return result;
}

}  // namespace plumbline
