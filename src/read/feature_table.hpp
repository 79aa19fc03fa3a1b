#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumbline/error.hpp"
#include "plumbline/structure.hpp"
#include "read/attribute.hpp"
#include "read/geometries.hpp"
#include "read/layer_choice.hpp"
#include "read/model_tail.hpp"
#include "read/rejections.hpp"
#include "structure/words.hpp"

namespace plumbline {

/// The lines of one geometry: successive points up to each end are joined.
struct Polylines {
  std::vector<NumberPoint> points;
  std::vector<std::size_t> ends;          ///< of each line, an index into `points`, ascending
  std::vector<std::size_t> polygon_ends;  ///< of each polygon, an index into `ends`, ascending

  void clear() {
    points.clear();
    ends.clear();
    polygon_ends.clear();
  }
  /// Ends a line here.
  void end_line() { ends.push_back(points.size()); }
  /// Ends a polygon, of all rings since the one before it.
  void end_polygon() { polygon_ends.push_back(ends.size()); }
};

/// Collects the elements of a drawing without hierarchy into tables, one for each kind of element;
/// each part of a feature, a line or a polygon, is an element. 80 bytes for each element of one
/// segment, and its id.
class FeatureTable {
 public:
  /// Lines and rings go to the options' geometries instead, where there are some.
  FeatureTable(const std::string& file_name, const FeatureOptions& options);

  /// What is added from here on belongs to one feature.
  void begin_feature();
  /// Ends the feature: what was added since begin_feature gets its id, parts of several "id/1",
  /// "id/2", ..., or their numbers where there is no id. A label names its polygons and stands at
  /// its points, of which those without are refused.
  void name_feature(std::string_view id, std::string_view label = {});
  /// Ends it, after that, with its layer, where the format has layers: what is on others than the
  /// options ask for is dropped.
  void place_feature(std::string_view layer);
  /// Adds an element for each line. Lines of one point are refused.
  void add_lines(std::string_view element, const Place& place, const Polylines& lines);
  /// The same for each polygon of rings, which are drawn as they are; those that are not closed are
  /// listed.
  void add_rings(std::string_view element, const Place& place, const Polylines& rings);
  /// An element that is one segment.
  void add_segment(std::string_view element, const Place& place, NumberPoint a, NumberPoint b);
  /// Points that a label of the feature may stand at.
  void add_points(std::string_view element, const Place& place, const Polylines& points);
  /// Lists isolated points, which no reader draws.
  void refuse_points(std::string_view element, const Place& place, std::size_t count);
  void refuse(std::string_view element, const Place& place, const Unusable& problem,
              std::string_view id = {});
  /// Says something of an element that is drawn.
  void remark(std::string_view element, const Place& place, const std::string& what,
              const std::string& text);
  /// Counts an element with coordinates other than x and y, which are not used.
  void note_other_coordinates(std::string_view element, const Place& place);

  /// Coordinates from here on are in this reference system. One that differs from that of others is
  /// listed.
  void note_crs(std::string_view element, const Place& place, std::string_view name);
  /// The same by its number; 0 stands for an unknown one.
  void note_srid(std::string_view element, const Place& place, std::string_view digits);

  /// Adds a model as it is.
  void add_model(LarModel model) { models_.push_back(std::move(model)); }

  /// Makes the numbers of the file.
  Numbers& numbers() { return numbers_; }

  Structure finish() &&;

 private:
  /// An open table, and how much of it was there before the feature.
  struct Table {
    Model model;
    TableSize before_feature;
  };

  /// A part of the feature that has a row.
  struct Part {
    std::size_t table;  ///< index into open_
    std::size_t row;
    std::size_t number;  ///< from 1
  };

  /// Points of the feature.
  struct Points {
    std::string element;
    Place place;
    std::vector<NumberPoint> points;
  };
  /// What is not read of a layer.
  struct LeftOut {
    Source first;
    std::size_t count = 0;
  };

  void add_label(std::string_view label);
  Model& table_of_layer(const Source& source);
  void count_left_out(const std::string& layer, const Model& dropped);
  std::size_t table(std::string_view element);
  void add_parts(std::string_view element, const Place& place, const Polylines& lines,
                 const std::vector<std::size_t>& part_ends, bool are_rings);
  bool is_kept(std::string_view element, const Place& place, const Polylines& lines);
  void keep_lines(const Polylines& lines);
  void keep_polygons(const Polylines& rings);
  static void add_row(Model& model, const Place& place, std::size_t segment_count);
  static Source source_of(std::string_view element, const Place& place);

  Geometries* geometries_;
  Numbers numbers_;
  CountBudget budget_;
  std::vector<std::string> files_;
  std::string crs_;
  std::vector<Table> open_;
  std::size_t part_count_ = 0;  ///< of the feature
  std::vector<Part> parts_;     ///< those of them that are drawn
  std::vector<Points> points_;  ///< of the feature
  LayerChoice choice_;
  std::vector<Model> layered_;  ///< tables of one layer
  std::map<std::pair<std::string, std::string>, std::size_t> layered_index_;  ///< element, layer
  std::map<std::string, LeftOut> left_out_;                                   ///< by layer
  std::vector<Model> full_;
  std::vector<LarModel> models_;
  Rejections rejections_, remarks_;
  Source first_with_other_coordinates_;
  std::uint64_t with_other_coordinates_ = 0;
};

}  // namespace plumbline
