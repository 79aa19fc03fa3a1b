// GeoJSON, well-known text and binary as results: coordinates are all there is to tell vertices
// apart.

#include <map>
#include <utility>

#include "engines/files/readers.hpp"
#include "engines/files/split_rings.hpp"
#include "plumbline/engine/cell_lists.hpp"

namespace plumbline::files {
namespace {

class VertexNumbers {
 public:
  VertexId number(const PointD& p) {
    const auto [known, is_new] = numbers_.try_emplace({p.x + 0.0, p.y + 0.0}, vertices_.size());
    if (is_new) vertices_.push_back(known->first);
    return VertexId(known->second);
  }
  std::vector<VertexId> numbers(const std::vector<PointD>& points) {
    std::vector<VertexId> result;
    result.reserve(points.size());
    for (const PointD& p : points) result.push_back(number(p));
    return result;
  }
  std::vector<PointD> take() { return std::move(vertices_); }

 private:
  std::map<PointD, std::size_t> numbers_;
  std::vector<PointD> vertices_;
};

CellLists cells_of(const Geometries& geometries) {
  CellLists cells;
  VertexNumbers vertices;
  for (const Geometries::Polygon& polygon : geometries.polygons) {
    Polygon& face = cells.faces.emplace_back();
    for (const std::vector<PointD>& ring : polygon.rings) {
      if (face.outer.empty()) {
        face.outer = vertices.numbers(ring);
      } else {
        face.holes.push_back(vertices.numbers(ring));
      }
    }
  }
  for (const std::vector<PointD>& line : geometries.lines) {
    const std::vector<VertexId> ids = vertices.numbers(line);
    for (std::size_t i = 0; i + 1 < ids.size(); ++i) {
      if (ids[i] != ids[i + 1]) cells.edges.push_back({ids[i], ids[i + 1]});
    }
  }
  cells.vertices = vertices.take();
  return cells;
}

}  // namespace

Result read_features(ByteStream& bytes, FeatureReader reader) {
  Result result;
  Geometries geometries;
  Structure notes = reader(bytes, {&geometries});
  result.file = bytes.file();
  result.rejected = std::move(notes.rejected);
  result.remarks = std::move(notes.remarks);
  CellLists cells = cells_of(geometries);
  for (const VertexId v : split_rings(cells)) result.passed.push_back(cells.vertices[v]);
  result.has_faces = !cells.faces.empty();
  result.has_edges = !geometries.lines.empty();
  result.complex = exact(complex_from_faces(cells));
  note_lost_faces(result, cells.faces.size());
  return result;
}

Result read_geojson(std::string_view text, const std::string& file_name) {
  ByteStream bytes(text, {file_name, 1, 1});
  return read_features(bytes, plumbline::read_geojson);
}

Result read_wkt(std::string_view text, const std::string& file_name) {
  ByteStream bytes(text, {file_name, 1, 1});
  return read_features(bytes, plumbline::read_wkt);
}

}  // namespace plumbline::files
