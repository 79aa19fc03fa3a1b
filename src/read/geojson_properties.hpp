#pragma once

#include <string>
#include <string_view>

#include "read/json_events.hpp"

namespace plumbline {

/// What the properties of a feature say that is used, whatever the case of their names: id and
/// name, what its closed shapes or points are called, and its layer.
class GeoJsonProperties {
 public:
  /// The layer is in the property of this name.
  explicit GeoJsonProperties(std::string layer_property)
      : layer_property_(std::move(layer_property)) {}

  /// Begins a feature.
  void clear();
  /// Begins the property of this name.
  void key(std::string_view name);
  void scalar(JsonScalar kind, std::string_view text);

  /// The id, else the name.
  const std::string& id() const { return id_.empty() ? name_ : id_; }
  /// The text of the first of name, label, title, room, room_name, roomname, text that is a string.
  const std::string& label() const { return label_; }
  const std::string& layer() const { return layer_; }

 private:
  std::string layer_property_;
  std::string key_;
  std::string id_, name_, label_, layer_;
  std::size_t label_rank_ = 0;
};

}  // namespace plumbline
