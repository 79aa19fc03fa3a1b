// A group of findings in the words of one who looks at a drawing.

#include "output/text/groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "output/text/terminal.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kShownKinds = 3;
constexpr std::size_t kShownAreas = 2;
constexpr std::size_t kManyFindings = 8;

std::string plural(CellKind kind) {
  return kind == CellKind::Vertex ? "vertices" : to_text(kind) + 's';
}

/// "area 3.5, 0.2"; of more than a few "largest 3.5".
std::string areas_text(std::vector<double> areas) {
  std::sort(areas.rbegin(), areas.rend());
  if (areas.size() > kShownAreas) return fmt::format("largest {:.4g}", areas.front());
  std::string text = "area ";
  for (std::size_t i = 0; i < areas.size(); ++i) {
    text += fmt::format("{}{:.4g}", i == 0 ? "" : ", ", areas[i]);
  }
  return text;
}

/// "3 faces lost (largest 3.5)"; of reshaped ones by how much.
std::string changes_text(FaceChange change, const std::vector<const ChangedFaces*>& changes) {
  std::size_t faces = 0;
  double disputed = 0;
  std::vector<double> areas;
  for (const ChangedFaces* changed : changes) {
    faces += std::max<std::size_t>(changed->areas.size(), 1);
    disputed += changed->area;
    areas.insert(areas.end(), changed->areas.begin(), changed->areas.end());
  }
  std::string text = fmt::format("{} face{} {}", faces, faces == 1 ? "" : "s", to_text(change));
  if (change == FaceChange::Joined) text += fmt::format(" into {}", changes.size());
  if (change == FaceChange::Reshaped) {
    return disputed > 0 ? text + fmt::format(" (by {:.4g} of area)", disputed) : text;
  }
  return areas.empty() ? text : text + fmt::format(" ({})", areas_text(std::move(areas)));
}

/// Counts of what is not about faces, unless that is all there is.
std::string line_work_text(const FindingGroup& group, const Check& check) {
  std::vector<const Finding*> findings;
  for (const std::size_t number : group.findings) {
    const Finding& finding = check.comparison.findings[number - 1];
    const bool is_told = finding.kind == CellKind::Face &&
                         finding.disagreement != Disagreement::Invalid && !group.faces.empty();
    if (!is_told) findings.push_back(&finding);
  }
  return kinds(findings);
}

std::string where_text(const FindingGroup& group, const Check& check) {
  const Finding& lead = check.comparison.findings[group.lead - 1];
  if (lead.kind == CellKind::Complex) return "";
  std::string text = "at " + place_text(lead.where, check.comparison.tolerance);
  const double size = std::hypot(group.high.x - group.low.x, group.high.y - group.low.y);
  if (size > check.comparison.tolerance) text += fmt::format(", {:.3g} across", size);
  return text;
}

/// A radius with which none of the findings was there, if there is one for each.
std::optional<double> radius_without(const FindingGroup& group, const Check& check) {
  std::optional<double> least;
  for (const std::size_t number : group.findings) {
    if (number > check.causes.size()) return {};
    const auto& radius = check.causes[number - 1].radius_without;
    if (!radius) return {};
    if (!least || *radius < *least) least = radius;
  }
  return least;
}

/// "prune: merging within ...; gone with radius 0.001".
std::string cause_text(const FindingGroup& group, const Check& check) {
  if (group.lead > check.causes.size()) return "";
  const Cause& cause = check.causes[group.lead - 1];
  std::set<std::string> stages;
  for (const std::size_t number : group.findings) {
    const Cause& known = check.causes[number - 1];
    stages.insert(known.stage);
    for (const Cause& other : known.with) stages.insert(other.stage);
  }
  stages.erase(cause.stage);
  std::string text = cause.stage, others;
  for (const std::string& stage : stages) others += (others.empty() ? "" : " and ") + stage;
  if (!others.empty()) text += " (also " + others + ")";
  text += group.findings.size() > kManyFindings ? ", for example: " : ": ";
  text += cause.explanation;
  if (check.right_radii && !check.right_radii->empty()) return text;  // one radius for all groups
  if (const auto radius = radius_without(group, check)) {
    text += "; not so with radius " + shortest_text(*radius);
  } else if (!cause.advice.empty() && !cause.distance) {
    text += "; " + cause.advice;
  }
  return text;
}

/// What happened, what it is made of, where; the last two in one.
std::pair<std::string, std::string> event_texts(const FindingGroup& group, const Check& check) {
  std::string what = faces_text(group), more = line_work_text(group, check);
  if (what.empty()) std::swap(what, more);
  const std::string where = where_text(group, check);
  if (!more.empty() && !where.empty()) more += "; ";
  return {what, more + where};
}

}  // namespace

std::string kinds(const std::vector<const Finding*>& findings) {
  std::map<std::pair<CellKind, Disagreement>, std::size_t> counts;
  for (const Finding* finding : findings) ++counts[{finding->kind, finding->disagreement}];
  std::vector<std::pair<std::pair<CellKind, Disagreement>, std::size_t>> sorted(counts.begin(),
                                                                                counts.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (std::size_t i = 0; i < std::min(sorted.size(), kShownKinds); ++i) {
    const auto& [kind, count] = sorted[i];
    text +=
        fmt::format("{}{} {} {}", i == 0 ? "" : ", ", count,
                    count == 1 ? to_text(kind.first) : plural(kind.first), to_text(kind.second));
  }
  return sorted.size() > kShownKinds ? text + ", ..." : text;
}

std::string faces_text(const FindingGroup& group) {
  constexpr std::array kOrder = {FaceChange::Opened,  FaceChange::Lost,   FaceChange::Joined,
                                 FaceChange::Parted,  FaceChange::Closed, FaceChange::Added,
                                 FaceChange::Reshaped};
  std::string text;
  for (const FaceChange change : kOrder) {
    std::vector<const ChangedFaces*> changes;
    for (const ChangedFaces& faces : group.faces) {
      if (faces.change == change) changes.push_back(&faces);
    }
    if (changes.empty()) continue;
    text += (text.empty() ? "" : ", ") + changes_text(change, changes);
  }
  return text;
}

std::string to_text(const FindingGroup& group, const Check& check) {
  const auto [what, more] = event_texts(group, check);
  std::string text = what;
  for (const std::string& part : {more, cause_text(group, check)}) {
    if (!part.empty()) text += "; " + part;
  }
  return text;
}

std::string group_lines(const FindingGroup& group, std::size_t number, const Check& check) {
  const auto [what, more] = event_texts(group, check);
  std::string text = fmt::format("{:>4}. {}\n", number, what);
  for (const std::string& part : {more, cause_text(group, check)}) {
    if (!part.empty()) text += fmt::format("      {}\n", line_text(part));
  }
  const auto& segments = check.comparison.findings[group.lead - 1].segments;
  const std::string elements = input_lines(check.input, segments, "      ");
  return text + elements.substr(0, elements.find('\n') + 1);
}

}  // namespace plumbline
