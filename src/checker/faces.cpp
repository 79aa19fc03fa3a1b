// Steps 5, 6 and 7: components, faces, nesting, Euler's relation.

#include <algorithm>
#include <numeric>
#include <string>

#include "refusal.hpp"
#include "steps.hpp"

namespace plumbline_checker {
namespace {

/// The least vertex of the connected component of each vertex.
std::vector<Index> least_vertices(const Certificate& certificate) {
  std::vector<Index> least(certificate.vertices.size());
  std::iota(least.begin(), least.end(), 0);
  const auto find = [&](Index v) {
    for (; least[v] != v; v = least[v]) least[v] = least[least[v]];
    return v;
  };
  for (const auto [tail, head] : certificate.edges) {
    const Index a = find(tail);
    const Index b = find(head);
    least[std::max(a, b)] = std::min(a, b);
  }
  for (Index v = 0; v < least.size(); ++v) least[v] = find(v);
  return least;
}

/// The faces that follow from the sweep and the cycles.
class Nesting {
 public:
  Nesting(const Certificate& certificate, const Sweep& sweep, const Cycles& cycles)
      : sweep_(sweep), cycle_of_(cycles.cycle_of), least_(least_vertices(certificate)) {
    for (Index v = 0; v < least_.size(); ++v) {
      if (least_[v] == v) components_.push_back(v);
    }
    face_of_.assign(cycles.halfedges.size(), 0);
    for (const Index v : components_) {
      if (sweep.topmost[v] != kNone) face_of_[cycle_around(v)] = kNone;
    }
    for (Index cycle = 0; cycle < face_of_.size(); ++cycle) {
      if (face_of_[cycle] == kNone) continue;
      face_of_[cycle] = static_cast<Index>(faces_.size());
      faces_.push_back({.outer = cycle, .depth = 0, .parent = kNone, .holes = {}, .isolated = {}});
    }
    for (const Index v : components_) put_into_face(v);
    // The edges at the leftmost vertex of a face come before all edges of what lies in it, so a
    // face's parent comes before it.
    for (Index f = 1; f < faces_.size(); ++f) {
      std::sort(faces_[f].holes.begin(), faces_[f].holes.end());
      const Index edge = *cycles.halfedges.begin(faces_[f].outer) / 2;
      faces_[f].parent = face_around(least_[certificate.edges[edge].tail]);
      faces_[f].depth = faces_[faces_[f].parent].depth + 1;
    }
    std::sort(faces_[0].holes.begin(), faces_[0].holes.end());
  }

  /// The face above an edge; what has no edge below it is in the unbounded one.
  Index face_above(Index edge) const {
    return edge == kNone ? 0 : face_of_[cycle_of_[along(edge)]];
  }
  /// The face that contains the component with the least vertex v.
  Index face_around(Index v) const { return face_above(sweep_.below[v]); }

  const std::vector<Index>& components() const { return components_; }  ///< least vertices
  std::vector<Face>& faces() { return faces_; }

 private:
  /// The cycle around a component: it has the steepest edge at the least vertex on its right, and
  /// nothing of the component is further to the left. All other cycles enclose a face each.
  Index cycle_around(Index v) const { return cycle_of_[along(sweep_.topmost[v])]; }

  /// The edge below the least vertex of a component starts further to the left, so its component
  /// comes earlier and the cycle around that has got its face.
  void put_into_face(Index v) {
    const Index parent = face_around(v);
    if (sweep_.topmost[v] == kNone) {
      faces_[parent].isolated.push_back(v);
    } else {
      face_of_[cycle_around(v)] = parent;
      faces_[parent].holes.push_back(cycle_around(v));
    }
  }

  const Sweep& sweep_;
  const std::vector<Index>& cycle_of_;
  std::vector<Index> least_;
  std::vector<Index> components_;
  std::vector<Index> face_of_;  ///< on the left of each cycle
  std::vector<Face> faces_{1};
};

std::string text_of(Index number) { return number == kNone ? "-" : std::to_string(number); }
std::string text_of(const Face& face) {
  std::string text = "outer " + text_of(face.outer) + " depth " + text_of(face.depth) + " parent " +
                     text_of(face.parent) + " holes";
  for (const Index cycle : face.holes) text += " " + std::to_string(cycle);
  text += " isolated";
  for (const Index v : face.isolated) text += " " + std::to_string(v);
  return text;
}

}  // namespace

std::vector<Face> check_faces(const Certificate& certificate, const Sweep& sweep,
                              const Cycles& cycles) {
  Nesting nesting(certificate, sweep, cycles);
  const std::vector<Face>& faces = nesting.faces();
  require("the number of faces", std::to_string(certificate.faces.size()),
          std::to_string(faces.size()), certificate.face_line - 1);
  for (Index f = 0; f < faces.size(); ++f) {
    require("face " + std::to_string(f), certificate.faces[f], text_of(faces[f]),
            certificate.face_line + f);
  }
  const std::vector<Index>& components = nesting.components();
  require("the number of components", std::to_string(certificate.components.size()),
          std::to_string(components.size()), certificate.component_line - 1);
  for (std::size_t c = 0; c < components.size(); ++c) {
    const Index v = components[c];
    require("component " + std::to_string(c), certificate.components[c],
            std::to_string(v) + " " + std::to_string(nesting.face_around(v)),
            certificate.component_line + c, &certificate.vertices[v]);
  }
  // This follows, but a slip above would show here.
  if (certificate.vertices.size() + faces.size() !=
      1 + components.size() + certificate.edges.size()) {
    throw Refusal{"Euler's relation does not hold", certificate.face_line, ""};
  }
  return std::move(nesting.faces());
}

}  // namespace plumbline_checker
