// Finds vertices again that lie too far away to match, by their edges.

#include "compare/moved_vertices.hpp"

#include <algorithm>
#include <map>

namespace plumbline::compare_steps {
namespace {

using VertexPair = std::pair<VertexId, VertexId>;  // exact, float

bool have_common_source(const ExactComplex& a, EdgeId e, const ExactComplex& b, EdgeId f) {
  const auto here = a.edge_sources[e], there = b.edge_sources[f];
  if (here.empty() || there.empty()) return true;
  return std::find_first_of(here.begin(), here.end(), there.begin(), there.end()) != here.end();
}

/// A component: its vertices, ascending, and its edges as pairs of positions among them.
struct Shape {
  std::vector<VertexId> vertices;
  std::vector<EdgeId> edges;
  std::vector<std::pair<std::size_t, std::size_t>> ends;
};

std::vector<Shape> shapes(const ExactComplex& complex) {
  std::vector<Shape> result(complex.component_count());
  std::vector<std::size_t> position(complex.vertices.size());
  for (std::size_t v = 0; v < position.size(); ++v) {
    auto& vertices = result[complex.vertex_component[v]].vertices;
    position[v] = vertices.size();
    vertices.emplace_back(v);
  }
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const auto [tail, head] = complex.edges[e];
    Shape& shape = result[complex.vertex_component[tail]];
    shape.edges.emplace_back(e);
    shape.ends.emplace_back(position[tail], position[head]);
  }
  return result;
}

class MovedVertexSearch {
 public:
  MovedVertexSearch(const Sides& sides, const Both<std::vector<VertexId>>& match)
      : sides_(sides), match_(match) {}

  std::vector<VertexPair> run() {
    for (const Side side : kBothSides) {
      if (std::all_of(match_[side].begin(), match_[side].end(),
                      [](VertexId v) { return v.valid(); })) {
        return {};  // nothing on that side that could have moved
      }
    }
    pair_components();
    while (pair_by_neighbours()) {
    }
    std::sort(found_.begin(), found_.end());
    return std::move(found_);
  }

 private:
  void pair_components();
  bool are_alike(const Shape& here, const Shape& there) const;
  bool pair_by_neighbours();
  std::map<std::vector<std::size_t>, std::vector<VertexId>> by_neighbours(Side side) const;
  bool have_common_sources(VertexId v, VertexId w) const;
  void add(VertexId v, VertexId w) {
    match_[Exact][v] = w;
    match_[Float][w] = v;
    found_.emplace_back(v, w);
  }

  const Sides& sides_;
  Both<std::vector<VertexId>> match_;
  std::vector<VertexPair> found_;
};

/// Whether the shapes are the same, and no match and no source says that they are not.
bool MovedVertexSearch::are_alike(const Shape& here, const Shape& there) const {
  if (here.vertices.size() != there.vertices.size() || here.ends != there.ends) return false;
  for (std::size_t i = 0; i < here.vertices.size(); ++i) {
    const VertexId w = match_[Exact][here.vertices[i]], v = match_[Float][there.vertices[i]];
    if (w.valid() ? w != there.vertices[i] : v.valid()) return false;
  }
  for (std::size_t i = 0; i < here.edges.size(); ++i) {
    if (!have_common_source(sides_[Exact], here.edges[i], sides_[Float], there.edges[i])) {
      return false;
    }
  }
  return true;
}

void MovedVertexSearch::pair_components() {
  const Both<std::vector<Shape>> all = {shapes(sides_[Exact]), shapes(sides_[Float])};
  const auto pair = [&](const Shape& here, const Shape& there) {
    if (!are_alike(here, there)) return;
    for (std::size_t i = 0; i < here.vertices.size(); ++i) {
      if (!match_[Exact][here.vertices[i]].valid()) add(here.vertices[i], there.vertices[i]);
    }
  };
  // Those without any match by their shape, if there are as many on both sides.
  using Ends = std::vector<std::pair<std::size_t, std::size_t>>;
  std::map<Ends, Both<std::vector<const Shape*>>> strangers;
  for (const Side side : kBothSides) {
    for (const Shape& shape : all[side]) {
      const auto is_matched = [&](VertexId v) { return match_[side][v].valid(); };
      const auto matched = std::find_if(shape.vertices.begin(), shape.vertices.end(), is_matched);
      if (matched == shape.vertices.end()) {
        strangers[shape.ends][side].push_back(&shape);
      } else if (side == Exact) {
        pair(shape, all[Float][sides_[Float].vertex_component[match_[Exact][*matched]]]);
      }
    }
  }
  for (const auto& [ends, list] : strangers) {
    if (list[Exact].size() == list[Float].size()) {
      for (std::size_t i = 0; i < list[Exact].size(); ++i) pair(*list[Exact][i], *list[Float][i]);
    }
  }
}

/// The vertices without a match, by the exact names of their matched neighbours (at least one) and
/// their degree.
std::map<std::vector<std::size_t>, std::vector<VertexId>> MovedVertexSearch::by_neighbours(
    Side side) const {
  std::map<std::vector<std::size_t>, std::vector<VertexId>> result;
  for (std::size_t v = 0; v < match_[side].size(); ++v) {
    if (match_[side][v].valid()) continue;
    std::vector<std::size_t> key;
    for (const HalfedgeId h : sides_.outgoing[side][v]) {
      const VertexId neighbour = sides_[side].target(h), image = match_[side][neighbour];
      if (image.valid()) key.push_back(side == Exact ? neighbour : image);
    }
    if (key.empty()) continue;
    std::sort(key.begin(), key.end());
    key.push_back(sides_.outgoing[side][v].size());
    result[key].emplace_back(v);
  }
  return result;
}

bool MovedVertexSearch::have_common_sources(VertexId v, VertexId w) const {
  for (const HalfedgeId h : sides_.outgoing[Exact][v]) {
    const VertexId there = match_[Exact][sides_[Exact].target(h)];
    if (!there.valid()) continue;
    const EdgeId f = edge_between(sides_, Float, w, there);
    if (!f.valid() || !have_common_source(sides_[Exact], edge_of(h), sides_[Float], f)) {
      return false;
    }
  }
  return true;
}

/// Whether a pair was found.
bool MovedVertexSearch::pair_by_neighbours() {
  const auto exacts = by_neighbours(Exact), floats = by_neighbours(Float);
  const std::size_t before = found_.size();
  std::vector<VertexPair> pairs;
  for (const auto& [key, here] : exacts) {
    const auto there = floats.find(key);
    if (there == floats.end() || here.size() != 1 || there->second.size() != 1) continue;
    if (have_common_sources(here[0], there->second[0])) {
      pairs.emplace_back(here[0], there->second[0]);
    }
  }
  for (const auto& [v, w] : pairs) add(v, w);
  return found_.size() != before;
}

}  // namespace

std::vector<VertexPair> moved_vertices(const Sides& sides,
                                       const Both<std::vector<VertexId>>& match) {
  return MovedVertexSearch(sides, match).run();
}

}  // namespace plumbline::compare_steps
