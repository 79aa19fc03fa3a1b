// What `to_json` of an exact complex writes, read back: every coordinate exactly.

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

Point point(const JsonValue& vertex) {
  const JsonValue list =
      member(expect(vertex, JsonType::Object, "a vertex"), "exact", JsonType::Array);
  if (list.size() != 2) list.fail("expected two coordinates");
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

void add_face(ExactComplex& c, const JsonValue& face) {
  expect(face, JsonType::Object, "a face");
  const JsonValue outer = face.find("outer");
  const bool is_unbounded = c.face_outer.empty();
  if (!outer) face.fail("a face without member outer");
  if (is_unbounded != outer.is(JsonType::Null))
    outer.fail("face 0, and no other, is without outer boundary");
  c.face_outer.push_back(is_unbounded ? CycleId() : add_cycle(c, outer));
  std::vector<CycleId> holes;
  const JsonValue hole_list = member(face, "holes", JsonType::Array);
  for (JsonValue hole = hole_list.first(); hole; hole = hole.next())
    holes.push_back(add_cycle(c, hole));
  c.face_holes.push_back(holes);
  std::vector<VertexId> isolated;
  const JsonValue vertex_list = member(face, "isolated_vertices", JsonType::Array);
  for (JsonValue v = vertex_list.first(); v; v = v.next())
    isolated.push_back(index<VertexId>(v, c.vertices.size(), "vertex"));
  c.face_isolated_vertices.push_back(isolated);
}

}  // namespace

Result read_arrangement(ByteStream& bytes) {
  const JsonTree tree(bytes);
  const JsonValue root = expect(tree.root(), JsonType::Object, "an object");
  const JsonValue format = member(root, "format", JsonType::String);
  if (format.text() != "plumbline arrangement 1") format.fail("not an arrangement");
  ExactComplex c;
  const JsonValue vertices = member(root, "vertices", JsonType::Array);
  const JsonValue edges = member(root, "edges", JsonType::Array);
  const JsonValue faces = member(root, "faces", JsonType::Array);
  for (JsonValue v = vertices.first(); v; v = v.next()) c.vertices.push_back(point(v));
  for (JsonValue e = edges.first(); e; e = e.next()) {
    expect(e, JsonType::Object, "an edge");
    const auto end = [&](const char* key) {
      return index<VertexId>(member(e, key, JsonType::Number), c.vertices.size(), "vertex");
    };
    c.edges.push_back({end("tail"), end("head")});
    c.edge_sources.push_back(std::vector<SegmentId>());
  }
  for (JsonValue f = faces.first(); f; f = f.next()) add_face(c, f);
  if (c.face_outer.empty()) faces.fail("no unbounded face");
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
