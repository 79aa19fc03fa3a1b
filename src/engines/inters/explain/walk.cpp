// Looks at a face walk from outside.

#include "engines/inters/explain/walk.hpp"

#include <algorithm>
#include <cmath>

#include "engines/lar/explain/cells.hpp"
#include "plumbline/engines/inters_stages.hpp"

namespace plumbline::inters {
namespace {

/// Areas that differ by less, relatively, are the same.
constexpr double kSameArea = 1e-12;

const Faces* faces_of(const Trace& trace, Result result) {
  if (result == Result::LarFromLines && trace.largest) return &*trace.largest;
  if (result == Result::AllComponents && trace.all_components) return &trace.all_components->faces;
  return nullptr;
}

/// The faces as sorted lists of points.
std::vector<std::vector<PointD>> point_lists(const Model& model) {
  std::vector<std::vector<PointD>> result;
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    std::vector<PointD> points;
    for (const VertexId v : model.faces[f]) points.push_back(model.vertices[v]);
    std::sort(points.begin(), points.end());
    result.push_back(std::move(points));
  }
  std::sort(result.begin(), result.end());
  return result;
}

Model renumbered(const Model& model) {
  Model result{{model.vertices.rbegin(), model.vertices.rend()}, {}, {}};
  const auto turned = [&](VertexId v) { return VertexId(model.vertices.size() - 1 - v); };
  for (const auto& [v, w] : model.edges) result.edges.push_back({turned(v), turned(w)});
  return result;
}

bool gives_other_faces(const Faces& faces) {
  try {
    const Faces other = faces_from_components(renumbered(faces.model));
    return point_lists(other.model) != point_lists(faces.model);
  } catch (const StageFailure&) {
    return true;
  }
}

std::size_t connected_components(const Model& model) {
  std::vector<std::size_t> root(model.vertices.size());
  for (std::size_t v = 0; v < root.size(); ++v) root[v] = v;
  const auto find = [&](std::size_t v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  std::size_t count = model.vertices.size();
  for (const auto& [v, w] : model.edges) {
    const std::size_t a = find(v), b = find(w);
    if (a != b) --count;
    root[a] = b;
  }
  return count;
}

/// A walk closes a face for each component's exterior, too.
bool breaks_euler(const Model& model) {
  return model.vertices.size() + model.faces.size() !=
         model.edges.size() + 2 * connected_components(model);
}

double area(const Model& model, std::size_t f) {
  const auto face = model.faces[f];
  double twice = 0;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const PointD& o = model.vertices[face[0]];
    const PointD& p = model.vertices[face[i]];
    const PointD& q = model.vertices[face[(i + 1) % face.size()]];
    twice += (p.x - o.x) * (q.y - o.y) - (q.x - o.x) * (p.y - o.y);
  }
  return std::abs(twice) / 2;
}

bool misjudges_areas(const Faces& faces) {
  std::vector<double> areas;
  for (std::size_t f = 0; f < faces.areas.size(); ++f) areas.push_back(area(faces.model, f));
  const auto largest = std::max_element(areas.begin(), areas.end());
  if (largest == areas.end()) return false;
  const double computed = faces.areas[static_cast<std::size_t>(largest - areas.begin())];
  for (std::size_t f = 0; f < areas.size(); ++f) {
    if (areas[f] < *largest * (1 - kSameArea) && faces.areas[f] >= computed) return true;
  }
  return false;
}

/// Whether edges around a vertex are out of order. **Exact**.
bool misorders(const Model& model) {
  const Lists<EdgeId> order = edge_slope_ordering(model);
  for (std::size_t v = 0; v < order.size(); ++v) {
    const auto around = order[v];
    const auto half = [&](EdgeId e) {  // 0: below or right of the vertex, 1: above or left
      const auto& [s, t] = model.edges[e];
      const PointD& p = model.vertices[v];
      const PointD& q = model.vertices[s == v ? t : s];
      return q.y > p.y || (q.y == p.y && q.x < p.x) ? 1 : 0;
    };
    for (std::size_t i = 1; i < around.size(); ++i) {
      if (half(around[i - 1]) != half(around[i])) continue;
      const auto far = [&](EdgeId e) {
        const auto& [s, t] = model.edges[e];
        return exact(model.vertices[s == v ? t : s]);
      };
      if (orientation(exact(model.vertices[v]), far(around[i - 1]), far(around[i])) < 0) {
        return true;
      }
    }
  }
  return false;
}

bool never_ends(const Trace& trace, Result result) {
  const char* stage = result == Result::LarFromLines ? "larFromLines" : "allComponents";
  return std::any_of(trace.failures.begin(), trace.failures.end(), [&](const auto& failure) {
    return failure.stage == stage && failure.error == "NoTermination";
  });
}

}  // namespace

Walk walk_of(const Trace& trace, Result result, const LineWork& work, std::size_t threads) {
  Walk walk;
  if (result == Result::CellsFromCycles) return walk;
  walk.never_ends = never_ends(trace, result);
  walk.is_plane = lar::is_plane(work, threads);
  const Faces* faces = faces_of(trace, result);
  if (!faces) return walk;
  walk.aborted = faces->aborted;
  walk.breaks_euler = !walk.aborted && breaks_euler(faces->model);
  walk.depends_on_order = !walk.is_plane && !walk.aborted && gives_other_faces(*faces);
  walk.misjudges_areas = misjudges_areas(*faces);
  walk.misorders_edges = misorders(faces->model);
  return walk;
}

}  // namespace plumbline::inters
