// LAR models as results: vertices have an identity, and cells are sets of vertices.

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "engines/files/face_walks.hpp"
#include "engines/files/json_values.hpp"
#include "engines/files/readers.hpp"
#include "plumbline/engine/cell_lists.hpp"
#include "plumbline/error.hpp"

namespace plumbline::files {
namespace {

using Cell = std::vector<VertexId>;

/// The members of a model, as far as they are there.
struct Members {
  std::optional<JsonValue> vertices, edges, faces, polygons, base;
};

class LarResult {
 public:
  explicit LarResult(const JsonValue& model, const std::string& file) {
    result_.file = file;
    find_members(model);
  }

  Result read() && {
    read_vertices();
    find_base();
    read_edges();
    read_faces();
    result_.has_faces = members_.faces || members_.polygons;
    result_.has_edges = members_.edges.has_value();
    cells_.lists_all_edges = members_.edges.has_value();
    result_.complex = exact(complex_from_faces(cells_));
    note_lost_faces(result_, cells_.faces.size());
    return std::move(result_);
  }

 private:
  void find_members(const JsonValue& root);
  void find_list_members(const JsonValue& root);
  static Source source_of(const JsonValue& value, std::string element);
  void read_vertices();
  void find_base();
  void read_edges();
  void read_faces();
  VertexId vertex(const JsonValue& index) const;
  Cell cell(const JsonValue& list) const;
  Polygon face_of(Cell vertices);
  bool is_cycle(const Cell& vertices) const;
  std::optional<std::vector<Cell>> cycles_among(const Cell& vertices) const;
  Rational twice_area(const Cell& ring) const;

