#include "read/layer_choice.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kNamedLayers = 20;

}  // namespace

LayerChoice::LayerChoice(const std::vector<std::string>& layers,
                         const std::vector<std::string>& without) {
  for (const std::string& pattern : layers) wanted_.push_back({pattern});
  for (const std::string& pattern : without) unwanted_.push_back({pattern});
}

bool LayerChoice::match(std::vector<Pattern>& patterns, std::string_view name) {
  bool found = false;
  for (Pattern& pattern : patterns) {
    if (!is_layer(name, pattern.text)) continue;
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
      there += (i == 0 ? "\"" : ", \"") + named_[i] + '"';
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
