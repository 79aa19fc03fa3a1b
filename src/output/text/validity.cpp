// Whether polygons are valid, for a terminal.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "output/text/terminal.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output/polygons.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kPolygonsListed = 8;
constexpr std::size_t kProblems = 3;  // of a polygon

std::string polygon_text(const PolygonValidity& polygon, const SegmentSet& input,
                         std::size_t most) {
  constexpr double kFine = 1e-9;
  const SegmentId first = first_segment(input, polygon);
  std::string text =
      line_text(to_text(input.sources[input.segment_source[first]], input.files)) + '\n';
  const std::size_t shown = std::min(polygon.problems.size(), most);
  for (std::size_t i = 0; i < shown; ++i) {
    const RingProblem& problem = polygon.problems[i];
    text += fmt::format("  {} at {}", jts_name(problem.fault), place_text(problem.where, kFine));
    if (problem.until) text += fmt::format(" to {}", place_text(*problem.until, kFine));
    text += ": " + line_text(describe(problem, input)) + '\n';
  }
  if (polygon.problems.size() > shown) {
    text += fmt::format("  ... {} more\n", polygon.problems.size() - shown);
  }
  return text;
}

}  // namespace

std::string to_text(const std::vector<PolygonValidity>& polygons, const SegmentSet& input,
                    std::optional<std::size_t> listed) {
  std::vector<const PolygonValidity*> invalid;
  std::map<std::string, std::size_t> reasons;
  for (const PolygonValidity& polygon : polygons) {
    if (polygon.is_valid()) continue;
    invalid.push_back(&polygon);
    std::vector<std::string> names;
    for (const RingProblem& problem : polygon.problems) names.push_back(jts_name(problem.fault));
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    for (const std::string& name : names) ++reasons[name];
  }
  if (invalid.empty()) return fmt::format("valid: {}\n", counted(polygons.size(), "polygon"));
  std::string text =
      fmt::format("invalid: {} of {}\n", invalid.size(), counted(polygons.size(), "polygon"));
  if (invalid.size() > 1) {
    for (const auto& [name, count] : reasons) text += fmt::format("{:>7}  {}\n", count, name);
  }
  const std::size_t shown = std::min(invalid.size(), listed.value_or(kPolygonsListed));
  for (std::size_t i = 0; i < shown; ++i) {
    const std::size_t most = listed ? invalid[i]->problems.size() : kProblems;
    text += polygon_text(*invalid[i], input, most);
  }
  if (invalid.size() > shown) {
    text += fmt::format("... {} more (--list N)\n", invalid.size() - shown);
  }
  return text;
}

}  // namespace plumbline
