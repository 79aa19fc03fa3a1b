#include "read/geojson_properties.hpp"

#include <algorithm>
#include <array>

namespace plumbline {
namespace {

constexpr std::array<std::string_view, 7> kLabelNames{"name",      "label",    "title", "room",
                                                      "room_name", "roomname", "text"};

std::string in_lower_case(std::string_view name) {
  std::string lower(name);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

}  // namespace

void GeoJsonProperties::clear() {
  for (std::string* text : {&key_, &id_, &name_, &label_, &layer_}) text->clear();
  label_rank_ = kLabelNames.size();
}

void GeoJsonProperties::key(std::string_view name) { key_ = in_lower_case(name); }

void GeoJsonProperties::scalar(JsonScalar kind, std::string_view text) {
  if (kind != JsonScalar::String && kind != JsonScalar::Number) return;
  if (key_ == "id") id_ = text;
  if (key_ == "name") name_ = text;
  if (key_ == in_lower_case(layer_property_)) layer_ = text;
  const auto* const known = std::find(kLabelNames.begin(), kLabelNames.end(), key_);
  const auto rank = static_cast<std::size_t>(known - kLabelNames.begin());
  if (kind != JsonScalar::String || rank >= label_rank_ || text.empty()) return;
  label_rank_ = rank;
  label_ = text;
}

}  // namespace plumbline
