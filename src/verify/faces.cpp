// Steps 5, 6 and 7: components, faces, nesting, the points inside, Euler's relation.

#include <algorithm>
#include <numeric>
#include <string>

#include "refusal.hpp"
#include "steps.hpp"

namespace plumbline_verify {
namespace {

/// Connected components of vertices and edges.
class Components {
 public:
  explicit Components(const Certificate& certificate) : least_(certificate.vertices.size()) {
    std::iota(least_.begin(), least_.end(), 0);
    for (const auto [tail, head] : certificate.edges) {
      const Index a = least(tail);
      const Index b = least(head);
      least_[std::max(a, b)] = std::min(a, b);
    }
  }

  /// The least vertex of the component of a vertex.
  Index least(Index v) {
    for (; least_[v] != v; v = least_[v]) least_[v] = least_[least_[v]];
    return v;
  }

 private:
  std::vector<Index> least_;
};

class Faces {
 public:
  Faces(const Certificate& certificate, const Sweep& sweep, const std::vector<Index>& cycle_of)
      : certificate_(certificate), sweep_(sweep), cycle_of_(cycle_of) {}

  void check() {
    find_components();
    find_outer_cycles();
    nest();
    check_nesting_lists();
    check_inside();
    const std::size_t v = certificate_.vertices.size();
    const std::size_t e = certificate_.edges.size();
    const std::size_t c = certificate_.components.size();
    if (v + certificate_.faces.size() != 1 + c + e)
      refuse_face(0, "Euler's relation does not hold");
  }

 private:
  [[noreturn]] void refuse_face(std::size_t face, std::string reason) const {
    throw Refusal{std::move(reason), certificate_.face_line + face, ""};
  }
  [[noreturn]] void refuse_component(std::size_t component, std::string reason) const {
    std::string place;
    if (component < least_vertices_.size()) {
      place = text_of(certificate_.vertices[least_vertices_[component]]);
    }
    throw Refusal{std::move(reason), certificate_.component_line + component, std::move(place)};
  }

  static std::string name(const char* what, Index number) {
    return number == kNone ? std::string("-") : what + (" " + std::to_string(number));
  }

  void find_components() {
    Components components(certificate_);
    for (Index v = 0; v < certificate_.vertices.size(); ++v) {
      if (components.least(v) == v) least_vertices_.push_back(v);
    }
    const std::size_t count = certificate_.components.size();
    if (count != least_vertices_.size()) {
      refuse_component(0, "there are " + std::to_string(least_vertices_.size()) +
                              " components, not " + std::to_string(count));
    }
    for (std::size_t c = 0; c < count; ++c) {
      if (certificate_.components[c].least_vertex != least_vertices_[c]) {
        refuse_component(c, "the least vertex of component " + std::to_string(c) + " is " +
                                std::to_string(least_vertices_[c]));
      }
    }
    component_of_.resize(certificate_.vertices.size());
    for (Index c = 0; c < count; ++c) component_of_[least_vertices_[c]] = c;
    for (Index v = 0; v < component_of_.size(); ++v) {
      component_of_[v] = component_of_[components.least(v)];
    }
  }

  /// The cycle around a component is on the left of the steepest edge at its least vertex, where
  /// nothing of the component is further to the left. All others enclose a face each.
  void find_outer_cycles() {
    face_of_.assign(certificate_.cycles.size(), 0);
    around_.assign(least_vertices_.size(), kNone);
    for (std::size_t c = 0; c < least_vertices_.size(); ++c) {
      const Index edge = sweep_.topmost[least_vertices_[c]];
      if (edge == kNone) continue;  // an isolated vertex
      around_[c] = cycle_of_[along(edge)];
      face_of_[around_[c]] = kNone;
    }
    Index count = 1;
    for (Index cycle = 0; cycle < face_of_.size(); ++cycle) {
      if (face_of_[cycle] != kNone) {
        if (count < certificate_.faces.size() && certificate_.faces[count].outer != cycle) {
          refuse_face(count, "the outer cycle of face " + std::to_string(count) + " is " +
                                 std::to_string(cycle));
        }
        face_of_[cycle] = count++;
      }
    }
    if (count != certificate_.faces.size()) {
      refuse_face(0, "there are " + std::to_string(count) + " faces, not " +
                         std::to_string(certificate_.faces.size()));
    }
    const Face& unbounded = certificate_.faces[0];
    if (unbounded.outer != kNone || unbounded.depth != 0 || unbounded.parent != kNone) {
      refuse_face(0, "face 0 is not the unbounded one: it has an outer cycle, a depth or a parent");
    }
  }

