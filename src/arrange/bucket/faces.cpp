#include "arrange/bucket/faces.hpp"

namespace plumbline::bucket {
namespace {

/// The face around each component. What is just before a component is the outer boundary of a face,
/// or a hole: then both lie in the same face. Components before it have lesser vertices, so this
/// ends.
class Surroundings {
 public:
  Surroundings(const Cycles& cycles, const std::vector<Component>& components, const Faces& faces)
      : cycles_(cycles),
        components_(components),
        faces_(faces),
        face_(components.size()),
        component_of_hole_(cycles.first.size(), kNone) {
    for (std::size_t c = 0; c < components.size(); ++c) {
      if (components[c].hole.valid()) {
        component_of_hole_[components[c].hole] = static_cast<std::uint32_t>(c);
      }
    }
  }

  FaceId face(std::size_t component) {
    std::vector<std::size_t> path;
    FaceId face = face_[component];
    while (!face.valid()) {
      path.push_back(component);
      if (components_[component].beside != kNone) {
        component = components_[component].beside;
        face = face_[component];
        continue;
      }
      const HalfedgeId before = components_[component].before;
      if (!before.valid()) {
        face = kUnbounded;
      } else if (const CycleId cycle = cycles_.of_halfedge[before];
                 component_of_hole_[cycle] == kNone) {
        face = faces_.of_cycle[cycle];
      } else {
        component = component_of_hole_[cycle];
        face = face_[component];
      }
    }
    for (const std::size_t c : path) face_[c] = face;
    return face;
  }

 private:
  const Cycles& cycles_;
  const std::vector<Component>& components_;
  const Faces& faces_;
  std::vector<FaceId> face_;
  std::vector<std::uint32_t> component_of_hole_;
};

/// Groups values by their faces, in their order.
template <class Value>
Grouped<Value> grouped(const std::vector<std::pair<FaceId, Value>>& list, std::size_t face_count) {
  Grouped<Value> result;
  result.begin.assign(face_count, 0);
  for (const auto& item : list) ++result.begin[item.first];
  accumulate(result.begin);
  result.items.resize(list.size());
  std::vector<std::uint32_t> next(result.begin.begin(), result.begin.end() - 1);
  for (const auto& item : list) result.items[next[item.first]++] = item.second;
  return result;
}

}  // namespace

Faces make_faces(const Cycles& cycles, const std::vector<Component>& components) {
  Faces faces;
  std::vector<std::uint8_t> is_hole(cycles.first.size(), 0);
  for (const Component& c : components) {
    if (c.hole.valid()) is_hole[c.hole] = 1;
  }
  faces.of_cycle.resize(cycles.first.size());
  faces.outer.emplace_back();
  for (std::size_t c = 0; c < is_hole.size(); ++c) {
    if (is_hole[c] != 0) continue;
    faces.of_cycle[c] = FaceId(faces.outer.size());
    faces.outer.emplace_back(c);
  }
  Surroundings surroundings(cycles, components, faces);
  std::vector<std::pair<FaceId, CycleId>> holes;
  std::vector<std::pair<FaceId, VertexId>> isolated;
  for (std::size_t c = 0; c < components.size(); ++c) {
    const FaceId face = surroundings.face(c);
    if (components[c].hole.valid()) {
      holes.emplace_back(face, components[c].hole);
    } else {
      isolated.emplace_back(face, VertexId(components[c].vertex));
    }
  }
  for (const auto& [face, hole] : holes) faces.of_cycle[hole] = face;
  faces.holes = grouped(holes, faces.outer.size());
  faces.isolated_vertices = grouped(isolated, faces.outer.size());
  return faces;
}

}  // namespace plumbline::bucket
