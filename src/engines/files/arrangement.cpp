// What `to_json` and `to_compact_json` of an exact complex write, read back: every coordinate
// exactly.

#include "engines/files/json_values.hpp"
#include "engines/files/readers.hpp"
#include "plumbline/error.hpp"

namespace plumbline::files {
namespace {

using json::expect;
using json::member;

template <class Id>
Id index(const JsonValue& value, std::size_t count, const char* what) {
  const std::int64_t i = json::integer(value);
  if (i < 0 || i >= static_cast<std::int64_t>(count)) value.fail(std::string("no such ") + what);
  return Id(static_cast<std::size_t>(i));
}

Rational coordinate(const JsonValue& value) {
  expect(value, JsonType::String, "an exact number in quotes");
  try {
    return parse_decimal(value.text());
  } catch (const Error& error) {
    value.fail(error.message());
  }
}

Point point(const JsonValue& list) {
  if (expect(list, JsonType::Array, "a point").size() != 2) list.fail("expected two coordinates");
  const JsonValue x = list.first();
  return {coordinate(x), coordinate(x.next())};
}

/// Signed edges counted from 1.
CycleId add_cycle(ExactComplex& c, const JsonValue& list) {
  expect(list, JsonType::Array, "a cycle of signed edges");
  std::vector<HalfedgeId> cycle;
  for (JsonValue value = list.first(); value; value = value.next()) {
    const std::int64_t number = json::integer(value);
    const auto edges = static_cast<std::int64_t>(c.edge_count());
    if (number == 0 || number < -edges || number > edges) value.fail("no such edge");
    cycle.push_back(halfedge(EdgeId(static_cast<std::size_t>(std::abs(number) - 1)), number < 0));
  }
  if (cycle.empty()) list.fail("a cycle without edges");
  c.cycles.push_back(cycle);
  return CycleId(c.cycles.size() - 1);
}

void add_outer(ExactComplex& c, const JsonValue& outer) {
  const bool is_unbounded = c.face_outer.empty();
  if (is_unbounded != outer.is(JsonType::Null)) {
    outer.fail("face 0, and no other, is without outer boundary");
  }
  c.face_outer.push_back(is_unbounded ? CycleId() : add_cycle(c, outer));
}

void add_face(ExactComplex& c, const JsonValue& face) {
  expect(face, JsonType::Object, "a face");
  const JsonValue outer = face.find("outer");
  if (!outer) face.fail("a face without member outer");
  add_outer(c, outer);
  std::vector<CycleId> holes;
  const JsonValue hole_list = member(face, "holes", JsonType::Array);
  for (JsonValue hole = hole_list.first(); hole; hole = hole.next()) {
    holes.push_back(add_cycle(c, hole));
  }
  c.face_holes.push_back(holes);
  std::vector<VertexId> isolated;
  const JsonValue vertex_list = member(face, "isolated_vertices", JsonType::Array);
  for (JsonValue v = vertex_list.first(); v; v = v.next()) {
    isolated.push_back(index<VertexId>(v, c.vertices.size(), "vertex"));
  }
  c.face_isolated_vertices.push_back(isolated);
}

void add_edge(ExactComplex& c, const JsonValue& tail, const JsonValue& head) {
  const auto end = [&](const JsonValue& v) {
    return index<VertexId>(v, c.vertices.size(), "vertex");
  };
  c.edges.push_back({end(tail), end(head)});
  c.edge_sources.push_back(std::vector<SegmentId>());
}

void add_cells(ExactComplex& c, const JsonValue& root) {
  const JsonValue vertices = member(root, "vertices", JsonType::Array);
  const JsonValue edges = member(root, "edges", JsonType::Array);
  const JsonValue faces = member(root, "faces", JsonType::Array);
  for (JsonValue v = vertices.first(); v; v = v.next()) {
    c.vertices.push_back(
        point(member(expect(v, JsonType::Object, "a vertex"), "exact", JsonType::Array)));
  }
  for (JsonValue e = edges.first(); e; e = e.next()) {
    expect(e, JsonType::Object, "an edge");
    add_edge(c, member(e, "tail", JsonType::Number), member(e, "head", JsonType::Number));
  }
  for (JsonValue f = faces.first(); f; f = f.next()) add_face(c, f);
  if (c.face_outer.empty()) faces.fail("no unbounded face");
}

/// Per face the isolated vertices that rows [face, vertex] give it.
std::vector<std::vector<VertexId>> isolated_vertices(const ExactComplex& c, const JsonValue& rows) {
  std::vector<std::vector<VertexId>> result(c.face_outer.size());
  for (JsonValue row = rows.first(); row; row = row.next()) {
    if (expect(row, JsonType::Array, "a face and a vertex").size() != 2) {
      row.fail("expected a face and a vertex");
    }
    const JsonValue face = row.first();
    result[index<FaceId>(face, result.size(), "face")].push_back(
        index<VertexId>(face.next(), c.vertices.size(), "vertex"));
  }
  return result;
}

void add_compact_cells(ExactComplex& c, const JsonValue& root) {
  const JsonValue vertices = member(root, "vertices", JsonType::Array);
  const JsonValue edges = member(root, "edges", JsonType::Array);
  const JsonValue faces = member(root, "faces", JsonType::Array);
  for (JsonValue v = vertices.first(); v; v = v.next()) c.vertices.push_back(point(v));
  for (JsonValue e = edges.first(); e; e = e.next()) {
    if (expect(e, JsonType::Array, "an edge").size() < 2) e.fail("expected two vertices");
    add_edge(c, e.first(), e.first().next());
  }
  std::vector<CycleId> holes;
  for (JsonValue f = faces.first(); f; f = f.next()) {
    if (expect(f, JsonType::Array, "a face").size() == 0) f.fail("expected an outer boundary");
    add_outer(c, f.first());
    holes.clear();
    for (JsonValue hole = f.first().next(); hole; hole = hole.next()) {
      holes.push_back(add_cycle(c, hole));
    }
    c.face_holes.push_back(holes);
  }
  if (c.face_outer.empty()) faces.fail("no unbounded face");
  for (const auto& list :
       isolated_vertices(c, member(root, "isolated_vertices", JsonType::Array))) {
    c.face_isolated_vertices.push_back(list);
  }
}

}  // namespace

Result read_arrangement(ByteStream& bytes) {
  const JsonTree tree(bytes);
  const JsonValue root = expect(tree.root(), JsonType::Object, "an object");
  const JsonValue format = member(root, "format", JsonType::String);
  ExactComplex c;
  if (format.text() == "plumbline arrangement 1") {
    add_cells(c, root);
  } else if (format.text() == "plumbline compact arrangement 1") {
    add_compact_cells(c, root);
  } else {
    format.fail("not an arrangement");
  }
  Result result;
  result.file = bytes.file();
  result.complex = canonical(std::move(c));
  result.has_faces = true;
  return result;
}

Result read_arrangement(std::string_view text, const std::string& file_name) {
  ByteStream bytes(text, {file_name, 1, 1});
  return read_arrangement(bytes);
}

}  // namespace plumbline::files
