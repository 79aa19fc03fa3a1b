#pragma once

#include <string>
#include <string_view>

#include "read/json_events.hpp"

namespace plumbline {

/// The member `crs` of a document, as GeoJSON had it before RFC 7946:
/// {"type": "name", "properties": {"name": ...}}.
class GeoJsonCrs {
 public:
  bool is_open() const { return depth_ > 0; }
  void open_object() {
    ++depth_;
    is_name_ = false;
  }
  void close_object() { --depth_; }
  void key(std::string_view name) { is_name_ = depth_ == 2 && name == "name"; }
  void scalar(JsonScalar kind, std::string_view text) {
    if (is_name_ && kind == JsonScalar::String) name_ = text;
  }
  /// Empty where there is none.
  const std::string& name() const { return name_; }

 private:
  std::size_t depth_ = 0;  ///< of open objects
  bool is_name_ = false;
  std::string name_;
};

}  // namespace plumbline
