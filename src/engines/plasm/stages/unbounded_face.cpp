#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "plumbline/engines/plasm_stages.hpp"

namespace plumbline::plasm {
namespace {

/// The vertices that are outermost in x and y; of several the last, else the first.
std::array<VertexId, 4> outermost(const Graph& graph, std::span<const EdgeId> edges) {
  std::set<VertexId> vertices;
  for (const EdgeId e : edges) vertices.insert({graph.edges[e][0], graph.edges[e][1]});
  const VertexId last = *vertices.rbegin();
  vertices.erase(last);
  std::array<VertexId, 4> result{last, last, last, last};
  auto& [right, left, top, bottom] = result;
  const auto at = [&](VertexId v) { return graph.vertices[v]; };
  for (const VertexId v : vertices) {
    if (at(v).x > at(right).x) {
      right = v;
    } else if (at(v).x < at(left).x) {
      left = v;
    }
    if (at(v).y > at(top).y) {
      top = v;
    } else if (at(v).y < at(bottom).y) {
      bottom = v;
    }
  }
  return result;
}

bool has(const Graph& graph, const Chain& face, VertexId v) {
  return std::any_of(face.begin(), face.end(), [&](const SignedEdge& s) {
    return graph.edges[s.edge][0] == v || graph.edges[s.edge][1] == v;
  });
}

/// Of the matrix with rows (x, y, 1), by elimination with pivots in columns.
double determinant(const PointD& p, const PointD& q, const PointD& r) {
  std::array<std::array<double, 3>, 3> m{{{p.x, p.y, 1}, {q.x, q.y, 1}, {r.x, r.y, 1}}};
  double result = 1;
  for (std::size_t column = 0; column < 3; ++column) {
    std::size_t best = column;
    for (std::size_t row = column + 1; row < 3; ++row) {
      if (std::abs(m[row][column]) > std::abs(m[best][column])) best = row;
    }
    if (best != column) {
      std::swap(m[best], m[column]);
      result = -result;
    }
    if (m[column][column] == 0) return 0;
    result *= m[column][column];
    for (std::size_t row = column + 1; row < 3; ++row) {
      const double factor = m[row][column] / m[column][column];
      for (std::size_t k = column + 1; k < 3; ++k) m[row][k] -= factor * m[column][k];
    }
  }
  return result;
}

/// The corners of a face from that which its first edge leaves.
std::vector<VertexId> corners(const Graph& graph, const Chain& face) {
  std::map<VertexId, std::vector<EdgeId>> at;
  for (const SignedEdge& s : face) {
    for (const VertexId v : graph.edges[s.edge]) at[v].push_back(s.edge);
  }
  EdgeId edge = face.front().edge;
  const bool is_reversed = face.front().sign < 0;
  const VertexId start = graph.edges[edge][is_reversed ? 1 : 0];
  VertexId next = graph.edges[edge][is_reversed ? 0 : 1];
  std::vector<VertexId> result{start};
  while (next != start && result.size() <= face.size()) {
    result.push_back(next);
    const std::vector<EdgeId>& here = at[next];
    const auto other = std::find_if(here.begin(), here.end(), [&](EdgeId e) { return e != edge; });
    if (other == here.end()) break;
    edge = *other;
    next = graph.edges[edge][graph.edges[edge][0] == next ? 1 : 0];
  }
  if (next != start) {
    throw Failure{Failure::Kind::EndlessWalk, "buildFV: the boundary of a face does not close"};
  }
  return result;
}

}  // namespace

double face_area(const Graph& graph, const Chain& face) {
  const std::vector<VertexId> around = corners(graph, face);
  double area = 0;
  for (std::size_t i = 1; i + 1 < around.size(); ++i) {
    area += 0.5 * determinant(graph.vertices[around[0]], graph.vertices[around[i]],
                              graph.vertices[around[i + 1]]);
  }
  return area;
}

std::size_t unbounded_face(const Graph& graph, std::span<const EdgeId> edges,
                           std::span<const Chain> faces) {
  const std::array<VertexId, 4> ends = outermost(graph, edges);
  std::vector<std::size_t> candidates;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (std::all_of(ends.begin(), ends.end(),
                    [&](VertexId v) { return has(graph, faces[f], v); })) {
      candidates.push_back(f);
    }
  }
  if (candidates.size() == 1) return candidates.front();
  for (const std::size_t f : candidates) {
    if (face_area(graph, faces[f]) < 0) return f;
  }
  throw Failure{Failure::Kind::NoShell,
                "get_external_cycle finds no face of negative area with all outermost vertices"};
}

}  // namespace plumbline::plasm
