// Pairs come window by window, ascending; those that are equally near are applied to the quotient
// together, and make a step if its counts change, or are the first.

#include "plumbline/ladder.hpp"

#include <algorithm>
#include <array>

#include "ladder/near_pairs.hpp"
#include "ladder/quotient.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

// Pairs at a time, for each step that is wanted: most pairs change something.
constexpr std::size_t kPairsPerStep = 4, kLeastPairs = 1024;

class Climb {
 public:
  Climb(const ExactComplex& complex, const LadderOptions& options)
      : options_(options), pairs_(complex), quotient_(complex) {
    ladder_.vertices = quotient_.vertex_count();
    ladder_.edges = quotient_.edge_count();
    ladder_.faces = quotient_.face_count();
  }

  ToleranceLadder run() {
    const std::size_t count = std::max(kLeastPairs, kPairsPerStep * options_.max_steps);
    double end = is_done() ? 0 : pairs_.radius_of(count);
    while (!is_done() && !ends_early_) {
      const bool is_last = options_.largest_radius && end >= *options_.largest_radius;
      if (is_last) end = *options_.largest_radius;
      const auto window = pairs_.next(end, count, quotient_);
      if (!window) break;
      apply(*window);
      if (is_last && pairs_.reached() == end) break;
      end = std::max(end, 2 * pairs_.reached());
    }
    ladder_.is_complete = is_done();
    return std::move(ladder_);
  }

 private:
  /// With one vertex left nothing can change any more.
  bool is_done() const { return quotient_.vertex_count() <= 1; }

  void apply(const std::vector<NearPair>& pairs) {
    for (auto first = pairs.begin(); first != pairs.end();) {
      const auto last = std::find_if(first, pairs.end(), [&](const NearPair& pair) {
        return pair.squared_distance != first->squared_distance;
      });
      if (is_done()) return;
      if (ladder_.steps.size() >= options_.max_steps) {
        ends_early_ = true;
        return;
      }
      apply(first, last);
      first = last;
    }
  }

  /// Applies pairs that are equally near. The first one that changes the counts gives its name to
  /// the step; the first pairs of all change the graph in any case.
  template <class Iterator>
  void apply(Iterator first, Iterator last) {
    const auto before = counts();
    Iterator named = last;
    for (auto pair = first; pair != last; ++pair) {
      if (pair->edge.valid()) {
        quotient_.lead_through(pair->edge, pair->vertex);
      } else {
        quotient_.merge(pair->vertex, pair->other_vertex);
      }
      if (named == last && counts() != before) named = pair;
    }
    if (counts() == before) {
      if (!ladder_.steps.empty()) return;
      named = first;
    }
    ladder_.steps.push_back({named->squared_distance, quotient_.vertex_count(),
                             quotient_.edge_count(), quotient_.face_count(), named->vertex,
                             named->other_vertex, named->edge});
  }

  std::array<std::size_t, 3> counts() const {
    return {quotient_.vertex_count(), quotient_.edge_count(), quotient_.face_count()};
  }

  const LadderOptions& options_;
  NearPairs pairs_;
  Quotient quotient_;
  ToleranceLadder ladder_;
  bool ends_early_ = false;
};

}  // namespace

ToleranceLadder tolerance_ladder(const ExactComplex& complex, const LadderOptions& options) {
  if (options.largest_radius && !(*options.largest_radius >= 0)) {
    throw Error(ErrorCode::BadInput, "the largest radius of a ladder is negative or not a number");
  }
  return Climb(complex, options).run();
}

}  // namespace plumbline
