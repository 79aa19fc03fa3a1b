// Edges that leave a vertex in nearly the same direction: successive ones of a cycle, since those
// are neighbours in the order around the vertex. Where they end near each other, the end of the
// shorter one has its name: a near-miss, or what a loose end is.

#include <cmath>
#include <set>

#include "diagnose/steps.hpp"

namespace plumbline::diagnose_steps {
namespace {

// Squared sine of the largest angle.
const Rational& most_squared_sine() {
  static const Rational value(1, 10'000);
  return value;
}
constexpr double kMostSine = 0.01, kAngleMargin = 1e-3;

struct Direction {
  Rational x, y;
};

Direction from(const LineGraph& graph, VertexId v, EdgeId e) {
  const auto& vertices = graph.complex().vertices;
  const Point &p = vertices[v], &q = vertices[graph.other_end(e, v)];
  return {q.x - p.x, q.y - p.y};
}

/// Whether it is out of question that the angle is small; only then true.
bool is_clearly_wide(const LineGraph& graph, VertexId v, EdgeId e, EdgeId f) {
  const PointD &o = graph.rounded(v), &p = graph.rounded(graph.other_end(e, v)),
               &q = graph.rounded(graph.other_end(f, v));
  const double ux = p.x - o.x, uy = p.y - o.y, wx = q.x - o.x, wy = q.y - o.y;
  const double u = std::hypot(ux, uy), w = std::hypot(wx, wy);
  if (std::min(u, w) * kAngleMargin * kMostSine < graph.slack()) return false;
  return (ux / u) * (wx / w) + (uy / u) * (wy / w) < 0 ||
         std::abs((ux / u) * (wy / w) - (uy / u) * (wx / w)) > kMostSine * (1 + kAngleMargin);
}

/// A line through a vertex: dy / dx in lowest terms, 1 / 0 for an upright one.
using Slope = std::pair<mpz_class, mpz_class>;
Slope slope(const Direction& u) {
  if (sgn(u.x) == 0) return {1, 0};
  const Rational ratio = u.y / u.x;
  return {ratio.get_num(), ratio.get_den()};
}

class Angles {
 public:
  explicit Angles(const Subject& subject)
      : subject_(subject), graph_(subject.graph), result_(subject.most_listed) {}

  Defects find() && {
    const ExactComplex& complex = graph_.complex();
    for (std::size_t c = 0; c < complex.cycles.size(); ++c) {
      const auto cycle = complex.cycles[c];
      for (std::size_t i = 0; i < cycle.size(); ++i) {
        const HalfedgeId h = cycle[i], next = cycle[(i + 1) % cycle.size()];
        look_at(complex.target(h), edge_of(h), edge_of(next));
      }
    }
    return std::move(result_);
  }

 private:
  void look_at(VertexId v, EdgeId e, EdgeId f) {
    if (e == f) return;
    std::optional<Rational> squared = nearly_parallel(graph_, v, e, f);
    if (!squared) return;
    const Rational depart = *squared * std::min(graph_.squared_length(e), graph_.squared_length(f));
    if (depart <= subject_.squared_within) return;
    // Lines that cross have the angle on both sides.
    const Direction u = from(graph_, v, e), w = from(graph_, v, f);
    if (!seen_.emplace(v, std::minmax(slope(u), slope(w))).second) return;
    add(v, std::min(e, f), std::max(e, f), *std::move(squared));
  }

  void add(VertexId v, EdgeId e, EdgeId f, Rational squared_sine) {
    Defect defect;
    defect.kind = DefectKind::NearlyParallel;
    defect.where = graph_.complex().vertices[v];
    defect.size = nearest_sqrt(squared_sine);
    defect.squared_size = std::move(squared_sine);
    defect.vertices = {v};
    defect.edges = {e, f};
    defect.segments = graph_.segments(defect.edges);
    result_.add(std::move(defect));
  }

  const Subject& subject_;
  const LineGraph& graph_;
  Defects result_;
  std::set<std::pair<VertexId, std::pair<Slope, Slope>>> seen_;
};

}  // namespace

std::optional<Rational> nearly_parallel(const LineGraph& graph, VertexId v, EdgeId e, EdgeId f) {
  if (is_clearly_wide(graph, v, e, f)) return std::nullopt;
  const Direction u = from(graph, v, e), w = from(graph, v, f);
  if (sgn(Rational(u.x * w.x + u.y * w.y)) < 0) return std::nullopt;
  const Rational cross = u.x * w.y - u.y * w.x;
  Rational squared = cross * cross / Rational((u.x * u.x + u.y * u.y) * (w.x * w.x + w.y * w.y));
  if (squared > most_squared_sine()) return std::nullopt;
  return squared;
}

Defects nearly_parallel_edges(const Subject& subject) { return Angles(subject).find(); }

}  // namespace plumbline::diagnose_steps
