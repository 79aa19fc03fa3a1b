// What edits did to faces, in words.

#include "output/text/edits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "output/text/terminal.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

std::string area(const Rational& value) { return short_number(nearest_double(value)); }

/// Outcomes of one fate and edit, those that belong together one after the other: parts of one
/// face, or what went into one.
std::string together(const std::vector<const FaceOutcome*>& outcomes, FaceFate fate) {
  std::string text;
  const FaceOutcome* last = nullptr;
  for (const FaceOutcome* outcome : outcomes) {
    const bool goes_on =
        last != nullptr && fate == FaceFate::Split && last->before == outcome->before;
    if (goes_on) {
      text += " + " + area(outcome->area_after);
    } else {
      text += (text.empty() ? to_text(fate) + ' ' : ", ");
      switch (fate) {
        case FaceFate::Closed:
          text += area(outcome->area_after);
          break;
        case FaceFate::Split:
          text += area(outcome->area_after);
          break;
        case FaceFate::Opened:
          text += area(outcome->area_before);
          break;
        case FaceFate::Joined:
        case FaceFate::Changed:
          text += area(outcome->area_before) + " -> " + area(outcome->area_after);
          break;
      }
    }
    last = outcome;
  }
  return text;
}

std::string text_of(std::vector<const FaceOutcome*> outcomes, std::size_t most) {
  const std::size_t more = outcomes.size() - std::min(outcomes.size(), most);
  outcomes.resize(outcomes.size() - more);
  std::string text;
  for (std::size_t i = 0; i < outcomes.size();) {
    const FaceFate fate = outcomes[i]->fate;
    std::vector<const FaceOutcome*> same;
    for (; i < outcomes.size() && outcomes[i]->fate == fate; ++i) same.push_back(outcomes[i]);
    text += (text.empty() ? "" : "; ") + together(same, fate);
  }
  return more > 0 ? text + fmt::format(" and {} more", more) : text;
}

}  // namespace

std::vector<SegmentId> segments_of(const Edit& edit) {
  std::vector<SegmentId> all;
  for (const auto* lines : {&edit.before, &edit.after}) {
    for (const Line& line : *lines) {
      all.insert(all.end(), line.segments.begin(), line.segments.end());
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<std::string> room_texts(const Repair& repair, std::size_t most) {
  std::vector<std::vector<const FaceOutcome*>> of_edit(repair.edits.size());
  for (const FaceOutcome& outcome : repair.faces) {
    for (const std::size_t e : outcome.edits) of_edit.at(e).push_back(&outcome);
  }
  std::vector<std::string> texts;
  for (auto& outcomes : of_edit) {
    std::stable_sort(outcomes.begin(), outcomes.end(), [](const auto* a, const auto* b) {
      return std::tie(a->fate, a->before) < std::tie(b->fate, b->before);
    });
    texts.push_back(text_of(std::move(outcomes), most));
  }
  return texts;
}

std::vector<double> effects(const Repair& repair) {
  std::vector<double> areas(repair.edits.size());
  for (const FaceOutcome& outcome : repair.faces) {
    const bool is_change = outcome.fate == FaceFate::Changed;
    const double size = is_change
                            ? std::abs(nearest_double(outcome.area_after - outcome.area_before))
                        : outcome.fate == FaceFate::Opened || outcome.fate == FaceFate::Joined
                            ? nearest_double(outcome.area_before)
                            : nearest_double(outcome.area_after);
    for (const std::size_t e : outcome.edits) areas.at(e) += size;
  }
  return areas;
}

std::string to_text(const Tolerances& tolerances) {
  std::string text;
  for (const auto& [name, value] : {std::pair{"weld ", &tolerances.weld},
                                    {"grow ", &tolerances.grow},
                                    {"trim ", &tolerances.trim},
                                    {"sliver ", &tolerances.sliver},
                                    {"snap ", &tolerances.snap},
                                    {"simplify ", &tolerances.simplify}}) {
    text += name + (sgn(*value) == 0 ? "off" : exact_text(*value)) + ", ";
  }
  text += "doors ";
  if (!tolerances.doors) return text + "off";
  return text + exact_text(tolerances.doors->least) + ".." + exact_text(tolerances.doors->most);
}

}  // namespace plumbline