  /// The face above an edge; what has no edge below is in the unbounded one.
  Index face_above(Index edge) const {
    return edge == kNone ? 0 : face_of_[cycle_of_[along(edge)]];
  }

  /// The edge below a component's least vertex starts before that, so its component comes earlier
  /// and the cycle around it has got its face.
  void nest() {
    holes_.resize(certificate_.faces.size());
    isolated_.resize(certificate_.faces.size());
    for (Index c = 0; c < least_vertices_.size(); ++c) {
      const Index v = least_vertices_[c];
      const Index parent = face_above(sweep_.below[v]);
      if (certificate_.components[c].face != parent) {
        refuse_component(c, "component " + std::to_string(c) + " is in face " +
                                std::to_string(parent) + ", not in face " +
                                std::to_string(certificate_.components[c].face));
      }
      if (around_[c] == kNone) {
        isolated_[parent].push_back(v);
      } else {
        face_of_[around_[c]] = parent;
        holes_[parent].push_back(around_[c]);
      }
    }
    for (std::vector<Index>& holes : holes_) std::sort(holes.begin(), holes.end());
    for (Index f = 1; f < certificate_.faces.size(); ++f) check_parent(f);
  }

  void check_parent(Index f) const {
    const Face& face = certificate_.faces[f];
    const Index halfedge = *certificate_.cycles.begin(face.outer);
    const Index component = component_of_[certificate_.edges[halfedge / 2].tail];
    const Index parent = certificate_.components[component].face;
    if (face.parent != parent) {
      refuse_face(f, "the parent of face " + std::to_string(f) + " is face " +
                         std::to_string(parent) + ", not " + name("face", face.parent));
    }
    // Parents are in components that come earlier, so that every chain of them ends in face 0.
    if (face.depth != certificate_.faces[parent].depth + 1) {
      refuse_face(f, "the depth of face " + std::to_string(f) + " is not that of its parent + 1");
    }
  }

  void check_nesting_lists() const {
    for (std::size_t f = 0; f < certificate_.faces.size(); ++f) {
      check_list(f, certificate_.holes, holes_[f], "holes");
      check_list(f, certificate_.isolated, isolated_[f], "isolated vertices");
    }
  }
  void check_list(std::size_t f, const Lists& said, const std::vector<Index>& right,
                  const char* what) const {
    if (std::equal(said.begin(f), said.end(f), right.begin(), right.end())) return;
    std::string list;
    for (std::size_t i = 0; i < right.size() && i < 10; ++i) list += " " + std::to_string(right[i]);
    if (right.size() > 10) list += " ...";
    refuse_face(f, "the " + std::string(what) + " of face " + std::to_string(f) + " are" +
                       (right.empty() ? " none" : list));
  }

  void check_inside() const {
    for (std::size_t item = 0; item < certificate_.inside.size(); ++item) {
      const Index face = face_above(sweep_.below_inside[item]);
      if (face == item + 1) continue;
      throw Refusal{"the point inside face " + std::to_string(item + 1) + " is in face " +
                        std::to_string(face),
                    certificate_.face_line + item + 1, text_of(certificate_.inside[item])};
    }
  }

  const Certificate& certificate_;
  const Sweep& sweep_;
  const std::vector<Index>& cycle_of_;
  std::vector<Index> least_vertices_;  ///< of each component
  std::vector<Index> component_of_;    ///< of each vertex
  std::vector<Index> around_;   ///< the cycle around each component, kNone if an isolated vertex
  std::vector<Index> face_of_;  ///< on the left of each cycle
  std::vector<std::vector<Index>> holes_, isolated_;  ///< of each face
};

}  // namespace

void check_faces(const Certificate& certificate, const Sweep& sweep,
                 const std::vector<Index>& cycle_of) {
  Faces(certificate, sweep, cycle_of).check();
}

}  // namespace plumbline_verify
