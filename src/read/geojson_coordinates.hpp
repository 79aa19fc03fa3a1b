#pragma once

#include <string>
#include <string_view>

#include "read/attribute.hpp"
#include "read/feature_table.hpp"
#include "read/json_events.hpp"

namespace plumbline {

/// The value of a member `coordinates`, whatever geometry it turns out to belong to: arrays of
/// arrays down to positions of two or more numbers.
class GeoJsonCoordinates {
 public:
  void clear();
  void open_array();
  /// Whether that closed the value.
  bool close_array();
  void scalar(JsonScalar kind, std::string_view text, Numbers& numbers);
  /// The coordinates hold something else, which is not drawn for this reason.
  void refuse(std::string reason, std::string text);

  /// Throws: Unusable where these are not positions in arrays nested `depth` deep.
  void check(std::size_t depth) const;
  const Polylines& lines() const { return lines_; }
  bool has_other_coordinates() const { return has_other_coordinates_; }

 private:
  void close_position();

  Polylines lines_;
  NumberPoint position_;
  std::size_t numbers_ = 0;         ///< in the innermost open array
  std::size_t depth_ = 0;           ///< of open arrays
  std::size_t position_depth_ = 0;  ///< of the positions so far; 0: there is none yet
  std::size_t empty_depth_ = 0;     ///< of the deepest empty array
  bool has_other_coordinates_ = false;
  Unusable problem_;  ///< the first; its reason is empty where there is none
};

}  // namespace plumbline
