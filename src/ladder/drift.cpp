// What the file's own digits leave open.

#include <fmt/format.h>

#include <algorithm>

#include "complex/vertex_tree.hpp"
#include "geometry/union_find.hpp"
#include "number/bound_text.hpp"
#include "plumbline/ladder.hpp"

namespace plumbline {
namespace {

/// The rounding of each edge and vertex: the largest of its segments.
struct Roundings {
  std::vector<double> edges, vertices;
  double largest = 0;

  Roundings(const SegmentSet& input, const ExactComplex& complex)
      : edges(complex.edge_count()), vertices(complex.vertices.size()) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      for (const SegmentId s : complex.edge_sources[e]) {
        edges[e] = std::max(edges[e], input.rounding[s]);
      }
      for (const VertexId v : {complex.edges[e].tail, complex.edges[e].head}) {
        vertices[v] = std::max(vertices[v], edges[e]);
      }
      largest = std::max(largest, edges[e]);
    }
  }
};

class DriftSearch {
 public:
  DriftSearch(const SegmentSet& input, const ExactComplex& complex)
      : complex_(complex),
        roundings_(input, complex),
        tree_(complex),
        places_(complex.vertices.size()),
        is_place_(complex.vertices.size()) {
    result_.bound = 2 * roundings_.largest;
  }

  Drift run() && {
    for (std::size_t v = 0; v < complex_.vertices.size(); ++v) pair_vertices(VertexId(v));
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) pair_edge(EdgeId(e));
    count_places();
    return std::move(result_);
  }

 private:
  /// Whether one more pair may be looked at.
  bool may_count() {
    if (pairs_ < kMostDrift) return true;
    result_.is_complete = false;
    return false;
  }

  bool is_pair(const Rational& squared_distance, double rounding) {
    const double distance = nearest_sqrt(squared_distance);
    if (distance >= rounding || !may_count()) return false;
    ++pairs_;
    result_.largest = std::max(result_.largest, distance);
    return true;
  }

  void pair_vertices(VertexId v) {
    const double rounding = roundings_.vertices[v];
    if (rounding == 0 || !may_count()) return;
    tree_.visit(v, v, tree_.above(rounding + roundings_.largest), [&](VertexId w, double) {
      // Of two that are rounded the first one finds the pair.
      if (w == v || (w < v && roundings_.vertices[w] > 0)) return;
      if (!is_pair(squared_distance(complex_.vertices[v], complex_.vertices[w]),
                   rounding + roundings_.vertices[w])) {
        return;
      }
      is_place_[v] = is_place_[w] = true;
      places_.unite(v, w);
    });
  }

  void pair_edge(EdgeId e) {
    const auto [tail, head] = complex_.edges[e];
    if (places_.find(tail) == places_.find(head) || !may_count()) return;
    std::vector<VertexId> found;
    tree_.visit_between(tail, head, tree_.above(roundings_.edges[e] + roundings_.largest), false,
                        [&](VertexId v, double) { found.push_back(v); });
    std::sort(found.begin(), found.end());
    for (const VertexId v : found) {
      const std::size_t place = places_.find(v);
      if (place == places_.find(tail) || place == places_.find(head)) continue;
      const Rational squared =
          squared_distance(complex_.vertices[v], complex_.vertices[tail], complex_.vertices[head]);
      if (!is_pair(squared, roundings_.edges[e] + roundings_.vertices[v])) continue;
      is_place_[v] = true;
      result_.beside.emplace_back(e, v);
    }
  }

  void count_places() {
    if (pairs_ == 0) return;
    std::vector<VertexId>& sharpest = result_.stands_for;
    sharpest.resize(complex_.vertices.size());
    std::vector<bool> is_counted(sharpest.size());
    for (std::size_t v = 0; v < sharpest.size(); ++v) {
      const std::size_t place = places_.find(v);
      if (is_place_[v] && !is_counted[place]) ++result_.places;
      if (is_place_[v]) is_counted[place] = true;
      VertexId& best = sharpest[place];
      if (!best.valid() || roundings_.vertices[v] < roundings_.vertices[best]) best = VertexId(v);
    }
    for (std::size_t v = sharpest.size(); v-- > 0;) sharpest[v] = sharpest[places_.find(v)];
  }

  const ExactComplex& complex_;
  Roundings roundings_;
  VertexTree tree_;
  UnionFind places_;  ///< of vertices
  std::vector<bool> is_place_;
  std::size_t pairs_ = 0;
  Drift result_;
};

}  // namespace

Drift drift(const SegmentSet& input, const ExactComplex& complex) {
  const auto& roundings = input.rounding;
  const bool is_rounded =
      std::any_of(roundings.begin(), roundings.end(), [](double rounding) { return rounding > 0; });
  if (!is_rounded) return {};
  return DriftSearch(input, complex).run();
}

std::string to_text(const Drift& drift) {
  if (drift.places == 0) return {};
  return fmt::format("printed doubles: {}{} place{}, at most {} apart",
                     drift.is_complete ? "" : "at least ", drift.places,
                     drift.places == 1 ? "" : "s", bound_text(drift.largest));
}

}  // namespace plumbline
