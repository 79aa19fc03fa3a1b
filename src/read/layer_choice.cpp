#include "read/layer_choice.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kNamedLayers = 20;

char in_lower_case(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// The end of the character of UTF-8 that begins here.
std::size_t next_character(std::string_view text, std::size_t i) {
  constexpr unsigned kLeading = 0xc0U, kFollowing = 0x80U;
  for (++i; i < text.size() && (static_cast<unsigned char>(text[i]) & kLeading) == kFollowing;) ++i;
  return i;
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

LayerChoice::LayerChoice(const std::vector<std::string>& layers,
                         const std::vector<std::string>& without) {
  for (const std::string& pattern : layers) wanted_.push_back({pattern});
  for (const std::string& pattern : without) unwanted_.push_back({pattern});
}

bool LayerChoice::match(std::vector<Pattern>& patterns, std::string_view name) {
  bool found = false;
  for (Pattern& pattern : patterns) {
    if (!matches_pattern(name, pattern.text)) continue;
    pattern.used = found = true;
  }
  return found;
}

bool LayerChoice::takes(std::string_view layer) {
  if (is_all()) return true;
  note(layer);
  const bool wanted = wants_all() || wants(layer);
  return !leaves_out(layer) && wanted;
}

void LayerChoice::note(std::string_view name) {
  if (is_all() || named_.size() > kNamedLayers || known_.contains(name)) return;
  known_.emplace(name);
  named_.emplace_back(name);
}

void LayerChoice::check(const std::string& file) const {
  const auto fail = [&](const Pattern& pattern) {
    std::string there;
    for (std::size_t i = 0; i < named_.size() && i < kNamedLayers; ++i) {
      there += (i == 0 ? "" : ", ") + (named_[i].empty() ? "\"\"" : named_[i]);
    }
    throw Error(
        ErrorCode::BadInput,
        "no layer of this name; there " +
            (there.empty() ? "are none"
                           : "are " + there + (named_.size() > kNamedLayers ? ", ..." : "")),
        {file, 0, 0}, pattern.text);
  };
  for (const auto* patterns : {&wanted_, &unwanted_}) {
    for (const Pattern& pattern : *patterns) {
      if (!pattern.used) fail(pattern);
    }
  }
}

}  // namespace plumbline
