// A component lies in the face that is just below its least vertex, as far as the other components
// are concerned: none of its own edges passes below that vertex. A scan line goes over the
// components from left to right and keeps the edges that it may still meet.

#include <algorithm>
#include <limits>

#include "complex/scan_line.hpp"
#include "complex/validate.hpp"

namespace plumbline {
namespace {

/// Least vertex of each component. Components are numbered by it, so they come in scan order.
std::vector<VertexId> least_vertices(const ExactComplex& c) {
  std::vector<VertexId> least(c.component_count());
  for (std::size_t v = 0; v < c.vertices.size(); ++v) {
    VertexId& first = least[c.vertex_component[v]];
    if (!first.valid()) first = VertexId(v);
  }
  return least;
}

/// The edges that a scan line may meet, with the heights that nearest doubles of their ends bound.
/// Rounding is monotone: what is lower in doubles is not higher.
class ActiveEdges {
 public:
  explicit ActiveEdges(const ExactComplex& complex) : c_(complex) {
    for (const Point& p : c_.vertices) y_.push_back(nearest_double(p.y));
  }

  /// Takes in the edges that begin at or left of x, drops those that end there. Edges are sorted by
  /// tail.
  void advance(const Rational& x) {
    for (; next_ < c_.edge_count() && c_.vertices[c_.edges[next_].tail].x <= x; ++next_) {
      const auto [tail, head] = c_.edges[next_];
      const auto [low, high] = std::minmax(y_[tail], y_[head]);
      active_.push_back({EdgeId(next_), low, high});
    }
    std::erase_if(active_,
                  [&](const Item& i) { return c_.vertices[c_.edges[i.edge].head].x <= x; });
  }

  /// The highest edge below vertex v just right of it.
  std::optional<EdgeId> below(VertexId v) const {
    const Point& p = c_.vertices[v];
    const ScanLine line(c_, p.x);
    double floor = -std::numeric_limits<double>::infinity();  // some edge below v is nowhere lower
    for (const Item& i : active_) {
      if (i.high < y_[v]) floor = std::max(floor, i.low);
    }
    std::optional<EdgeId> highest;
    for (const Item& i : active_) {
      if (i.low > y_[v] || i.high < floor || !line.passes_below(i.edge, p)) continue;
      if (!highest || line.above(i.edge, *highest)) highest = i.edge;
    }
    return highest;
  }

 private:
  struct Item {
    EdgeId edge;
    double low, high;
  };
  const ExactComplex& c_;
  std::vector<double> y_;  ///< per vertex
  std::vector<Item> active_;
  std::size_t next_ = 0;
};

/// The face that each component lies in, computed from the graph alone.
std::vector<FaceId> surrounding_faces(const ExactComplex& c) {
  std::vector<FaceId> faces;
  ActiveEdges edges(c);
  for (const VertexId v : least_vertices(c)) {
    edges.advance(c.vertices[v].x);
    faces.push_back(face_above(c, edges.below(v)));
  }
  return faces;
}

/// How many holes and isolated vertices place each component in a face.
std::vector<std::size_t> placements(const ExactComplex& c) {
  std::vector<std::size_t> count(c.component_count(), 0);
  for (const CycleId hole : c.face_holes.flat()) {
    ++count[c.vertex_component[c.origin(c.cycles[hole].front())]];
  }
  for (const VertexId v : c.face_isolated_vertices.flat()) ++count[c.vertex_component[v]];
  return count;
}

}  // namespace

void validate_nesting(const ExactComplex& complex, Violations& violations) {
  const std::vector<VertexId> least = least_vertices(complex);
  const std::vector<std::size_t> placed = placements(complex);
  const std::vector<FaceId> surrounding = surrounding_faces(complex);
  for (std::size_t k = 0; k < least.size(); ++k) {
    const auto report = [&](const std::string& message, std::vector<FaceId> faces) {
      violations.add({Invariant::Nesting,
                      message,
                      complex.vertices[least[k]],
                      {least[k]},
                      {},
                      std::move(faces)});
    };
    if (placed[k] != 1) {
      report("a component is the hole of " + std::to_string(placed[k]) + " faces, not of one", {});
    } else if (complex.component_parent[k] != surrounding[k]) {
      report("a component is a hole of another face than the one that it lies in",
             {complex.component_parent[k], surrounding[k]});
    }
  }
}

}  // namespace plumbline
