#include "read/svg/selection.hpp"

#include "read/svg/style.hpp"

namespace plumbline {

bool SvgSelection::leaves_out(const pugi::xml_node& element, SvgKind kind, bool visible,
                              bool wanted, const std::string& path) {
  const bool draws = kind != SvgKind::Container;
  Unusable problem{{}, {}, true};
  if (std::string_view(element.attribute("data-plumbline").value()) == "legend") {
    problem.reason = "legend of a picture";
  } else if (!draws_hidden_ && !is_displayed(element)) {
    problem = {"hidden", "display: none", true};
  } else if (is_named(element, &LayerChoice::leaves_out)) {
    problem.reason = "left out as asked";
  } else if (!draws_hidden_ && draws && !visible) {
    problem = {"hidden", "visibility: hidden", true};
  } else if (draws && !wanted) {
    problem.reason = "not on a layer that was asked for";
  } else {
    return false;
  }
  count(element, path, std::move(problem));
  return true;
}

/// By its label or its id.
bool SvgSelection::is_named(const pugi::xml_node& element,
                            bool (LayerChoice::*names)(std::string_view)) {
  if (choice_.is_all()) return false;
  const std::string_view label = element.attribute("inkscape:label").value();
  const std::string_view id = element.attribute("id").value();
  if (local_name(element) == "g") choice_.note(label.empty() ? id : label);
  // Both, so that each pattern that matches is known to.
  const bool has_label = !label.empty() && (choice_.*names)(label);
  return (!id.empty() && (choice_.*names)(id)) || has_label;
}

void SvgSelection::count(const pugi::xml_node& element, const std::string& path, Unusable problem) {
  const std::size_t count = count_drawn(element);
  if (count == 0) return;
  const auto [found, is_new] =
      index_.try_emplace({path, problem.reason + ": " + problem.text}, counts_.size());
  if (is_new) counts_.push_back({{element, path, std::move(problem)}, 0});
  counts_[found->second].count += count;
}

std::vector<SvgSelection::Item> SvgSelection::left_out(const std::string& file) const {
  choice_.check(file);
  std::vector<Item> result;
  for (const Count& count : counts_) {
    result.push_back(count.item);
    if (count.count == 1) continue;
    result.back().problem.reason += " (" + std::to_string(count.count) + " of them)";
  }
  return result;
}

}  // namespace plumbline
