// A sliver is a bounded face whose border falls into two parts, each within the distance of the
// other one: a chain that parts it from one neighbour, and the rest. Without the chain it belongs
// to that neighbour.

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnose/line_graph.hpp"
#include "geometry/point_d.hpp"
#include "repair/cut.hpp"
#include "repair/gifts.hpp"
#include "repair/steps.hpp"

namespace plumbline::repair_steps {
namespace {

/// A chain of a face's border between two junctions.
struct Chain {
  std::vector<EdgeId> edges;
  FaceId neighbour;
};

/// Digits, in bits, to which lengths are compared: sums of square roots of rational numbers. What
/// does not differ within them is of one length.
constexpr unsigned kLengthBits = 512;

class Slivers {
 public:
  Slivers(const Work& work, const Arranged& arranged, const Rational& distance)
      : work_(work),
        arranged_(arranged),
        complex_(arranged.complex),
        graph_(arranged.complex),
        squared_distance_(distance * distance),
        reach_(nearest_double(distance) * (1 + 0x1p-30) + 4 * graph_.slack()) {}

  /// For each sliver what is to go, the smallest first; none of a face that receives another one.
  std::vector<Gift> find() const {
    std::vector<Gift> all;
    for (std::size_t f = 1; f < complex_.face_count(); ++f) {
      if (std::optional<Gift> gift = gift_of(FaceId(f))) all.push_back(std::move(*gift));
    }
    std::ranges::sort(all, [](const Gift& g, const Gift& h) {
      const int by_area = cmp(g.area, h.area);
      return by_area != 0 ? by_area < 0 : g.face < h.face;
    });
    std::vector<Gift> result;
    std::set<FaceId> given, receiving;
    for (Gift& gift : all) {
      if (receiving.contains(gift.face) || given.contains(gift.neighbour)) continue;
      given.insert(gift.face);
      receiving.insert(gift.neighbour);
      result.push_back(std::move(gift));
    }
    return result;
  }

 private:
  std::optional<Gift> gift_of(FaceId f) const {
    if (!complex_.face_holes[f].empty()) return std::nullopt;
    const auto border = complex_.cycles[complex_.face_outer[f]];
    if (!may_be_thin(border)) return std::nullopt;
    const std::vector<Chain> chains = chains_of(border);
    if (chains.size() < 2) return std::nullopt;
    const Chain* best = nullptr;
    Rational squared_size;
    for (const Chain& chain : chains) {
      if (chain.neighbour == kUnbounded || chain.neighbour == f) continue;
      if (is_fixed(work_, arranged_, chain.edges)) continue;
      if (best != nullptr && compare_lengths(chain, *best) <= 0) continue;
      const std::optional<Rational> size = squared_width(chain, border);
      if (!size) continue;
      best = &chain;
      squared_size = *size;
    }
    if (best == nullptr) return std::nullopt;
    return Gift{f, best->neighbour, face_area(complex_, f), squared_size, best->edges};
  }

  /// In doubles: a sliver's area is less than that of a strip as wide along half of its border.
  bool may_be_thin(std::span<const HalfedgeId> border) const {
    const PointD& origin = graph_.rounded(complex_.origin(border.front()));
    double twice_area = 0, length = 0;
    for (const HalfedgeId h : border) {
      const PointD &p = graph_.rounded(complex_.origin(h)), &q = graph_.rounded(complex_.target(h));
      twice_area += (p.x - origin.x) * (q.y - origin.y) - (q.x - origin.x) * (p.y - origin.y);
      length += distance(p, q);
    }
    return twice_area <= 2 * length * reach_ * (1 + 0x1p-20);
  }

  /// Ordered as they are met, from the first junction on.
  std::vector<Chain> chains_of(std::span<const HalfedgeId> border) const {
    std::size_t first = 0;
    while (first < border.size() && !is_junction(border[first])) ++first;
    std::vector<Chain> chains;
    if (first == border.size()) return chains;
    for (std::size_t i = 0; i < border.size(); ++i) {
      const HalfedgeId h = border[(first + i) % border.size()];
      if (is_junction(h)) chains.push_back({{}, complex_.halfedge_face[twin(h)]});
      chains.back().edges.push_back(edge_of(h));
    }
    return chains;
  }
  bool is_junction(HalfedgeId h) const { return graph_.degree(complex_.origin(h)) > 2; }

