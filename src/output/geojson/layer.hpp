#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/json/writer.hpp"
#include "output/text/verdict.hpp"

namespace plumbline::json {

// What layers of points have in common.

/// Null where there is no text.
inline std::optional<std::string> text(std::string words) {
  return words.empty() ? std::nullopt : std::optional(std::move(words));
}

/// The sources of segments, one after the other.
inline std::string sources_text(const SegmentSet& input, const std::vector<SegmentId>& segments) {
  std::string words;
  for (const SourceId source : sources_of(input, segments)) {
    words += (words.empty() ? "" : "; ") + to_text(input.sources[source], input.files);
  }
  return words;
}

inline auto point(const Point& p) {
  return object(member("type", "Point"), member("coordinates", nearest(p)));
}

/// The member `crs` of GeoJSON before RFC 7946, which readers still follow.
inline auto named(const std::string& crs) {
  return object(member("type", "name"), member("properties", object(member("name", crs))));
}

/// The whole document, of `count` features.
template <class F>
std::string layer(const SegmentSet& input, std::size_t count, F feature) {
  return document(object(member("type", "FeatureCollection"),
                         when(!input.crs.empty(), [&] { return member("crs", named(input.crs)); }),
                         member("features", list(count, feature))));
}

}  // namespace plumbline::json
