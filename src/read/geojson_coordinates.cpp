#include "read/geojson_coordinates.hpp"

#include <algorithm>
#include <utility>

namespace plumbline {

void GeoJsonCoordinates::clear() {
  lines_.clear();
  numbers_ = depth_ = position_depth_ = empty_depth_ = 0;
  has_other_coordinates_ = false;
  problem_ = {};
}

void GeoJsonCoordinates::refuse(std::string reason, std::string text) {
  if (problem_.reason.empty()) problem_ = {std::move(reason), std::move(text)};
}

void GeoJsonCoordinates::open_array() {
  if (numbers_ > 0) refuse("coordinates hold an array beside numbers", {});
  numbers_ = 0;
  ++depth_;
}

bool GeoJsonCoordinates::close_array() {
  if (numbers_ > 0) {
    close_position();
  } else if (position_depth_ != 0 && depth_ + 1 == position_depth_) {
    if (lines_.points.size() > (lines_.ends.empty() ? 0 : lines_.ends.back())) lines_.end_line();
  } else if (position_depth_ != 0 && depth_ + 2 == position_depth_) {
    lines_.end_polygon();
  } else if (position_depth_ == 0 || depth_ >= position_depth_) {
    empty_depth_ = std::max(empty_depth_, depth_);
  }
  numbers_ = 0;
  return --depth_ == 0;
}

void GeoJsonCoordinates::close_position() {
  if (numbers_ < 2) refuse("position of one number", {});
  if (numbers_ > 2) has_other_coordinates_ = true;
  if (position_depth_ == 0) position_depth_ = depth_;
  if (depth_ != position_depth_) refuse("positions are nested unevenly", {});
  lines_.points.push_back(std::move(position_));
}

void GeoJsonCoordinates::scalar(JsonScalar kind, std::string_view text, Numbers& numbers) {
  if (kind != JsonScalar::Number) {
    refuse("coordinates hold something other than numbers", std::string(text.substr(0, 100)));
    return;
  }
  try {
    if (numbers_ == 0) position_.x = numbers.parse(text);
    if (numbers_ == 1) position_.y = numbers.parse(text);
  } catch (const Unusable& problem) {
    refuse(problem.reason, problem.text);
  }
  ++numbers_;
}

void GeoJsonCoordinates::check(std::size_t depth) const {
  if (!problem_.reason.empty()) throw problem_;
  if (empty_depth_ >= depth) throw Unusable{"position without numbers", {}};
  if (position_depth_ != 0 && position_depth_ != depth) {
    throw Unusable{"coordinates are nested " + std::to_string(position_depth_) + " deep, not " +
                       std::to_string(depth),
                   {}};
  }
}

}  // namespace plumbline