  int compare_lengths(const Chain& c, const Chain& d) const {
    mpf_class difference(0, kLengthBits);
    mpf_class scale(0, kLengthBits);
    for (const auto& [chain, sign] : {std::pair(&c, 1), std::pair(&d, -1)}) {
      for (const EdgeId e : chain->edges) {
        const mpf_class square(graph_.squared_length(e), kLengthBits);
        const mpf_class root = sqrt(square);
        difference += sign * root;
        scale += root;
      }
    }
    mpf_class least = scale;
    mpf_div_2exp(least.get_mpf_t(), least.get_mpf_t(), kLengthBits / 2);
    return abs(difference) <= least ? 0 : sgn(difference);
  }

  /// The larger of how far the vertices of the chain are from the rest of the border, and those of
  /// the rest from the chain; none where that is beyond the distance.
  std::optional<Rational> squared_width(const Chain& chain,
                                        std::span<const HalfedgeId> border) const {
    std::vector<EdgeId> rest;
    for (const HalfedgeId h : border) {
      if (!std::ranges::count(chain.edges, edge_of(h))) rest.push_back(edge_of(h));
    }
    if (!may_be_near(chain.edges, rest) || !may_be_near(rest, chain.edges)) return std::nullopt;
    const std::optional<Rational> there = squared_distance_from(chain.edges, rest);
    const std::optional<Rational> back =
        there ? squared_distance_from(rest, chain.edges) : std::nullopt;
    return back ? std::optional(std::max(*there, *back)) : std::nullopt;
  }

  /// In doubles: whether all ends of some edges are near others.
  bool may_be_near(const std::vector<EdgeId>& edges, const std::vector<EdgeId>& others) const {
    return std::ranges::all_of(edges, [&](EdgeId e) {
      const PointD &p = graph_.rounded(complex_.edges[e].tail),
                   &q = graph_.rounded(complex_.edges[e].head);
      return may_be_near(p, others) && may_be_near(q, others);
    });
  }
  bool may_be_near(const PointD& p, const std::vector<EdgeId>& edges) const {
    return std::ranges::any_of(edges, [&](EdgeId e) { return is_roughly_near(p, e); });
  }
  bool is_roughly_near(const PointD& p, EdgeId e) const {
    const PointD &a = graph_.rounded(complex_.edges[e].tail),
                 &b = graph_.rounded(complex_.edges[e].head);
    const PointD d{b.x - a.x, b.y - a.y};
    const double squared = d.x * d.x + d.y * d.y;
    const double t = squared == 0 ? 0 : ((p.x - a.x) * d.x + (p.y - a.y) * d.y) / squared;
    return distance(p, point_at({a, b}, std::clamp(t, 0.0, 1.0))) <= reach_;
  }

  /// The largest of the ends of some edges from the nearest of others.
  std::optional<Rational> squared_distance_from(const std::vector<EdgeId>& edges,
                                                const std::vector<EdgeId>& others) const {
    Rational result = 0;
    for (const EdgeId e : edges) {
      for (const VertexId v : {complex_.edges[e].tail, complex_.edges[e].head}) {
        const std::optional<Rational> found = squared_distance_from(v, others);
        if (!found) return std::nullopt;
        result = std::max(result, *found);
      }
    }
    return result;
  }

  /// None where it is beyond the distance.
  std::optional<Rational> squared_distance_from(VertexId v,
                                                const std::vector<EdgeId>& edges) const {
    std::optional<Rational> result;
    const PointD& rounded = graph_.rounded(v);
    for (const EdgeId e : edges) {
      const Edge& edge = complex_.edges[e];
      if (edge.tail == v || edge.head == v) return Rational(0);
      if (!is_roughly_near(rounded, e)) continue;
      Rational found = squared_distance(complex_.vertices[v], complex_.vertices[edge.tail],
                                        complex_.vertices[edge.head]);
      if (found <= squared_distance_ && (!result || found < *result)) result = std::move(found);
    }
    return result;
  }

  const Work& work_;
  const Arranged& arranged_;
  const ExactComplex& complex_;
  diagnose_steps::LineGraph graph_;
  Rational squared_distance_;
  double reach_;
};

}  // namespace

std::vector<Gift> gifts(const Work& work, const Arranged& arranged, const Rational& distance) {
  return Slivers(work, arranged, distance).find();
}

void give_slivers(Work& work, const Arranged& arranged, const Rational& distance) {
  for (const Gift& gift : gifts(work, arranged, distance)) {
    const Point where = interior_point(arranged.complex, gift.face);
    cut(work, arranged, gift.edges, EditKind::Sliver, where, gift.squared_size);
  }
}

}  // namespace plumbline::repair_steps
