// Joins the cycles of a face into one. A hole's least vertex sees a lesser vertex: the one that
// bounds, on its left, the trapezoid between the edges above and below. Lesser vertices are on
// other cycles, so the bridges make a tree with the outer boundary as its root.

#include <algorithm>
#include <string>

#include "plumbline/chains.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

using Pair = std::array<VertexId, 2>;

double turn(const PointD& p, const PointD& q, const PointD& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

double squared_distance(const PointD& p, const PointD& q) {
  return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
}

bool is_between(const PointD& p, const PointD& a, const PointD& b) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool is_inside(const PointD& p, const SegmentD& s) {
  return p != s.a && p != s.b && turn(s.a, s.b, p) == 0 && is_between(p, s.a, s.b);
}

/// Whether the segments have a point in common other than a common end.
bool block(const SegmentD& s, const SegmentD& t) {
  if (is_inside(s.a, t) || is_inside(s.b, t) || is_inside(t.a, s) || is_inside(t.b, s)) return true;
  if (s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b) return false;
  const auto apart = [](double p, double q) { return (p > 0 && q < 0) || (p < 0 && q > 0); };
  return apart(turn(s.a, s.b, t.a), turn(s.a, s.b, t.b)) &&
         apart(turn(t.a, t.b, s.a), turn(t.a, t.b, s.b));
}

std::vector<CycleId> cycles_of(const FloatComplex& complex, FaceId face) {
  std::vector<CycleId> cycles;
  if (complex.face_outer[face].valid()) cycles.push_back(complex.face_outer[face]);
  for (const CycleId hole : complex.face_holes[face]) cycles.push_back(hole);
  return cycles;
}

class Bridging {
 public:
  Bridging(const FloatComplex& complex, FaceId face) : complex_(complex) {
    for (const CycleId c : cycles_of(complex, face)) {
      for (const HalfedgeId h : complex.cycles[c]) {
        vertices_.push_back(complex.origin(h));
        walls_.push_back(
            {complex.vertices[complex.origin(h)], complex.vertices[complex.target(h)]});
      }
    }
    // Vertices are numbered in lexicographic order.
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  }

  void join(CycleId hole) {
    VertexId least = complex_.origin(complex_.cycles[hole].front());
    for (const HalfedgeId h : complex_.cycles[hole]) least = std::min(least, complex_.origin(h));
    const VertexId seen = nearest_seen_from(least);
    bridges_.push_back({seen, least});
    walls_.push_back({complex_.vertices[seen], complex_.vertices[least]});
  }

  std::vector<Pair> take() { return std::move(bridges_); }

 private:
  VertexId nearest_seen_from(VertexId v) const {
    const PointD& from = complex_.vertices[v];
    std::vector<std::pair<double, VertexId>> lesser;
    for (const VertexId w : vertices_) {
      if (w >= v) break;
      lesser.emplace_back(squared_distance(from, complex_.vertices[w]), w);
    }
    std::sort(lesser.begin(), lesser.end());
    for (const auto& [distance, w] : lesser) {
      const SegmentD bridge{complex_.vertices[w], from};
      const bool is_seen = std::none_of(walls_.begin(), walls_.end(),
                                        [&](const SegmentD& wall) { return block(bridge, wall); });
      if (is_seen) return w;
    }
    throw Error(ErrorCode::BadInput,
                "a hole cannot be joined to its face: the complex is not valid");
  }

  const FloatComplex& complex_;
  std::vector<VertexId> vertices_;  ///< of the face, ascending
  std::vector<SegmentD> walls_;     ///< the face's edges and the bridges so far
  std::vector<Pair> bridges_;
};

void check(const FloatComplex& complex, FaceId face) {
  if (face != kUnbounded && face < complex.face_count()) return;
  throw Error(ErrorCode::BadInput, "bridges join the cycles of a bounded face", {},
              std::to_string(std::size_t{face}));
}

}  // namespace

std::vector<std::array<VertexId, 2>> bridge_edges(const FloatComplex& complex, FaceId face) {
  check(complex, face);
  const auto least = [&](CycleId c) {
    VertexId result = complex.origin(complex.cycles[c].front());
    for (const HalfedgeId h : complex.cycles[c]) result = std::min(result, complex.origin(h));
    return result;
  };
  std::vector<std::pair<VertexId, CycleId>> holes;
  for (const CycleId c : complex.face_holes[face]) holes.emplace_back(least(c), c);
  std::sort(holes.begin(), holes.end());
  Bridging bridging(complex, face);
  for (const auto& [vertex, hole] : holes) bridging.join(hole);
  return bridging.take();
}

}  // namespace plumbline
