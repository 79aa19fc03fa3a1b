#include "read/feature_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "read/byte_stream.hpp"

namespace plumbline {
namespace {

/// A table is closed at this many segments, so that growing never copies much.
constexpr std::size_t kFullTable = std::size_t{1} << 16U;

/// "1 point", "2 points"
std::string count_of(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

/// The id as a line of valid UTF-8. Long ones are cut.
std::string line_of(std::string_view id) {
  std::string line = valid_line(id.substr(0, kMaxPathText));
  return id.size() <= kMaxPathText ? line : line + "...";
}

std::vector<PointD> rounded(const Polylines& lines, std::size_t begin, std::size_t end) {
  std::vector<PointD> result;
  result.reserve(end - begin);
  for (std::size_t i = begin; i < end; ++i) result.push_back(nearest(lines.points[i]));
  return result;
}

}  // namespace

FeatureTable::FeatureTable(const std::string& file_name, const FeatureOptions& options)
    : geometries_(options.geometries),
      numbers_(options.shortest_decimals),
      budget_(options.max_segments, "segments"),
      files_{file_name},
      choice_(options.layers, options.without_layers) {}

void FeatureTable::begin_feature() {
  part_count_ = 0;
  parts_.clear();
  points_.clear();
  for (auto table = open_.begin(); table != open_.end();) {
    table->before_feature = size_of(table->model);
    if (table->model.segments.size() >= kFullTable) {
      full_.push_back(std::move(table->model));
      table = open_.erase(table);
    } else {
      ++table;
    }
  }
}

void FeatureTable::name_feature(std::string_view id, std::string_view label) {
  add_label(label);
  if (part_count_ > 1) {
    const std::string prefix = id.empty() ? std::string() : line_of(id) + "/";
    for (const Part& part : parts_) {
      Model& model = open_[part.table].model;
      model.row_ids.push_back(prefix + std::to_string(part.number));
      model.rows[part.row].id = static_cast<std::uint32_t>(model.row_ids.size());
    }
    return;
  }
  if (id.empty()) return;
  for (Table& table : open_) {
    Model& model = table.model;
    if (table.before_feature.rows == model.rows.size()) continue;
    model.row_ids.push_back(line_of(id));
    for (std::size_t i = table.before_feature.rows; i < model.rows.size(); ++i) {
      model.rows[i].id = static_cast<std::uint32_t>(model.row_ids.size());
    }
  }
}

void FeatureTable::add_label(std::string_view label) {
  for (const Points& item : points_) {
    if (label.empty() || geometries_ != nullptr) {
      refuse_points(item.element, item.place, item.points.size());
      continue;
    }
    ++part_count_;
    const std::size_t index = table(item.element);
    Model& model = open_[index].model;
    parts_.push_back({index, model.rows.size(), part_count_});
    for (const NumberPoint& place : item.points) {
      model.labels.push_back(
          {line_of(label), place, static_cast<std::uint32_t>(model.rows.size())});
    }
    add_row(model, item.place, 0);
  }
  if (label.empty()) return;
  for (Table& table : open_) {
    if (!table.model.source.element.ends_with("Polygon")) continue;
    for (std::size_t i = table.before_feature.rows; i < table.model.rows.size(); ++i) {
      table.model.labels.push_back({line_of(label), {}, static_cast<std::uint32_t>(i)});
    }
  }
}

void FeatureTable::place_feature(std::string_view layer) {
  const std::string name = line_of(layer);
  const bool is_taken = choice_.takes(name);
  if (is_taken && name.empty()) return;
  for (Table& table : open_) {
    if (table.before_feature.rows == table.model.rows.size()) continue;
    Model part = split_off(table.model, table.before_feature);
    part.source.layer = name;
    if (is_taken) {
      append(table_of_layer(part.source), part);
    } else {
      count_left_out(name, part);
    }
  }
}

void FeatureTable::count_left_out(const std::string& layer, const Model& dropped) {
  LeftOut& left_out = left_out_[layer];
  if (left_out.count == 0) {
    const Model::Row& row = dropped.rows.front();
    left_out.first = {0, row.line, row.column, dropped.source.element, {}, {}, layer};
  }
  left_out.count += dropped.rows.size();
}

/// The open table of this element and layer.
Model& FeatureTable::table_of_layer(const Source& source) {
  const auto [found, is_new] =
      layered_index_.try_emplace({source.element, source.layer}, layered_.size());
  if (is_new) layered_.emplace_back().source = source;
  Model& model = layered_[found->second];
  if (model.segments.size() >= kFullTable) {
    full_.push_back(std::exchange(model, Model{}));
    model.source = source;
  }
  return model;
}

std::size_t FeatureTable::table(std::string_view element) {
  const auto known = std::find_if(open_.begin(), open_.end(), [element](const Table& table) {
    return table.model.source.element == element;
  });
  if (known == open_.end()) {
    open_.emplace_back();
    open_.back().model.source.element = element;
    return open_.size() - 1;
  }
  return static_cast<std::size_t>(known - open_.begin());
}

Source FeatureTable::source_of(std::string_view element, const Place& place) {
  return {0, place.line, place.column, line_of(element), {}, {}};
}

void FeatureTable::add_row(Model& model, const Place& place, std::size_t segment_count) {
  model.rows.push_back({place.line, place.column, static_cast<std::uint32_t>(segment_count), 0});
}

/// Whether all points are doubles; if not, the element is refused.
bool FeatureTable::is_kept(std::string_view element, const Place& place, const Polylines& lines) {
  for (const NumberPoint& p : lines.points) {
    const PointD q = nearest(p);
    if (std::isfinite(q.x) && std::isfinite(q.y)) continue;
    refuse(element, place, {"a coordinate is beyond the largest double", {}});
    return false;
  }
  return true;
}

void FeatureTable::keep_lines(const Polylines& lines) {
  std::size_t begin = 0;
  for (const std::size_t end : lines.ends) {
    geometries_->lines.push_back(rounded(lines, begin, end));
    begin = end;
  }
}

void FeatureTable::keep_polygons(const Polylines& rings) {
  std::size_t ring = 0, begin = 0;
  for (const std::size_t polygon_end : rings.polygon_ends) {
    Geometries::Polygon& polygon = geometries_->polygons.emplace_back();
    for (; ring < polygon_end; ++ring) {
      polygon.rings.push_back(rounded(rings, begin, rings.ends[ring]));
      begin = rings.ends[ring];
    }
  }
}

void FeatureTable::add_lines(std::string_view element, const Place& place, const Polylines& lines) {
  if (geometries_ != nullptr) {
    if (lines.points.empty()) refuse(element, place, {"has no points", {}, true});
    if (is_kept(element, place, lines)) keep_lines(lines);
    return;
  }
  add_parts(element, place, lines, {}, false);
}

/// Adds a part up to each end, an index into `lines.ends`, and one for each line behind the last,
/// as rings or as lines.
void FeatureTable::add_parts(std::string_view element, const Place& place, const Polylines& lines,
                             const std::vector<std::size_t>& part_ends, bool are_rings) {
  const std::size_t table_index = table(element);
  Model& model = open_[table_index].model;
  const bool is_one_polygon = element == "MultiPolygon";
  std::size_t single_points = 0, begin = 0, line = 0;
  for (std::size_t part = 0; line < lines.ends.size(); ++part) {
    ++part_count_;
    const std::size_t before = model.segments.size();
    RingRole role = part >= part_ends.size()     ? RingRole::Line
                    : part > 0 && is_one_polygon ? RingRole::Part
                                                 : RingRole::Polygon;
    for (const std::size_t end = part < part_ends.size() ? part_ends[part] : line + 1; line < end;
         ++line) {
      const std::size_t line_end = lines.ends[line];
      const std::size_t first = model.segments.size();
      if (line_end > begin) budget_.spend(line_end - begin - 1);
      for (std::size_t i = begin; i + 1 < line_end; ++i) {
        model.segments.push_back(lines.points[i], lines.points[i + 1]);
      }
      if (line_end - begin == 1) ++single_points;
      if (are_rings && line_end - begin > 1) {
        model.rings.push_back({static_cast<std::uint32_t>(first),
                               static_cast<std::uint32_t>(line_end - begin - 1), role});
      }
      if (are_rings && role != RingRole::Line) role = RingRole::Hole;
      begin = line_end;
    }
    if (model.segments.size() == before) continue;
    parts_.push_back({table_index, model.rows.size(), part_count_});
    add_row(model, place, model.segments.size() - before);
  }
  if (single_points > 0) {
    refuse(element, place, {"line of a single point", count_of(single_points, "line"), true});
  }
  if (lines.points.empty()) refuse(element, place, {"has no points", {}, true});
}

void FeatureTable::add_rings(std::string_view element, const Place& place, const Polylines& rings) {
  std::size_t open_rings = 0;
  std::size_t begin = 0;
  for (const std::size_t end : rings.ends) {
    if (end - begin > 1 && rings.points[begin] != rings.points[end - 1]) ++open_rings;
    begin = end;
  }
  const bool are_faces = geometries_ != nullptr && !rings.polygon_ends.empty();
  if (open_rings > 0) {
    remark(element, place,
           are_faces ? "ring is not closed; it is taken as closed"
                     : "ring is not closed; it is drawn as it is",
           count_of(open_rings, "ring"));
  }
  if (geometries_ == nullptr) return add_parts(element, place, rings, rings.polygon_ends, true);
  if (!are_faces) return add_lines(element, place, rings);
  if (is_kept(element, place, rings)) keep_polygons(rings);
}

void FeatureTable::add_segment(std::string_view element, const Place& place, NumberPoint a,
                               NumberPoint b) {
  if (geometries_ != nullptr) {
    Polylines line;
    line.points = {std::move(a), std::move(b)};
    line.end_line();
    return add_lines(element, place, line);
  }
  Model& model = open_[table(element)].model;
  budget_.spend(1);
  model.segments.push_back(std::move(a), std::move(b));
  add_row(model, place, 1);
}

void FeatureTable::add_points(std::string_view element, const Place& place,
                              const Polylines& points) {
  points_.push_back({line_of(element), place, points.points});
}

void FeatureTable::refuse_points(std::string_view element, const Place& place, std::size_t count) {
  refuse(element, place, {"isolated points are not drawn", count_of(count, "point"), true});
}

void FeatureTable::refuse(std::string_view element, const Place& place, const Unusable& problem,
                          std::string_view id) {
  Source source = source_of(element, place);
  source.id = line_of(id);
  rejections_.add(source, problem.reason, problem.text, problem.harmless);
}

void FeatureTable::remark(std::string_view element, const Place& place, const std::string& what,
                          const std::string& text) {
  remarks_.add(source_of(element, place), what, text);
}

void FeatureTable::note_other_coordinates(std::string_view element, const Place& place) {
  if (with_other_coordinates_++ == 0) first_with_other_coordinates_ = source_of(element, place);
}

void FeatureTable::note_crs(std::string_view element, const Place& place, std::string_view name) {
  const std::string crs = line_of(name);
  if (crs_.empty()) crs_ = crs;
  if (crs == crs_) return;
  remark(element, place, "another reference system than " + crs_ + "; it is drawn as it is", crs);
}

void FeatureTable::note_srid(std::string_view element, const Place& place,
                             std::string_view digits) {
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  if (!digits.empty()) note_crs(element, place, "EPSG:" + std::string(digits));
}

Structure FeatureTable::finish() && {
  Structure structure;
  structure.crs = std::move(crs_);
  structure.files = std::move(files_);
  structure.y_up = true;
  structure.root = StructId(0);
  structure.structs.resize(1);
  if (with_other_coordinates_ > 0) {
    remarks_.add(first_with_other_coordinates_, "coordinates beyond x and y are not used",
                 count_of(with_other_coordinates_, "element") + " from here on");
  }
  choice_.check(structure.files[0]);
  for (const auto& [layer, left_out] : left_out_) {
    rejections_.add(left_out.first, "left out as asked: what is on layer " + layer,
                    count_of(left_out.count, "element"), true);
  }
  structure.rejected = std::move(rejections_).finish();
  for (Rejected& item : std::move(remarks_).finish()) {
    structure.remarks.push_back(
        {std::move(item.source), std::move(item.reason), std::move(item.text)});
  }
  numbers_.add_to(structure.ledger);
  auto& body = structure.structs[0].body;
  body.reserve(full_.size() + open_.size() + layered_.size() +
               models_.size());  // growing would copy: Affine has no noexcept move
  for (Model& model : full_) body.emplace_back(std::move(model));
  for (Table& table : open_) {
    if (!table.model.rows.empty()) body.emplace_back(std::move(table.model));
  }
  for (Model& model : layered_) body.emplace_back(std::move(model));
  for (LarModel& model : models_) body.emplace_back(std::move(model));
  return structure;
}

}  // namespace plumbline
