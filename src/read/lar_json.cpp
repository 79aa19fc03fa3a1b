// LAR models as JSON: {"V": ..., "EV": ..., "FV": ...}, {"lines": ...}, [V, EV] or [V, FV, EV].

#include <algorithm>
#include <charconv>
#include <utility>

#include "read/attribute.hpp"
#include "read/feature_table.hpp"
#include "read/json_events.hpp"
#include "read/lar_cells.hpp"
#include "read/line_list.hpp"
#include "read/streams.hpp"

namespace plumbline {
namespace {

enum class Section { Other, V, EV, FV, Lines, IndexBase };

Section section_of(std::string_view key) {
  if (key == "V") return Section::V;
  if (key == "EV") return Section::EV;
  if (key == "FV" || key == "CV") return Section::FV;  // cells of the plane
  if (key == "lines") return Section::Lines;
  return key == "index_base" ? Section::IndexBase : Section::Other;
}

class LarJsonReader {
 public:
  LarJsonReader(ByteStream& bytes, const FeatureOptions& options, bool is_line_list)
      : bytes_(bytes), table_(bytes.file(), options), is_line_list_(is_line_list) {}

  Structure read() && {
    parse_json(bytes_, *this);
    draw();
    return std::move(table_).finish();
  }

  static bool done() { return false; }

  void key(std::string_view name) {
    if (ignored_ > 0) return;
    section_ = section_of(name);
    name_ = name;
    if (section_ == Section::Other) return;
    const unsigned bit = 1U << static_cast<unsigned>(section_);
    if ((seen_ & bit) != 0) fail("member " + name_ + " is there twice");
    seen_ |= bit;
  }

  void scalar(JsonScalar kind, std::string_view text) {
    if (ignored_ > 0) return;
    if (depth_ == 0) fail("neither an object nor an array");
    const bool is_value_of_member = depth_ == 1 && !is_list_;
    if (is_value_of_member && section_ == Section::Other) return;
    const bool is_fraction =
        kind == JsonScalar::String && in_point() && text.find('/') != std::string_view::npos;
    if (kind != JsonScalar::Number && !is_fraction) fail("not a number", text);
    if (is_value_of_member) {
      if (section_ != Section::IndexBase) fail("not a list", text);
      if (text != "0" && text != "1") fail("index_base is neither 0 nor 1", text);
      index_base_ = text == "1" ? 1 : 0;
    } else if (in_point()) {
      add_coordinate(text);
    } else if (depth_ == kDepthInCell && section_ != Section::Lines) {
      cells().vertices.push_back(index(text));
    } else {
      fail("a number in place of a list", text);
    }
  }

  void open_object() {
    if (ignored_ == 0 && depth_ == 0) {
      depth_ = 1;
      return;
    }
    if (ignored_ == 0 && (is_list_ || depth_ > 1 || section_ != Section::Other)) {
      fail("an object in place of a list");
    }
    ignore();
  }

  void close_object() {
    if (ignored_ > 0) {
      --ignored_;
    } else {
      --depth_;
    }
  }

  void open_array() {
    if (ignored_ > 0) return ignore();
    if (depth_ == 0) begin_document();
    if (depth_ == 1 && is_list_ && !is_line_list_) begin_list();
    if (depth_ == 1 && section_ == Section::Other) return ignore();
    if (depth_ == 1 && section_ == Section::IndexBase) fail("index_base is a list");
    ++depth_;
    if (depth_ > (section_ == Section::Lines ? kDepthInLines : kDepthInCell)) {
      fail("lists are nested too deep");
    }
    coordinates_ = 0;
    if (depth_ != kDepthInCell) return;
    place_ = bytes_.place();
    points_before_ = points_.size();
  }

  void close_array() {
    if (ignored_ > 0) {
      --ignored_;
      return;
    }
    if (depth_ == kDepthInCell && section_ != Section::V && section_ != Section::Lines) {
      LarCells& list = cells();
      list.cells.push_back({list.vertices.size(), place_.line, place_.column});
    }
    if (in_point()) end_point();
    if (depth_ == kDepthInCell && section_ == Section::Lines) end_segment();
    --depth_;
  }

 private:
  // Of open arrays and objects: [V, EV] and {"V": ...} are at depth 1, their lists at 2.
  static constexpr std::size_t kDepthInCell = 3;
  static constexpr std::size_t kDepthInLines = 4;

  [[noreturn]] void fail(const std::string& message, std::string_view text = {}) {
    throw Error(ErrorCode::BadInput, "not LAR: " + message, bytes_.place(), printable(text));
  }

  void ignore() {
    if (ignored_++ > 0) return;
    table_.refuse(name_, bytes_.place(),
                  {"this member of a LAR model is not understood", {}, true});
  }

  /// A bare list of lines stands as deep as that of a member "lines".
  void begin_document() {
    is_list_ = true;
    if (!is_line_list_) return;
    section_ = Section::Lines;
    depth_ = 1;
  }

  /// The next of the lists V, EV or V, FV, EV.
  void begin_list() {
    constexpr std::size_t kMostLists = 3;
    if (++lists_ > kMostLists) fail("more than three lists");
    section_ = lists_ == 1 ? Section::V : lists_ == 2 ? Section::FV : Section::EV;
  }

  bool in_point() const {
    return section_ == Section::Lines ? depth_ == kDepthInLines
                                      : section_ == Section::V && depth_ == kDepthInCell;
  }

  LarCells& cells() { return section_ == Section::EV ? edges_ : faces_; }

  std::uint32_t index(std::string_view text) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) fail("not an index", text);
    return value;
  }

