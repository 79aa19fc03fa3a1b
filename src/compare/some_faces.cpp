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

/// Per face the antennas that its cycles run along.
std::vector<std::vector<EdgeId>> antennas(const ExactComplex& complex) {
  std::vector<std::vector<EdgeId>> result(complex.face_count());
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const FaceId face = complex.halfedge_face[halfedge(EdgeId(e), false)];
    if (complex.is_antenna(EdgeId(e))) result[face].emplace_back(e);
  }
  return result;
}

/// The vertices of a complex nearest to those of another one, within a tolerance.
class Images {
 public:
  Images(const ExactComplex& complex, const ExactComplex& other, double tolerance) {
    const FilteredPoints points(complex.vertices), others(other.vertices);
    const NearVertices near(points);
    const Rational bound = rational_from(tolerance) * rational_from(tolerance);
    for (std::size_t v = 0; v < other.vertices.size(); ++v) {
      VertexId best;
      Rational least = bound;
      for (const VertexId w : near.proposals(others.rough(v), tolerance)) {
        const Rational distance = squared_distance(other.vertices[v], complex.vertices[w]);
        if (distance > least || (best.valid() && distance == least && best < w)) continue;
        least = distance;
        best = w;
      }
      image_.push_back(best);
    }
  }
  VertexId operator[](VertexId v) const { return image_[v]; }

 private:
  std::vector<VertexId> image_;
};

class FaceSearch {
 public:
  FaceSearch(const ExactComplex& exact_complex, const ExactComplex& other, double tolerance)
      : claims_(claimed_by_polygons(exact_complex, other, tolerance)),
        other_(other),
        image_(claims_.complex, other, tolerance),
        image_with_antennas_(exact_complex, other, tolerance) {
    for (const Edge& edge : exact_complex.edges) edges_.emplace(edge.tail, edge.head);
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

  void look_for(std::size_t face, const std::vector<HalfedgeId>& boundary,
                const std::vector<EdgeId>& antennas, Comparison& result) {
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
    for (const EdgeId e : antennas) {
      const Edge& edge = other_.edges[e];
      const VertexId v = image_with_antennas_[edge.tail], w = image_with_antennas_[edge.head];
      if (!finding.message.empty() || edges_.contains({std::min(v, w), std::max(v, w)})) continue;
      finding.message = "an edge within a face of the result is no edge of the exact complex";
      finding.where = other_.vertices[edge.tail];
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
      finding.area = face_area(other_, FaceId(face));
      result.findings.push_back(std::move(finding));
    }
  }

 private:
  const Claims claims_;
  const ExactComplex& other_;
  const Images image_;                             ///< among the vertices of faces without antennas
  const Images image_with_antennas_;               ///< among all
  std::set<std::pair<VertexId, VertexId>> edges_;  ///< of the exact complex, antennas too
  std::map<VertexPairs, FaceId> faces_;            ///< of the exact complex
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
  const auto within = antennas(other_complex);
  for (std::size_t f = 1; f < faces.size(); ++f) {
    search.look_for(f, faces[f], within[f], result);
  }
  return result;
}

}  // namespace plumbline::compare_steps
