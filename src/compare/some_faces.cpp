// A face is told by the sides that it lies to the left of.

#include "compare/some_faces.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "compare/claims.hpp"
#include "compare/near_vertices.hpp"

namespace plumbline::compare_steps {
namespace {

using VertexPairs = std::vector<std::pair<VertexId, VertexId>>;

/// Per face its halfedges, but for antennas.
std::vector<std::vector<HalfedgeId>> boundaries(const ExactComplex& complex) {
  std::vector<std::vector<HalfedgeId>> result(complex.face_count());
  for (std::size_t c = 0; c < complex.cycles.size(); ++c) {
    const FaceId face = complex.cycle_face[c];
    if (!face.valid()) continue;
    for (const HalfedgeId h : complex.cycles[c]) {
      if (!complex.is_antenna(edge_of(h))) result[face].push_back(h);
    }
  }
  return result;
}

class FaceSearch {
 public:
  FaceSearch(const ExactComplex& exact_complex, const ExactComplex& other, double tolerance)
      : claims_(claimed_by_polygons(exact_complex, other, tolerance)), other_(other) {
    const FilteredPoints points(claims_.complex.vertices), others(other.vertices);
    const NearVertices near(points);
    const Rational bound = rational_from(tolerance) * rational_from(tolerance);
    for (std::size_t v = 0; v < other.vertices.size(); ++v) {
      image_.push_back(nearest(near.proposals(others.rough(v), tolerance), VertexId(v), bound));
    }
    const auto faces = boundaries(claims_.complex);
    for (std::size_t f = 1; f < faces.size(); ++f) {
      VertexPairs sides;
      for (const HalfedgeId h : faces[f]) {
        sides.emplace_back(claims_.complex.origin(h), claims_.complex.target(h));
      }
      std::ranges::sort(sides);
      faces_.emplace(std::move(sides), claims_.face[f]);
    }
  }

  void look_for(std::size_t face, const std::vector<HalfedgeId>& boundary, Comparison& result) {
    Finding finding;
    finding.kind = CellKind::Face;
    finding.disagreement = Disagreement::Extra;
    finding.float_cells = {face};
    VertexPairs sides;
    for (const HalfedgeId h : boundary) {
      const VertexId v = other_.origin(h), w = other_.target(h);
      if (!image_[v].valid() && finding.message.empty()) {
        finding.message = "a corner of a face of the result is no vertex of the exact complex";
        finding.where = other_.vertices[v];
      }
      sides.emplace_back(image_[v], image_[w]);
    }
    std::ranges::sort(sides);
    const auto found = faces_.find(sides);
    if (finding.message.empty() && found == faces_.end()) {
      finding.message = "a face of the result is no face of the exact complex";
      if (!boundary.empty()) finding.where = other_.vertices[other_.origin(boundary.front())];
    }
    if (finding.message.empty() && !seen_.insert(found->second).second) {
      finding.message = "a face of the result is there twice";
      finding.exact_cells = {static_cast<std::size_t>(found->second)};
      finding.where = other_.vertices[other_.origin(boundary.front())];
    }
    if (finding.message.empty()) {
      ++result.matched_faces;
    } else {
      result.findings.push_back(std::move(finding));
    }
  }

 private:
  VertexId nearest(const std::vector<VertexId>& proposals, VertexId v,
                   const Rational& bound) const {
    VertexId best;
    Rational least = bound;
    for (const VertexId w : proposals) {
      const Rational distance = squared_distance(other_.vertices[v], claims_.complex.vertices[w]);
      if (distance > least || (best.valid() && distance == least && best < w)) continue;
      least = distance;
      best = w;
    }
    return best;
  }

  const Claims claims_;
  const ExactComplex& other_;
  std::vector<VertexId> image_;          ///< per vertex of the other complex the nearest one
  std::map<VertexPairs, FaceId> faces_;  ///< of the exact complex
  std::set<FaceId> seen_;
};

}  // namespace

Comparison some_faces(const ExactComplex& exact_complex, const ExactComplex& other_complex,
                      double tolerance) {
  Comparison result;
  result.tolerance = tolerance;
  result.compared = Compared::SomeFaces;
  result.float_valid = true;
  result.exact_counts = counts(exact_complex, exact_complex.vertices.size());
  result.float_counts = counts(other_complex, other_complex.vertices.size());
  FaceSearch search(exact_complex, other_complex, tolerance);
  const auto faces = boundaries(other_complex);
  for (std::size_t f = 1; f < faces.size(); ++f) search.look_for(f, faces[f], result);
  return result;
}

}  // namespace plumbline::compare_steps
