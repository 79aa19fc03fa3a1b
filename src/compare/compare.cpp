// The comparison: validity of the float result by itself, then the correspondence, step by step.

#include "plumbline/compare.hpp"

#include <algorithm>
#include <iterator>

#include "compare/claims.hpp"
#include "compare/some_faces.hpp"
#include "compare/steps.hpp"
#include "compare/wrong_cells.hpp"

namespace plumbline {
namespace {

std::size_t matched(const auto& matches) {
  return static_cast<std::size_t>(
      std::count_if(matches.begin(), matches.end(), [](auto id) { return id.valid(); }));
}

/// The doubles as the rationals that they are, in the canonical order that they are in already.
ExactComplex exact_in_order(const FloatComplex& complex) {
  ExactComplex result;
  static_cast<Incidences&>(result) = complex;
  result.vertices.reserve(complex.vertices.size());
  for (const PointD& p : complex.vertices) result.vertices.push_back(exact(p));
  return result;
}

using compare_steps::Detail;

Comparison compare_in(Detail detail, const ExactComplex& exact_complex,
                      const ExactComplex& other_complex, double tolerance, Compared compared) {
  const compare_steps::Sides sides =
      compare_steps::make_sides(exact_complex, other_complex, tolerance);
  Comparison result;
  result.tolerance = tolerance;
  result.compared = compared;
  result.exact_counts = counts(exact_complex, exact_complex.vertices.size());
  result.float_counts = counts(other_complex, other_complex.vertices.size());
  const auto append = [&](std::vector<Finding> findings) {
    result.findings.reserve(result.findings.size() + findings.size());
    std::move(findings.begin(), findings.end(), std::back_inserter(result.findings));
  };
  const auto next_number = [&] { return result.findings.size() + 1; };

  append(compare_steps::invalidities(sides, compared));
  result.float_valid = result.findings.empty();
  if (compared == Compared::All && detail == Detail::Full) {
    append(compare_steps::miscoverings(sides, result.findings));
  }
  compare_steps::VertexMatch vertices = compare_steps::match_vertices(sides, next_number(), detail);
  append(std::move(vertices.findings));
  compare_steps::EdgeMatch edges =
      compare_steps::match_edges(sides, vertices, next_number(), detail);
  append(std::move(edges.findings));
  result.matched_vertices = matched(vertices.match[compare_steps::Exact]) - vertices.moved_count;
  result.matched_edges = matched(edges.match[compare_steps::Exact]);
  result.largest_displacement = nearest_sqrt(vertices.largest_squared);
  if (compared == Compared::Graph) return result;

  const compare_steps::CycleMatch cycles = compare_steps::match_cycles(sides, edges);
  compare_steps::FaceMatch faces =
      compare_steps::match_faces(sides, vertices, edges, cycles, result.float_valid, detail);
  append(std::move(faces.findings));
  if (detail != Detail::ExactCellsOnly) {
    append(compare_steps::nesting(sides, vertices, edges, cycles, faces));
  }
  result.matched_faces = faces.same;
  return result;
}

/// Without a result: no findings.
Comparison compare_nothing(const ExactComplex& exact_complex, const ExactComplex& other_complex,
                           double tolerance) {
  Comparison result;
  result.tolerance = tolerance;
  result.compared = Compared::Nothing;
  result.exact_counts = counts(exact_complex, exact_complex.vertices.size());
  result.float_counts = counts(other_complex, other_complex.vertices.size());
  result.float_valid = true;
  return result;
}

Comparison compare_faces(const ExactComplex& exact_complex, const ExactComplex& other_complex,
                         double tolerance) {
  const compare_steps::Claims claims =
      compare_steps::claimed_by_polygons(exact_complex, other_complex, tolerance);
  Comparison result =
      compare_in(Detail::Full, claims.complex, other_complex, tolerance, Compared::All);
  for (Finding& finding : result.findings) finding = claims.of_whole(std::move(finding));
  result.compared = Compared::Faces;
  result.edges_left_out = claims.edges_left_out;
  result.vertices_left_out = claims.vertices_left_out;
  result.exact_counts = counts(exact_complex, exact_complex.vertices.size());
  return result;
}

}  // namespace

Comparison compare(const ExactComplex& exact_complex, const FloatComplex& float_complex,
                   double tolerance) {
  return compare(exact_complex, exact_in_order(float_complex), tolerance);
}

Comparison compare(const ExactComplex& exact_complex, const ExactComplex& other_complex,
                   double tolerance, Compared compared) {
  if (compared == Compared::SomeFaces) {
    return compare_steps::some_faces(exact_complex, other_complex, tolerance);
  }
  if (compared == Compared::Faces) return compare_faces(exact_complex, other_complex, tolerance);
  if (compared == Compared::Nothing) {
    return compare_nothing(exact_complex, other_complex, tolerance);
  }
  return compare_in(Detail::Full, exact_complex, other_complex, tolerance, compared);
}

Comparison compare_steps::compare_cells(const ExactComplex& exact_complex,
                                        const ExactComplex& other_complex, double tolerance,
                                        bool with_correspondence) {
  // Isolated vertices have findings about the faces that they lie in.
  const bool all = with_correspondence || !exact_complex.face_isolated_vertices.flat().empty();
  return compare_in(all ? Detail::CellsOnly : Detail::ExactCellsOnly, exact_complex, other_complex,
                    tolerance, Compared::All);
}

Comparison compare_steps::compare_cells(const ExactComplex& exact_complex,
                                        const FloatComplex& float_complex, double tolerance,
                                        bool with_correspondence) {
  return compare_cells(exact_complex, exact_in_order(float_complex), tolerance,
                       with_correspondence);
}

}  // namespace plumbline
