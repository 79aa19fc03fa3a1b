// Two layers of polygons, laid over each other.

#include "plumbline/overlay.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "plumbline/arrange.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

using Set = std::span<const RegionId>;

/// How many of a set, which ascends, are of the first layer.
std::size_t count_of_first(Set set, std::size_t first_count) {
  return static_cast<std::size_t>(std::lower_bound(set.begin(), set.end(), RegionId(first_count)) -
                                  set.begin());
}

bool stays(OverlayHow how, bool is_in_first, bool is_in_second) {
  switch (how) {
    case OverlayHow::Intersection:
      return is_in_first && is_in_second;
    case OverlayHow::Union:
      return is_in_first || is_in_second;
    case OverlayHow::Difference:
      return is_in_first && !is_in_second;
    case OverlayHow::SymmetricDifference:
      return is_in_first != is_in_second;
    case OverlayHow::Identity:
      break;
  }
  return is_in_first;
}

/// Per face the number of its set of polygons among those that stay, from 1; 0 for the others.
std::vector<std::uint32_t> classes_of(const Lists<RegionId>& sets, OverlayHow how,
                                      std::size_t first_count) {
  std::map<std::vector<RegionId>, std::uint32_t> numbers;
  std::vector<std::uint32_t> result;
  for (std::size_t f = 0; f < sets.size(); ++f) {
    const Set set = sets[f];
    const std::size_t of_first = count_of_first(set, first_count);
    if (!stays(how, of_first > 0, of_first < set.size())) {
      result.push_back(0);
      continue;
    }
    const auto number = static_cast<std::uint32_t>(numbers.size() + 1);
    result.push_back(numbers.try_emplace({set.begin(), set.end()}, number).first->second);
  }
  return result;
}

/// Of the joined complex, by the first face of each.
std::vector<Piece> pieces_of(const JoinedComplex& made, const Lists<RegionId>& sets,
                             const std::vector<std::uint32_t>& classes, std::size_t first_count) {
  std::vector<std::uint32_t> class_of(made.complex.face_count());
  std::vector<FaceId> origin(made.complex.face_count());
  for (std::size_t f = 0; f < classes.size(); ++f) {
    class_of[made.face_of[f]] = classes[f];
    origin[made.face_of[f]] = FaceId(f);
  }
  const std::vector<Rational> areas = face_areas(made.complex);
  std::map<std::uint32_t, std::size_t> place;  // in `result`, by class
  std::vector<Piece> result;
  for (std::size_t f = 1; f < class_of.size(); ++f) {
    if (class_of[f] == 0) continue;
    const auto [found, is_new] = place.try_emplace(class_of[f], result.size());
    if (is_new) {
      const Set set = sets[origin[f]];
      const auto middle =
          set.begin() + static_cast<std::ptrdiff_t>(count_of_first(set, first_count));
      result.push_back({{set.begin(), middle}, {middle, set.end()}, {}, 0});
    }
    Piece& piece = result[found->second];
    piece.faces.emplace_back(f);
    piece.area += areas[f];
  }
  return result;
}

std::vector<SegmentId> of_none(const std::vector<Region>& regions, std::size_t segments) {
  std::vector<bool> is_taken(segments);
  for (const Region& region : regions) {
    for (const SegmentId s : region.segments) is_taken[s] = true;
  }
  std::vector<SegmentId> result;
  for (std::size_t s = 0; s < segments; ++s) {
    if (!is_taken[s]) result.emplace_back(s);
  }
  return result;
}

}  // namespace

std::string to_text(OverlayHow how) {
  return std::string(kOverlayHows[static_cast<std::size_t>(how)]);
}

OverlayHow overlay_how(std::string_view word) {
  const auto found = std::find(std::begin(kOverlayHows), std::end(kOverlayHows), word);
  if (found == std::end(kOverlayHows)) {
    throw Error(ErrorCode::BadInput,
                "an overlay is one of intersection, union, difference, symmetric_difference, "
                "identity",
                {}, std::string(word));
  }
  return static_cast<OverlayHow>(found - std::begin(kOverlayHows));
}

Rational Overlay::area() const {
  Rational sum = 0;
  for (const Piece& piece : pieces) sum += piece.area;
  return sum;
}

Overlay overlay(SegmentSet first, const SegmentSet& second, OverlayHow how, FillRule rule,
                std::size_t threads) {
  Overlay result;
  result.first_count = regions(first, RegionKind::Polygon, rule).size();
  result.input = together(std::move(first), second);
  result.regions = regions(result.input, RegionKind::Polygon, rule);
  result.open = of_none(result.regions, result.input.segments.size());
  ArrangeOptions options;
  options.threads = threads;
  const ExactComplex complex = arrange(result.input, ExactEngine::Bucket, options);
  const LabelledComplex labelled = label(result.input, complex, result.regions);
  const Lists<RegionId> sets = regions_of_faces(labelled);
  const std::vector<std::uint32_t> classes = classes_of(sets, how, result.first_count);
  JoinedComplex made = joined(complex, classes);
  result.pieces = pieces_of(made, sets, classes, result.first_count);
  result.complex = std::move(made.complex);
  return result;
}

}  // namespace plumbline
