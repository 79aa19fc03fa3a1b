// Overlays and selected regions for a terminal.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "output/text/terminal.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output/regions.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kListed = 20;

/// Numbers of the largest, in descending order of their areas.
template <class AreaOf>
std::vector<std::size_t> largest(std::size_t count, std::size_t most, AreaOf area_of) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return area_of(a) > area_of(b); });
  order.resize(std::min(count, most));
  return order;
}

std::string elements(const Overlay& overlay, const std::vector<RegionId>& regions) {
  constexpr std::size_t kWidest = 34;
  if (regions.empty()) return "-";
  const std::string rest =
      regions.size() == 1 ? "" : fmt::format(" and {} more", regions.size() - 1);
  const std::string text = line_text(source_text(overlay.regions[regions.front()], overlay.input));
  return cut(text, kWidest - std::min(rest.size(), kWidest)) + rest;
}

/// "left out: 12 lines that enclose nothing, the first of them plan.svg:3 line".
std::string left_out(const std::vector<SegmentId>& open, const SegmentSet& input) {
  if (open.empty()) return "";
  return fmt::format(
      "left out: {} that close{} nothing, the first of {}\n", counted(open.size(), "segment"),
      open.size() == 1 ? "s" : "",
      line_text(to_text(input.sources[input.segment_source[open.front()]], input.files)));
}

std::string more(std::size_t count, std::size_t shown) {
  return count > shown ? fmt::format("{:>7}  ... {} more (--list N)\n", "", count - shown) : "";
}

}  // namespace

std::string to_text(const Overlay& overlay, OverlayHow how, std::optional<std::size_t> listed) {
  const std::vector<Piece>& pieces = overlay.pieces;
  std::string text = fmt::format(
      "{} of {} and {}: {}, area {}\n", to_text(how), counted(overlay.first_count, "polygon"),
      counted(overlay.regions.size() - overlay.first_count, "polygon"),
      counted(pieces.size(), "piece"), short_number(nearest_double(overlay.area())));
  const auto shown = largest(pieces.size(), listed.value_or(kListed),
                             [&](std::size_t p) -> const Rational& { return pieces[p].area; });
  if (!shown.empty()) {
    text += fmt::format("{:>7}  {:>12}  {:<34}  {}\n", "piece", "area", "first", "second");
  }
  for (const std::size_t p : shown) {
    text += fmt::format("{:>7}  {:>12}  {:<34}  {}\n", p + 1,
                        short_number(nearest_double(pieces[p].area)),
                        elements(overlay, pieces[p].first), elements(overlay, pieces[p].second));
  }
  return text + more(pieces.size(), shown.size()) + left_out(overlay.open, overlay.input);
}

std::string to_text(const RegionPolygons& selected, const LayerRegions& of, const SegmentSet& input,
                    std::optional<std::size_t> listed) {
  const std::vector<Rational>& areas = selected.areas;
  Rational sum = 0;
  for (const Rational& area : areas) sum += area;
  std::map<std::string, std::size_t> names;
  for (const Region& region : of.regions) ++names[region.name];
  std::string text = fmt::format("{} of {} by {}, area {}\n", counted(areas.size(), "polygon"),
                                 counted(of.regions.size(), "region"),
                                 counted(names.size(), "name"), short_number(nearest_double(sum)));
  const auto shown = largest(areas.size(), listed.value_or(kListed),
                             [&](std::size_t p) -> const Rational& { return areas[p]; });
  if (!shown.empty()) text += fmt::format("{:>7}  {:>12}  {}\n", "polygon", "area", "holes");
  for (const std::size_t p : shown) {
    text += fmt::format("{:>7}  {:>12}  {}\n", p + 1, short_number(nearest_double(areas[p])),
                        selected.polygons[p].holes.size());
  }
  return text + more(areas.size(), shown.size()) + left_out(of.open, input);
}

}  // namespace plumbline
