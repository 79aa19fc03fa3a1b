// Results that are valid complexes: of drawings that lack something, or have something more.

#include <algorithm>

#include "mutations/mutations.hpp"

namespace plumbline::mutations {
namespace {

constexpr Name kVertexMissing{CellKind::Vertex, Disagreement::Missing};
constexpr Name kVertexExtra{CellKind::Vertex, Disagreement::Extra};
constexpr Name kEdgeMissing{CellKind::Edge, Disagreement::Missing};
constexpr Name kEdgeExtra{CellKind::Edge, Disagreement::Extra};

std::vector<Point> corners(const Right& right, FaceId f) {
  std::vector<Point> result;
  for (const HalfedgeId h : right->cycles[right->face_outer[f]]) {
    result.push_back(right.point(right->origin(h)));
  }
  return result;
}

ExactComplex without(const Right& right, EdgeId e, bool keeps_ends) {
  Drawing drawing(*right);
  drawing.segments.erase(drawing.segments.begin() + static_cast<std::ptrdiff_t>(e));
  drawing.sources.erase(drawing.sources.begin() + static_cast<std::ptrdiff_t>(e));
  if (keeps_ends) {
    for (const Point& p : ends(right, e)) drawing.points.push_back(p);
  }
  return drawing.arranged();
}

std::optional<Broken> drop_edge(Right& right) {
  const EdgeId e = right.edge([](EdgeId) { return true; });
  if (!e.valid()) return {};
  return Broken{without(right, e, true), 0, {kEdgeMissing}, ends(right, e)};
}

/// Drops an edge between two bounded faces.
std::optional<Broken> merge_faces(Right& right) {
  const EdgeId e = right.edge([&](EdgeId i) {
    const FaceId f = right->halfedge_face[halfedge(i, false)];
    return !right->is_antenna(i) && f != kUnbounded &&
           right->halfedge_face[halfedge(i, true)] != kUnbounded;
  });
  if (!e.valid()) return {};
  const FaceId f = right->halfedge_face[halfedge(e, false)];
  const FaceId g = right->halfedge_face[halfedge(e, true)];
  Broken result{without(right, e, true), 0, {kEdgeMissing}, ends(right, e)};
  // Two faces are one, unless one lay in a hole of the other, or the edge was all that parted them
  // from a hole.
  if (right->parent(f) == right->parent(g)) {
    result.names.push_back({CellKind::Face, Disagreement::Merged});
    for (const FaceId face : {f, g}) {
      for (const Point& p : corners(right, face)) result.places.push_back(p);
    }
  }
  return result;
}

std::optional<Broken> lose_antenna(Right& right) {
  const VertexId v = right.vertex([&](VertexId i) { return right.neighbours(i).size() == 1; });
  if (!v.valid()) return {};
  const VertexId w = right.neighbours(v)[0];
  const EdgeId e = right.edge([&](EdgeId i) {
    const Edge& edge = right->edges[i];
    return std::minmax(edge.tail, edge.head) == std::minmax(v, w);
  });
  Drawing drawing(*right);
  drawing.segments.erase(drawing.segments.begin() + static_cast<std::ptrdiff_t>(e));
  drawing.sources.erase(drawing.sources.begin() + static_cast<std::ptrdiff_t>(e));
  drawing.points.push_back(right.point(w));
  return Broken{drawing.arranged(), 0, {kVertexMissing, kEdgeMissing}, ends(right, e)};
}

/// Joins two vertices that see each other.
std::optional<Broken> join(Right& right, bool splits_face) {
  constexpr int kTries = 30;
  if (right->vertices.size() < 3) return {};
  for (int i = 0; i < kTries; ++i) {
    const VertexId v(right.below(right->vertices.size())), w(right.below(right->vertices.size()));
    const auto& near = right.neighbours(v);
    if (v == w || std::binary_search(near.begin(), near.end(), w)) continue;
    Drawing drawing(*right);
    drawing.add(right.point(v), right.point(w));
    ExactComplex joined = drawing.arranged();
    const bool is_one_edge = joined.vertices.size() == right->vertices.size() &&
                             joined.edge_count() == right->edge_count() + 1;
    if (!is_one_edge || (joined.face_count() > right->face_count()) != splits_face) continue;
    return Broken{std::move(joined), 0, {kEdgeExtra}, {right.point(v), right.point(w)}};
  }
  return {};
}

std::optional<Broken> split_face(Right& right) {
  std::optional<Broken> result = join(right, true);
  if (!result) return {};
  // In the unbounded face, or between an outline and itself, a face comes into being.
  const std::size_t before = right->face_count();
  if (result->complex.face_count() != before + 1) return {};
  return result;
}

std::optional<Broken> bridge_components(Right& right) { return join(right, false); }

std::optional<Point> inside(Right& right) {
  const FaceId f = right.bounded_face([](FaceId) { return true; });
  if (!f.valid()) return {};
  return interior_point(*right, f);
}

std::optional<Broken> add_isolated_vertex(Right& right) {
  const auto p = inside(right);
  if (!p) return {};
  Drawing drawing(*right);
  drawing.points.push_back(*p);
  return Broken{drawing.arranged(), 0, {kVertexExtra}, {*p}};
}

std::optional<Broken> drop_isolated_vertex(Right& right) {
  Drawing drawing(*right);
  if (drawing.points.empty()) return {};
  const auto at = static_cast<std::ptrdiff_t>(right.below(drawing.points.size()));
  const Point p = drawing.points[static_cast<std::size_t>(at)];
  drawing.points.erase(drawing.points.begin() + at);
  return Broken{drawing.arranged(), 0, {kVertexMissing}, {p}};
}

std::optional<Broken> add_antenna(Right& right) {
  const VertexId v = right.vertex([](VertexId) { return true; });
  if (!v.valid()) return {};
  const Point p = right.point(v), step = right.small_step(), tip{p.x + step.x, p.y + step.y};
  Drawing drawing(*right);
  drawing.add(p, tip);
  ExactComplex complex = drawing.arranged();
  // Along an edge it would only cut the edge.
  if (complex.edge_count() != right->edge_count() + 1 ||
      complex.component_count() != right->component_count()) {
    return {};
  }
  const Drawing arranged(complex);
  const auto is_there = [&](const Segment& s) {
    return (s.a == p && s.b == tip) || (s.a == tip && s.b == p);
  };
  const bool lies_on_edge =
      right.edge([&](EdgeId e) { return on_segment(right.tail(e), right.head(e), tip); }).valid();
  if (lies_on_edge || std::none_of(arranged.segments.begin(), arranged.segments.end(), is_there)) {
    return {};
  }
  return Broken{std::move(complex), 0, {kVertexExtra, kEdgeExtra}, {p, tip}};
}

/// A vertex too many.
std::optional<Broken> cut_edge(Right& right) {
  const EdgeId e = right.edge([](EdgeId) { return true; });
  if (!e.valid()) return {};
  Drawing drawing(*right);
  drawing.points.push_back(right.middle(e));
  return Broken{
      drawing.arranged(), 0, {kVertexExtra, {CellKind::Edge, Disagreement::Split}}, ends(right, e)};
}

/// A vertex too few: its two edges are one.
std::optional<Broken> cut_corner(Right& right) {
  const VertexId v = right.vertex([&](VertexId i) { return right.neighbours(i).size() == 2; });
  if (!v.valid()) return {};
  Drawing drawing(*right);
  for (std::size_t i = drawing.segments.size(); i-- > 0;) {
    if (drawing.segments[i].a != right.point(v) && drawing.segments[i].b != right.point(v)) {
      continue;
    }
    drawing.segments.erase(drawing.segments.begin() + static_cast<std::ptrdiff_t>(i));
    drawing.sources.erase(drawing.sources.begin() + static_cast<std::ptrdiff_t>(i));
  }
  const Point a = right.point(right.neighbours(v)[0]), b = right.point(right.neighbours(v)[1]);
  drawing.add(a, b);
  ExactComplex complex = drawing.arranged();
  const bool is_elsewhere = std::find(complex.vertices.begin(), complex.vertices.end(),
                                      right.point(v)) == complex.vertices.end();
  if (!is_elsewhere || complex.vertices.size() + 1 != right->vertices.size()) return {};
  return Broken{std::move(complex), 0, {kVertexMissing}, {right.point(v)}, 2};
}

std::optional<Broken> drop_component(Right& right) {
  if (right->component_count() == 0) return {};
  const ComponentId k(right.below(right->component_count()));
  Drawing drawing(*right);
  Broken result;
  for (std::size_t e = right->edge_count(); e-- > 0;) {
    if (right->vertex_component[right->edges[e].tail] != k) continue;
    drawing.segments.erase(drawing.segments.begin() + static_cast<std::ptrdiff_t>(e));
    drawing.sources.erase(drawing.sources.begin() + static_cast<std::ptrdiff_t>(e));
    result.names = {kVertexMissing, kEdgeMissing};
  }
  for (std::size_t v = 0; v < right->vertices.size(); ++v) {
    if (right->vertex_component[v] != k) continue;
    result.places.push_back(right.point(VertexId(v)));
    std::erase(drawing.points, right.point(VertexId(v)));
  }
  if (result.names.empty()) result.names = {kVertexMissing};
  result.complex = drawing.arranged();
  return result;
}

/// A small triangle in a face.
std::optional<Broken> add_component(Right& right) {
  const FaceId f = right.bounded_face([](FaceId) { return true; });
  if (!f.valid()) return {};
  const Point p = interior_point(*right, f);
  Rational size = right.small();
  constexpr int kTries = 20;
  for (int i = 0; i < kTries; ++i, size /= 8) {
    const Point q{p.x + size, p.y}, r{p.x, p.y + size};
    Drawing drawing(*right);
    drawing.add(p, q);
    drawing.add(q, r);
    drawing.add(r, p);
    ExactComplex complex = drawing.arranged();
    if (complex.component_count() != right->component_count() + 1) continue;
    if (complex.edge_count() != right->edge_count() + 3) continue;
    return Broken{std::move(complex),
                  0,
                  {kVertexExtra,
                   kEdgeExtra,
                   {CellKind::Face, Disagreement::Extra},
                   {CellKind::Hole, Disagreement::Extra}},
                  {p, q, r}};
  }
  return {};
}

/// Shrinks the shortest edge to a point, far from all other vertices.
std::optional<Broken> collapse_edge(Right& right) {
  if (right->edge_count() == 0) return {};
  const FeatureSize features = feature_size(*right);
  const EdgeId e = right.edge([&](EdgeId i) {
    return squared_distance(right.tail(i), right.head(i)) == features.squared_vertex_vertex;
  });
  if (!e.valid()) return {};
  const Point from = right.head(e), to = right.tail(e);
  const auto is_near = [&](const Point& p) {
    const Rational limit = 9 * features.squared_vertex_vertex;
    return p != from && p != to &&
           (squared_distance(p, from) <= limit || squared_distance(p, to) <= limit);
  };
  if (std::any_of(right->vertices.begin(), right->vertices.end(), is_near)) return {};
  Drawing drawing(*right);
  for (Segment& s : drawing.segments) {
    if (s.a == from) s.a = to;
    if (s.b == from) s.b = to;
  }
  Broken result{drawing.arranged(), 0, {{CellKind::Vertex, Disagreement::Merged}}, {from, to}};
  result.tolerance = nearest_sqrt(features.squared_vertex_vertex) * 1.001;
  if (result.complex.vertices.size() + 1 != right->vertices.size()) return {};
  if (result.complex.edge_count() + 1 < right->edge_count()) {
    return {};  // a triangle: its edges became one as well
  }
  return result;
}

/// Two vertices a little apart in place of one, each with some of its edges.
std::optional<Broken> split_vertex(Right& right) {
  const VertexId v = right.vertex([&](VertexId i) { return right.neighbours(i).size() >= 2; });
  if (!v.valid()) return {};
  const Point p = right.point(v), step = right.small_step();
  const Point q{p.x + step.x / 4, p.y + step.y / 4};
  Drawing drawing(*right);
  for (Segment& s : drawing.segments) {
    if (s.a != p && s.b != p) continue;
    (s.a == p ? s.a : s.b) = q;
    break;
  }
  Broken result{drawing.arranged(), 0, {{CellKind::Vertex, Disagreement::Split}}, {p, q}};
  if (result.complex.vertices.size() != right->vertices.size() + 1) return {};
  result.tolerance = nearest_double(right.small()) / 2;
  return result;
}

std::optional<Broken> drop_all(Right& right) {
  if (right->vertices.empty()) return {};
  Drawing nothing(*right);
  nothing.segments.clear();
  nothing.sources.clear();
  nothing.points.clear();
  return Broken{
      nothing.arranged(), 0, {kVertexMissing}, {right->vertices.begin(), right->vertices.end()}};
}

}  // namespace

const std::vector<Mutation>& of_drawings() {
  static const std::vector<Mutation> list{
      {"drop an edge", drop_edge},
      {"merge two faces", merge_faces},
      {"lose an antenna", lose_antenna},
      {"split a face", split_face},
      {"bridge two components", bridge_components},
      {"add an isolated vertex", add_isolated_vertex},
      {"drop an isolated vertex", drop_isolated_vertex},
      {"add an antenna", add_antenna},
      {"cut an edge in two", cut_edge},
      {"cut a corner", cut_corner},
      {"drop a component", drop_component},
      {"add a component", add_component},
      {"merge two vertices", collapse_edge},
      {"split a vertex in two", split_vertex},
      {"drop everything", drop_all},
  };
  return list;
}

}  // namespace plumbline::mutations
