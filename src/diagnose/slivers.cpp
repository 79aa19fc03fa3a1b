// Thin and long faces: 2 A <= d P and P^2 >= 40 A, for area A, perimeter P and search distance d.

#include <algorithm>
#include <cmath>

#include "diagnose/steps.hpp"

namespace plumbline::diagnose_steps {
namespace {

// P^2 / (4 A), the ratio of a long rectangle's sides; 4 for a square, pi for a disc.
constexpr int kLeastElongation = 10;
// What lengths and areas in doubles may be off by, relatively, to be believed.
constexpr double kRoughMargin = 1e-6;

/// The edges that bound a face, antennas left out.
std::vector<EdgeId> boundary(const ExactComplex& complex, FaceId f) {
  std::vector<EdgeId> edges;
  const auto add = [&](CycleId cycle) {
    for (const HalfedgeId h : complex.cycles[cycle]) {
      if (!complex.is_antenna(edge_of(h))) edges.push_back(edge_of(h));
    }
  };
  add(complex.face_outer[f]);
  for (const CycleId hole : complex.face_holes[f]) add(hole);
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Whether it is out of question that the face is a sliver; only then true.
bool is_clearly_none(const LineGraph& graph, const std::vector<EdgeId>& edges, double area,
                     double within) {
  double perimeter = 0;
  for (const EdgeId e : edges) perimeter += graph.approx_length(e);
  const double off = 2 * graph.slack() * static_cast<double>(edges.size());
  const double longest = (perimeter + off) * (1 + kRoughMargin);
  return 2 * area * (1 - kRoughMargin) > within * longest ||
         longest * longest < 4 * kLeastElongation * area * (1 - kRoughMargin);
}

/// Compares sums of roots with rational numbers: P with 2 A / d, and P sqrt(40 A) with 40 A.
bool is_sliver(const LineGraph& graph, const std::vector<EdgeId>& edges, const Rational& area,
               const Rational& within) {
  const Rational least_square = 4 * kLeastElongation * area;
  Roots perimeter, scaled;
  for (const EdgeId e : edges) {
    const Rational squared = graph.squared_length(e);
    perimeter.add(squared);
    scaled.add(squared * least_square);
  }
  return perimeter.compare(2 * area / within) >= 0 && scaled.compare(least_square) >= 0;
}

}  // namespace

Defects slivers(const Subject& subject) {
  Defects result(subject.most_listed);
  if (sgn(subject.within) == 0) return result;
  const ExactComplex& complex = subject.graph.complex();
  const std::vector<Rational> areas = face_areas(complex);
  const double within = nearest_double(subject.within);
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    std::vector<EdgeId> edges = boundary(complex, FaceId(f));
    const double area = nearest_double(areas[f]);
    if (is_clearly_none(subject.graph, edges, area, within)) continue;
    if (!is_sliver(subject.graph, edges, areas[f], subject.within)) continue;
    Defect defect;
    defect.kind = DefectKind::Sliver;
    defect.where = interior_point(complex, FaceId(f));
    defect.area = areas[f];
    defect.size = 2 * area / subject.graph.length({VertexId(), VertexId(), edges}).rounded();
    defect.face = FaceId(f);
    defect.segments = subject.graph.segments(edges);
    defect.edges = std::move(edges);
    result.add(std::move(defect));
  }
  return result;
}

}  // namespace plumbline::diagnose_steps
