// What edits did to faces, in words.

#include "output/text/edits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "output/text/terminal.hpp"
#include "output/text/verdict.hpp"
#include "plumbline/error.hpp"
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

std::vector<std::size_t> most_effective_first(const Repair& repair) {
  const std::vector<double> areas = effects(repair);
  std::vector<std::size_t> order(repair.edits.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (areas[a] != areas[b]) return areas[a] > areas[b];
    return repair.edits[a].squared_size > repair.edits[b].squared_size;
  });
  return order;
}

std::string place_text_of(const Point& where, const Rational& squared_size) {
  constexpr double kLeast = 1e-9;  // of the coordinates
  const PointD p = nearest(where);
  return place_text(where, std::max({nearest_sqrt(squared_size), kLeast * std::abs(p.x),
                                     kLeast * std::abs(p.y), 1e-300}));
}

std::string element_text(const SegmentSet& input, const std::vector<SegmentId>& segments) {
  const std::vector<SourceId> sources = sources_of(input, segments);
  if (sources.empty()) return "a new line";
  Source source = input.sources[sources.front()];
  source.path.clear();
  source.column = 0;
  std::vector<std::string> names;
  for (const std::string& file : input.files) names.push_back(file.substr(file.rfind('/') + 1));
  std::string text = to_text(source, names);
  if (!source.layer.empty()) text += " on " + source.layer;
  if (sources.size() > 1) text += fmt::format(" and {} more", sources.size() - 1);
  return line_text(text);
}

std::string to_text(const Tolerances& tolerances) {
  std::string text;
  for (const auto& [name, value] : {std::pair{"weld ", &tolerances.weld},
                                    {"grow ", &tolerances.grow},
                                    {"trim ", &tolerances.trim},
                                    {"sliver ", &tolerances.sliver},
                                    {"snap ", &tolerances.snap},
                                    {"simplify ", &tolerances.simplify}}) {
    text += name + (sgn(*value) == 0 ? "off" : tolerance_text(*value)) + ", ";
  }
  text += "doors ";
  if (!tolerances.doors) return text + "off";
  return text + tolerance_text(tolerances.doors->least) + ".." +
         tolerance_text(tolerances.doors->most);
}

}  // namespace plumbline
