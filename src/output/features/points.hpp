#pragma once

#include <string>
#include <vector>

#include "output/text/verdict.hpp"
#include "plumbline/features.hpp"

// What layers of findings, defects and edits have in common.

namespace plumbline::features {

/// Nothing where there is no text.
inline FeatureValue text(std::string words) {
  return words.empty() ? FeatureValue() : FeatureValue(std::move(words));
}
inline FeatureValue number(std::size_t value) { return static_cast<std::int64_t>(value); }

/// The sources of segments, one after the other.
inline FeatureValue sources_text(const SegmentSet& input, const std::vector<SegmentId>& segments) {
  std::string words;
  for (const SourceId source : sources_of(input, segments)) {
    words += (words.empty() ? "" : "; ") + to_text(input.sources[source], input.files);
  }
  return text(std::move(words));
}

inline Feature point_at(const Point& where, std::vector<FeatureValue> values, std::string layer) {
  return {{{nearest(where)}}, std::move(values), std::move(layer)};
}

}  // namespace plumbline::features
