// A line between two places of one cycle splits it in two; both parts have areas, by the shoelace
// formula. One between two cycles splits nothing.

#include "diagnose/closings.hpp"

#include <algorithm>

#include "geometry/point_d.hpp"

namespace plumbline::diagnose_steps {
namespace {

double cross(const PointD& p, const PointD& q) { return p.x * q.y - p.y * q.x; }

}  // namespace

Closings::Closings(const LineGraph& graph) : graph_(graph) {
  const ExactComplex& complex = graph.complex();
  cycle_.resize(2 * complex.edge_count());
  before_.resize(cycle_.size());
  place_.resize(cycle_.size());
  for (std::size_t c = 0; c < complex.cycles.size(); ++c) {
    double sum = 0;
    std::uint32_t place = 0;
    for (const HalfedgeId h : complex.cycles[c]) {
      cycle_[h] = CycleId(c);
      before_[h] = sum;
      place_[h] = place++;
      sum += cross(at(complex.origin(h)), at(complex.target(h)));
    }
    whole_.push_back(sum);
  }
}

/// Relative to the first vertex, so that areas far from the origin are good.
PointD Closings::at(VertexId v) const {
  const PointD &p = graph_.rounded(v), &o = graph_.rounded(VertexId(0));
  return {p.x - o.x, p.y - o.y};
}

HalfedgeId Closings::leaving(VertexId tip) const {
  const EdgeId e = graph_.edges(tip)[0];
  return halfedge(e, graph_.complex().edges[e].tail != tip);
}

std::optional<double> Closings::between(VertexId tip, VertexId other) const {
  return closed(leaving(tip), leaving(other), at(other));
}

std::optional<double> Closings::to_edge(VertexId tip, EdgeId e) const {
  const Edge& edge = graph_.complex().edges[e];
  const PointD p = at(tip), a = at(edge.tail), b = at(edge.head);
  const PointD u{b.x - a.x, b.y - a.y}, off{p.x - a.x, p.y - a.y};
  const double squared = u.x * u.x + u.y * u.y;
  const double along =
      squared == 0 ? 0 : std::clamp((off.x * u.x + off.y * u.y) / squared, 0.0, 1.0);
  const bool is_left = cross(u, off) > 0;
  return closed(leaving(tip), halfedge(e, !is_left), {a.x + along * u.x, a.y + along * u.y});
}

/// Of the line from the origin of `from` to a point of `to`.
std::optional<double> Closings::closed(HalfedgeId from, HalfedgeId to, const PointD& end) const {
  if (cycle_[from] != cycle_[to]) return std::nullopt;
  const ExactComplex& complex = graph_.complex();
  const PointD start = at(complex.origin(from));
  const double whole = whole_[cycle_[from]];
  double part = before_[to] - before_[from];
  if (place_[to] < place_[from]) part += whole;
  part += cross(at(complex.origin(to)), end) + cross(end, start);
  // A part that is negative is a face around the cycle.
  std::optional<double> least;
  for (const double area : {part / 2, (whole - part) / 2}) {
    if (area > 0 && (!least || area < *least)) least = area;
  }
  return least;
}

}  // namespace plumbline::diagnose_steps
