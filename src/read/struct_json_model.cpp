// The models in a structure's JSON.

#include "read/struct_json_model.hpp"

#include <array>
#include <utility>

#include "plumbline/error.hpp"

namespace plumbline {
namespace {

void read_vertices(const JsonValue& model, LarModel& result, Numbers& numbers) {
  const JsonValue vertices = model.find("V");
  if (!vertices) model.fail("neither a Struct, a map, a reference nor a model");
  expect(vertices, JsonType::Array, "a list of points");
  bool is_first = true;
  for (JsonValue vertex = vertices.first(); vertex; vertex = vertex.next()) {
    expect(vertex, JsonType::Array, "a point");
    if (vertex.size() == 0) vertex.fail("a point without coordinates");
    if (vertex.size() > kMaxDimension) {
      vertex.fail("a point of more than " + std::to_string(kMaxDimension) + " dimensions");
    }
    if (is_first) result.dimension = vertex.size();
    is_first = false;
    if (vertex.size() != result.dimension) vertex.fail("points of different dimensions");
    for (JsonValue x = vertex.first(); x; x = x.next()) {
      result.coordinates.push_back(number_of(x, numbers));
    }
  }
}

Cells cells_of(const JsonValue& array) {
  expect(array, JsonType::Array, "a list of cells");
  Cells result;
  std::vector<std::uint32_t> vertices;
  for (JsonValue cell = array.first(); cell; cell = cell.next()) {
    expect(cell, JsonType::Array, "a cell, a list of vertices");
    vertices.clear();
    for (JsonValue v = cell.first(); v; v = v.next()) vertices.push_back(index_of(v));
    result.push_back(vertices);
  }
  return result;
}

void read_cells(const JsonValue& model, LarModel& result) {
  if (const JsonValue arrays = model.find("cells")) {
    expect(arrays, JsonType::Array, "a list of arrays of cells");
    for (JsonValue array = arrays.first(); array; array = array.next()) {
      result.cells.push_back(cells_of(array));
    }
  }
  for (const char* name : {"CV", "FV", "EV"}) {
    if (const JsonValue array = model.find(name)) result.cells.push_back(cells_of(array));
  }
}

/// The grid, its place told where it is too large.
LarModel cuboids_of(const JsonValue& extents, const std::vector<std::uint32_t>& shape,
                    bool skeletons) {
  try {
    return cuboids(shape, skeletons);
  } catch (const Error& error) {
    throw Error(error.code(), error.message(), extents.place());
  }
}

LarModel grid(const JsonValue& value, const std::vector<std::string>& files) {
  expect_members(value, {"type", "shape", "skeletons", "boundary"});
  const auto flag = [&](const char* name) {
    const JsonValue member = value.find(name);
    if (member) expect(member, JsonType::Bool, "true or false");
    return member && member.text() == "true";
  };
  std::vector<std::uint32_t> shape;
  const JsonValue extents = value.find("shape");
  expect(extents, JsonType::Array, "a list of whole numbers");
  for (JsonValue extent = extents.first(); extent; extent = extent.next()) {
    shape.push_back(index_of(extent));
  }
  if (shape.empty()) extents.fail("a grid of dimension 0");
  const bool boundary = flag("boundary");
  LarModel result = cuboids_of(extents, shape, boundary || flag("skeletons"));
  if (boundary) result = boundary_model(result);
  result.source = source_of(value, "cuboids", files);
  return result;
}

/// Rows [line, column, count of segments, id], of which the count may be missing, then 1, and the
/// id.
void read_rows(const JsonValue& rows, Model& model) {
  expect(rows, JsonType::Array, "a list of lines and columns");
  std::size_t segments = 0;
  for (JsonValue row = rows.first(); row; row = row.next()) {
    expect(row, JsonType::Array, "a line and a column");
    constexpr std::size_t kMost = 4;
    if (row.size() < 2 || row.size() > kMost) row.fail("not a line, a column, a count and an id");
    Model::Row result;
    JsonValue value = row.first();
    result.line = index_of(value);
    value = value.next();
    result.column = index_of(value);
    value = value.next();
    if (value) {
      result.segment_count = index_of(value);
      value = value.next();
    }
    if (value) {
      model.row_ids.push_back(string_of(value));
      result.id = static_cast<std::uint32_t>(model.row_ids.size());
    }
    segments += result.segment_count;
    model.rows.push_back(result);
  }
  if (segments != model.segments.size()) rows.fail("not as many segments in rows as lines");
}

void read_rings(const JsonValue& rings, Model& model) {
  expect(rings, JsonType::Array, "a list of rings");
  std::size_t end = 0;
  for (JsonValue ring = rings.first(); ring; ring = ring.next()) {
    expect(ring, JsonType::Array, "a first line, a count and what it bounds");
    if (ring.size() != 3) ring.fail("not a first line, a count and what it bounds");
    const JsonValue first = ring.first(), count = first.next();
    const std::string name = string_of(count.next());
    Ring result{index_of(first), index_of(count), RingRole::Polygon};
    while (name != to_text(result.role)) {
      if (result.role == RingRole::Line) ring.fail("not polygon, part, hole or line");
      result.role = static_cast<RingRole>(static_cast<int>(result.role) + 1);
    }
    const std::size_t size = model.segments.size();
    if (result.first < end || result.first > size || result.count > size - result.first) {
      ring.fail("not the lines of a ring behind the one before it");
    }
    end = std::size_t{result.first} + result.count;
    model.rings.push_back(result);
  }
}

void read_labels(const JsonValue& labels, Model& model, Numbers& numbers) {
  expect(labels, JsonType::Array, "a list of labels");
  for (JsonValue label = labels.first(); label; label = label.next()) {
    expect(label, JsonType::Object, "an object");
    expect_members(label, {"text", "place", "row", "height"});
    const JsonValue text = label.find("text");
    if (!text) label.fail("no member \"text\"");
    Model::Text result{string_of(text), {}};
    if (const JsonValue place = label.find("place")) {
      expect(place, JsonType::Array, "a point");
      if (place.size() != 2) place.fail("not a point of the plane");
      const JsonValue x = place.first();
      result.place = NumberPoint{number_of(x, numbers), number_of(x.next(), numbers)};
    }
    if (const JsonValue row = label.find("row")) result.row = index_of(row);
    if (const JsonValue height = label.find("height")) {
      result.height = nearest_double(number_of(height, numbers));
    }
    const std::size_t rows = model.rows.empty() ? 1 : model.rows.size();
    const bool is_behind = model.labels.empty() || model.labels.back().row <= result.row;
    if (result.row >= rows || !is_behind) label.fail("not of a row, in the order of rows");
    model.labels.push_back(std::move(result));
  }
}

Model lines(const JsonValue& value, const std::vector<std::string>& files, Numbers& numbers) {
  expect_members(value, {"type", "lines", "rows", "rings", "labels"});
  Model result;
  result.source = source_of(value, "lines", files);
  const JsonValue list = value.find("lines");
  expect(list, JsonType::Array, "a list of lines");
  for (JsonValue line = list.first(); line; line = line.next()) {
    std::array<Number, 4> x;
    std::size_t count = 0;
    expect(line, JsonType::Array, "a line, a list of two points");
    for (JsonValue point = line.first(); point; point = point.next()) {
      expect(point, JsonType::Array, "a point");
      if (point.size() != 2 || count == x.size()) line.fail("not two points of the plane");
      for (JsonValue c = point.first(); c; c = c.next()) x.at(count++) = number_of(c, numbers);
    }
    if (count != x.size()) line.fail("not two points of the plane");
    result.segments.push_back({std::move(x[0]), std::move(x[1])},
                              {std::move(x[2]), std::move(x[3])});
  }
  if (const JsonValue rows = value.find("rows")) read_rows(rows, result);
  if (const JsonValue rings = value.find("rings")) read_rings(rings, result);
  if (const JsonValue labels = value.find("labels")) read_labels(labels, result, numbers);
  return result;
}

}  // namespace

Struct::Item read_model(const JsonValue& value, const std::vector<std::string>& files,
                        Numbers& numbers) {
  if (value.find("lines")) return lines(value, files, numbers);
  if (value.find("shape")) return grid(value, files);
  expect_members(value, {"type", "V", "CV", "FV", "EV", "cells"});
  LarModel result;
  result.source = source_of(value, "model", files);
  read_vertices(value, result, numbers);
  read_cells(value, result);
  if (result.cells.empty()) value.fail("a model without cells");
  check(result, files);
  return result;
}

}  // namespace plumbline
