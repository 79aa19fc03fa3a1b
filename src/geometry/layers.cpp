#include "plumbline/geometry/layers.hpp"

#include <algorithm>
#include <set>

#include "plumbline/error.hpp"

namespace plumbline {
namespace {

char in_lower_case(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// The end of the character of UTF-8 that begins here.
std::size_t next_character(std::string_view text, std::size_t i) {
  constexpr unsigned kLeading = 0xc0U, kFollowing = 0x80U;
  for (++i; i < text.size() && (static_cast<unsigned char>(text[i]) & kLeading) == kFollowing;) ++i;
  return i;
}

/// "A, B, ...": the first of the names.
std::string listed(const std::set<std::string>& names) {
  constexpr std::size_t kNamed = 20;
  std::string text;
  std::size_t count = 0;
  for (const std::string& name : names) {
    if (++count > kNamed) return text + ", ...";
    text += (text.empty() ? "\"" : ", \"") + name + '"';
  }
  return text;
}

}  // namespace

bool matches_pattern(std::string_view text, std::string_view pattern) {
  std::size_t t = 0, p = 0;
  // Behind the last star, and how far the text was when it stood for no more.
  std::size_t after_star = pattern.npos, star_end = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      after_star = ++p;
      star_end = t;
    } else if (p < pattern.size() && pattern[p] == '?') {
      t = next_character(text, t);
      ++p;
    } else if (p < pattern.size() && in_lower_case(pattern[p]) == in_lower_case(text[t])) {
      ++t;
      ++p;
    } else if (after_star != pattern.npos) {
      t = star_end = next_character(text, star_end);
      p = after_star;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == pattern.npos;
}

std::string_view own_layer_name(std::string_view layer) {
  const std::size_t bar = layer.rfind('|'), dollar = layer.rfind('$');
  if (bar != layer.npos && bar + 1 < layer.size()) return layer.substr(bar + 1);
  const bool is_bound = dollar != layer.npos && layer.find('$') < dollar;
  return is_bound && dollar + 1 < layer.size() ? layer.substr(dollar + 1) : layer;
}

bool is_layer(std::string_view layer, std::string_view pattern) {
  return matches_pattern(layer, pattern) || matches_pattern(own_layer_name(layer), pattern);
}

std::vector<bool> sources_on_layers(const SegmentSet& set,
                                    const std::vector<std::string>& patterns) {
  std::vector<bool> chosen;
  std::vector<bool> used(patterns.size());
  std::set<std::string> names;
  for (std::size_t s = 0; s < set.sources.size(); ++s) {
    const std::string layer = set.sources[s].layer;
    if (!layer.empty()) names.insert(layer);
    chosen.push_back(false);
    for (std::size_t i = 0; i < patterns.size(); ++i) {
      if (!is_layer(layer, patterns[i])) continue;
      chosen.back() = used[i] = true;
    }
  }
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused == used.end()) return chosen;
  throw Error(ErrorCode::BadInput,
              "no layer of this name; there are " + (names.empty() ? "none" : listed(names)),
              {set.files.empty() ? "" : set.files.front(), 0, 0},
              patterns[static_cast<std::size_t>(unused - used.begin())]);
}

SegmentSet on_layers(SegmentSet set, const std::vector<std::string>& patterns) {
  const std::vector<bool> chosen = sources_on_layers(set, patterns);
  SegmentList segments;
  std::vector<SourceId> sources;
  std::vector<double> rounding;
  std::vector<std::uint32_t> place;  // per segment, in the result
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    place.push_back(static_cast<std::uint32_t>(segments.size()));
    if (!chosen[set.segment_source[i]]) continue;
    const auto numbers = set.segments.numbers(i);
    segments.push_back({numbers[0], numbers[1]}, {numbers[2], numbers[3]});
    sources.push_back(set.segment_source[i]);
    if (i < set.rounding.size()) rounding.push_back(set.rounding[i]);
  }
  std::erase_if(set.rings, [&](Ring& ring) {
    if (ring.count == 0 || !chosen[set.segment_source[ring.first]]) return true;
    ring.first = place[ring.first];
    return false;
  });
  set.segments = std::move(segments);
  set.segment_source = std::move(sources);
  set.rounding = std::move(rounding);
  return set;
}

}  // namespace plumbline