  Result result_;
  Members members_;
  CellLists cells_;
  std::vector<std::vector<VertexId>> neighbours_;  ///< per vertex, by EV
  std::optional<FaceWalks> walks_;                 ///< made when a cell needs them
  std::int64_t base_ = 0;
};

void LarResult::find_members(const JsonValue& root) {
  if (root.is(JsonType::Array)) return find_list_members(root);
  json::expect(root, JsonType::Object, "a LAR model: an object or a list");
  if (const JsonValue outputs = root.find("outputs")) {  // a trace of the pipeline
    const JsonValue model =
        json::expect(outputs, JsonType::Object, "an object").find("larFromLines");
    if (!model || !model.is(JsonType::Object)) {
      outputs.fail("the trace has no larFromLines: the pipeline had no result");
    }
    return find_members(model);
  }
  for (JsonValue member = root.first(); member; member = member.next()) {
    const std::string_view key = member.key();
    const bool is_list = member.is(JsonType::Array);
    if (key == "index_base") {
      members_.base = member;
    } else if (key == "V" || key == "EV" || key == "FV" || key == "polygons") {
      if (!is_list) member.fail("expected a list");
      (key == "V"    ? members_.vertices
       : key == "EV" ? members_.edges
       : key == "FV" ? members_.faces
                     : members_.polygons) = member;
    } else if (key != "format") {
      result_.rejected.push_back({source_of(member, std::string(key)),
                                  "this member of a LAR model is not understood",
                                  {},
                                  true});
    }
  }
  if (!members_.vertices) root.fail("not LAR: no member V");
}

Source LarResult::source_of(const JsonValue& value, std::string element) {
  const Place place = value.place();
  return {0, place.line, place.column, std::move(element), {}, {}};
}

/// [V, EV], [V, FV] or [V, FV, EV]: of two lists the second has edges if its cells are pairs.
void LarResult::find_list_members(const JsonValue& root) {
  constexpr std::size_t kMostLists = 3;
  if (root.size() == 0 || root.size() > kMostLists) root.fail("not LAR: expected V, FV, EV");
  std::vector<JsonValue> lists;
  for (JsonValue list = root.first(); list; list = list.next()) {
    lists.push_back(json::expect(list, JsonType::Array, "a list"));
  }
  members_.vertices = lists[0];
  if (lists.size() == 1) return;
  if (lists.size() == kMostLists) {
    members_.faces = lists[1];
    members_.edges = lists[2];
    return;
  }
  bool are_pairs = true;
  for (JsonValue cell = lists[1].first(); cell; cell = cell.next()) {
    are_pairs = are_pairs && cell.is(JsonType::Array) && cell.size() == 2;
  }
  (are_pairs ? members_.edges : members_.faces) = lists[1];
}

void LarResult::read_vertices() {
  bool has_other_coordinates = false;
  for (JsonValue point = members_.vertices->first(); point; point = point.next()) {
    json::expect(point, JsonType::Array, "a point");
    if (point.size() < 2 || point.size() > 3) {
      point.fail("not LAR: point of " + std::to_string(point.size()) + " coordinates");
    }
    const JsonValue x = point.first();
    cells_.vertices.push_back({json::coordinate(x), json::coordinate(x.next())});
    has_other_coordinates = has_other_coordinates || point.size() > 2;
  }
  if (has_other_coordinates) {
    result_.remarks.push_back(
        {source_of(*members_.vertices, "V"), "coordinates beyond x and y are not used", {}});
  }
}

/// Without index_base: 1 if some index is the number of vertices, and none is 0.
void LarResult::find_base() {
  if (members_.base) {
    base_ = json::integer(*members_.base);
    if (base_ != 0 && base_ != 1) members_.base->fail("index_base is neither 0 nor 1");
    return;
  }
  const auto count = static_cast<std::int64_t>(cells_.vertices.size());
  bool has_zero = false, has_count = false;
  std::vector<JsonValue> open;
  for (const auto& list : {members_.edges, members_.faces, members_.polygons}) {
    if (list) open.push_back(*list);
  }
  while (!open.empty()) {
    const JsonValue value = open.back();
    open.pop_back();
    if (value.is(JsonType::Number)) {
      has_zero = has_zero || value.text() == "0";
      has_count = has_count || value.text() == std::to_string(count);
    } else if (value.is(JsonType::Array)) {
      for (JsonValue item = value.first(); item; item = item.next()) open.push_back(item);
    }
  }
  base_ = has_count && !has_zero ? 1 : 0;
}

VertexId LarResult::vertex(const JsonValue& index) const {
  const std::int64_t i = json::integer(index) - base_;
  if (i < 0 || i >= static_cast<std::int64_t>(cells_.vertices.size())) {
    index.fail("not LAR: no such vertex: " + std::to_string(cells_.vertices.size()) +
               " are counted from " + std::to_string(base_) +
               " (a member index_base of 0 or 1 says from where)");
  }
  return VertexId(static_cast<std::size_t>(i));
}

Cell LarResult::cell(const JsonValue& list) const {
  json::expect(list, JsonType::Array, "a list of vertices");
  Cell result;
  for (JsonValue index = list.first(); index; index = index.next()) result.push_back(vertex(index));
  return result;
}

void LarResult::read_edges() {
  neighbours_.resize(cells_.vertices.size());
  if (!members_.edges) return;
  for (JsonValue pair = members_.edges->first(); pair; pair = pair.next()) {
    Cell ends = cell(pair);
    if (ends.size() == 1) ends.push_back(ends.front());  // an edge that collapsed
    if (ends.size() != 2) {
      pair.fail("not LAR: edge of " + std::to_string(ends.size()) + " vertices");
    }
    cells_.edges.push_back({ends[0], ends[1]});
    neighbours_[ends[0]].push_back(ends[1]);
    neighbours_[ends[1]].push_back(ends[0]);
  }
}

void LarResult::read_faces() {
  if (members_.polygons) {
    for (JsonValue rings = members_.polygons->first(); rings; rings = rings.next()) {
      json::expect(rings, JsonType::Array, "a list of cycles");
      Polygon face;
      for (JsonValue ring = rings.first(); ring; ring = ring.next()) {
        if (face.outer.empty()) {
          face.outer = cell(ring);
        } else {
          face.holes.push_back(cell(ring));
        }
      }
      cells_.faces.push_back(std::move(face));
    }
  } else if (members_.faces) {
    for (JsonValue list = members_.faces->first(); list; list = list.next()) {
      cells_.faces.push_back(face_of(cell(list)));
    }
  }
}

/// Whether they are joined in this order.
bool LarResult::is_cycle(const Cell& vertices) const {
  if (!members_.edges || vertices.empty()) return !members_.edges;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const VertexId v = vertices[i], w = vertices[(i + 1) % vertices.size()];
    if (v != w && std::ranges::find(neighbours_[v], w) == neighbours_[v].end()) return false;
  }
  return true;
}

Polygon LarResult::face_of(Cell vertices) {
  const bool is_ordered = is_cycle(vertices);
  auto cycles = is_ordered ? std::nullopt : cycles_among(vertices);
  if (!is_ordered && !cycles) {
    if (!walks_) walks_.emplace(cells_.vertices, neighbours_);
    Cell ascending = vertices;
    std::ranges::sort(ascending);
    if (auto face = walks_->around(ascending)) return std::move(*face);
  }
  if (!cycles) return {std::move(vertices)};
  const auto widest = std::ranges::max_element(
      *cycles, {}, [&](const Cell& ring) { return nearest_double(abs(twice_area(ring))); });
  Polygon face{std::move(*widest)};
  cycles->erase(widest);
  face.holes = std::move(*cycles);
  return face;
}

/// The cycles that EV has among the vertices; none where these do not have two neighbours each.
std::optional<std::vector<Cell>> LarResult::cycles_among(const Cell& vertices) const {
  std::set<VertexId> left(vertices.begin(), vertices.end());
  const std::set<VertexId> all = left;
  std::vector<Cell> cycles;
  while (!left.empty()) {
    Cell& cycle = cycles.emplace_back();
    for (std::optional<VertexId> v = *left.begin(); v;) {
      cycle.push_back(*v);
      left.erase(*v);
      std::size_t degree = 0;
      std::optional<VertexId> next;
      for (const VertexId w : neighbours_[*v]) {
        degree += all.contains(w) ? 1 : 0;
        if (left.contains(w) && !next) next = w;
      }
      if (degree != 2) return std::nullopt;
      v = next;
    }
  }
  if (cycles.empty()) return std::nullopt;
  return cycles;
}

Rational LarResult::twice_area(const Cell& ring) const {
  Rational sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point p = exact(cells_.vertices[ring[i]]);
    const Point q = exact(cells_.vertices[ring[(i + 1) % ring.size()]]);
    sum += p.x * q.y - q.x * p.y;
  }
  return sum;
}

}  // namespace

Result read_lar(const JsonValue& model, const std::string& file_name) {
  return LarResult(model, file_name).read();
}

Result read_lar(ByteStream& bytes) {
  const JsonTree tree(bytes);
  return read_lar(tree.root(), bytes.file());
}

Result read_lar(std::string_view text, const std::string& file_name) {
  ByteStream bytes(text, {file_name, 1, 1});
  return read_lar(bytes);
}

}  // namespace plumbline::files