  void add_coordinate(std::string_view text) {
    try {
      if (coordinates_ == 0) point_.x = numbers_.parse(text);
      if (coordinates_ == 1) point_.y = numbers_.parse(text);
    } catch (const Unusable& problem) {
      fail(problem.reason, problem.text);
    }
    ++coordinates_;
  }

  void end_point() {
    constexpr std::size_t kMostCoordinates = 3;
    if (coordinates_ < 2 || coordinates_ > kMostCoordinates) {
      fail("point of " + std::to_string(coordinates_) + " coordinates");
    }
    if (coordinates_ > 2) table_.note_other_coordinates("V", bytes_.place());
    points_.push_back(std::move(point_));
  }

  void end_segment() {
    if (points_.size() != points_before_ + 2) fail("line that has not two points");
    NumberPoint b = std::move(points_.back());
    points_.pop_back();
    table_.begin_feature();
    table_.add_segment("line", place_, std::move(points_.back()), std::move(b));
    points_.pop_back();
  }

  void draw() {
    if (!is_list_ && seen_ == 0) fail("neither V nor lines");
    if (lists_ == 2) take_edges_from_faces();
    refuse_isolated_points();
    for (std::size_t i = 0; i < edges_.cells.size(); ++i) draw_edge(i);
    if (lists_ != 2 && !edges_.cells.empty()) return;  // they bound the faces too
    draw_faces();
  }

  void refuse_isolated_points() {
    std::vector<bool> is_used(points_.size(), false);
    for (const LarCells* list : {&edges_, &faces_}) {
      for (const std::uint32_t index : list->vertices) {
        const std::uint32_t i = index - index_base_;  // a great one if there is no such vertex
        if (i < points_.size()) is_used[i] = true;
      }
    }
    const auto isolated = std::count(is_used.begin(), is_used.end(), false);
    if (isolated == 0) return;
    table_.refuse_points("V", {bytes_.file(), 0, 0}, static_cast<std::size_t>(isolated));
  }

  /// Of [V, EV] and [V, FV] alike the cells of two vertices are edges.
  void take_edges_from_faces() {
    LarCells faces;
    for (std::size_t i = 0; i < faces_.cells.size(); ++i) {
      const auto cell = faces_[i];
      LarCells& list = cell.size() == 2 ? edges_ : faces;
      list.vertices.insert(list.vertices.end(), cell.begin(), cell.end());
      list.cells.push_back({list.vertices.size(), faces_.cells[i].line, faces_.cells[i].column});
    }
    faces_ = std::move(faces);
  }

  const NumberPoint& vertex(std::uint32_t index, const Place& place) const {
    if (index >= index_base_ && index - index_base_ < points_.size()) {
      return points_[index - index_base_];
    }
    throw Error(ErrorCode::BadInput,
                "not LAR: no such vertex: " + std::to_string(points_.size()) +
                    " are counted from " + std::to_string(index_base_) +
                    " (a member index_base of 0 or 1 says from where)",
                place, std::to_string(index));
  }

  Place place_of(const LarCells::Cell& cell) const {
    return {bytes_.file(), cell.line, cell.column};
  }

  void draw_edge(std::size_t i) {
    const auto cell = edges_[i];
    const Place place = place_of(edges_.cells[i]);
    if (cell.size() != 2) {
      throw Error(ErrorCode::BadInput,
                  "not LAR: edge of " + std::to_string(cell.size()) + " vertices", place);
    }
    table_.begin_feature();
    table_.add_segment("EV", place, vertex(cell[0], place), vertex(cell[1], place));
  }

  /// As a model, so that edges are those that `edges` finds.
  void draw_faces() {
    if (faces_.cells.empty()) return;
    LarModel model;
    model.source = {0, faces_.cells[0].line, faces_.cells[0].column, "FV", {}, {}};
    model.cells.emplace_back();
    for (std::size_t i = 0; i < faces_.cells.size(); ++i) {
      std::vector<std::uint32_t> cell;
      for (const std::uint32_t index : faces_[i]) {
        vertex(index, place_of(faces_.cells[i]));
        cell.push_back(index - index_base_);
      }
      model.cells[0].push_back(cell);
    }
    for (NumberPoint& p : points_) {
      model.coordinates.push_back(std::move(p.x));
      model.coordinates.push_back(std::move(p.y));
    }
    table_.add_model(std::move(model));
  }

  ByteStream& bytes_;
  FeatureTable table_;
  Numbers& numbers_ = table_.numbers();
  Section section_ = Section::Other;
  std::string name_;   ///< of the member
  unsigned seen_ = 0;  ///< sections, as bits
  const bool is_line_list_;
  bool is_list_ = false;  ///< [V, EV] rather than {"V": ...}
  std::size_t lists_ = 0;
  std::size_t depth_ = 0;
  std::size_t ignored_ = 0;  ///< depth of open objects and arrays that are passed over
  std::uint32_t index_base_ = 0;
  NumberPoint point_;
  std::size_t coordinates_ = 0;
  std::size_t points_before_ = 0;  ///< the line
  Place place_;                    ///< of the cell
  std::vector<NumberPoint> points_;
  LarCells edges_, faces_;
};

}  // namespace

Structure read_lar_json(ByteStream& bytes, const FeatureOptions& options) {
  return LarJsonReader(bytes, options, false).read();
}

Structure read_line_list(ByteStream& bytes, const FeatureOptions& options) {
  return LarJsonReader(bytes, options, true).read();
}

Structure read_lar_json(std::string_view text, const std::string& file_name,
                        const ReadOptions& options) {
  const Place start{file_name, 1, 1};
  ByteStream beginning(text, start), bytes(text, start);
  const auto read =
      is_line_list(beginning) ? read_line_list : static_cast<FeatureReader>(read_lar_json);
  return read(bytes, feature_options(options));
}

}  // namespace plumbline
