#include <algorithm>
#include <array>

#include "plumbline/arrange.hpp"
#include "plumbline/engine.hpp"

namespace plumbline {

LineWork rounded(const SegmentSet& input) {
  LineWork result;
  for (std::size_t i = 0; i < input.segments.size(); ++i) {
    const auto numbers = input.segments.numbers(i);
    result.segments.push_back({nearest(NumberPoint{numbers[0], numbers[1]}),
                               nearest(NumberPoint{numbers[2], numbers[3]})});
    result.sources.push_back(std::array{SegmentId(i)});
  }
  for (const Point& p : input.points) result.points.push_back(nearest(p));
  return result;
}

ExactComplex arrange(const LineWork& work, std::size_t threads) {
  SegmentSet set;
  std::vector<std::size_t> piece_of;  // of each segment of the set
  for (std::size_t i = 0; i < work.segments.size(); ++i) {
    const auto& [a, b] = work.segments[i];
    if (a == b) continue;
    set.add(a, b, SourceId{});
    piece_of.push_back(i);
  }
  for (const PointD& p : work.points) set.add_point(exact(p), SourceId{});
  ExactComplex complex = arrange(set, ExactEngine::Bucket, {threads, {}});
  Lists<SegmentId> sources;
  std::vector<SegmentId> ids;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    ids.clear();
    for (const SegmentId piece : complex.edge_sources[e]) {
      const auto of_piece = work.sources[piece_of[piece]];
      ids.insert(ids.end(), of_piece.begin(), of_piece.end());
    }
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    sources.push_back(ids);
  }
  complex.edge_sources = std::move(sources);
  return complex;
}

}  // namespace plumbline
