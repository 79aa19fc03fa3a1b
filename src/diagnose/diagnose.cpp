// The steps in order, then what a tolerance would do.

#include "plumbline/diagnose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "diagnose/steps.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

using diagnose_steps::Defects;
using diagnose_steps::LineGraph;

/// A search distance of the longer side / kDefaultPart: as float LAR's radius.
constexpr int kDefaultPart = 1000;
/// Doors are from the longer side / kMostDoors to / kLeastDoors wide.
constexpr int kMostDoors = 100, kLeastDoors = 10;

/// Of the drawing, without what is stray; exact where nothing is.
Rational longer_side(const ExactComplex& complex) {
  if (complex.vertices.empty()) return 0;
  const Extent without_stray = extent(complex);
  if (!without_stray.stray.empty()) return rational_from(without_stray.longer_side());
  Rational low = complex.vertices.front().y, high = low;
  for (const Point& p : complex.vertices) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  const Rational width = complex.vertices.back().x - complex.vertices.front().x;
  const Rational height = high - low;
  return std::max(width, height);
}

/// The shortest edge that is not among the accidents, and longer than what rounding could make of
/// nothing, squared.
std::optional<Rational> shortest_detail(const LineGraph& graph,
                                        const std::vector<EdgeId>& accidents) {
  std::vector<bool> is_accident(graph.complex().edge_count());
  for (const EdgeId e : accidents) is_accident[e] = true;
  const Rational slack = rational_from(graph.slack()), squared_slack = slack * slack;
  std::optional<Rational> shortest;
  double bound = 0;
  for (std::size_t i = 0; i < is_accident.size(); ++i) {
    const EdgeId e(i);
    if (is_accident[e] || (shortest && graph.approx_length(e) > bound)) continue;
    Rational squared = graph.squared_length(e);
    if ((shortest && *shortest <= squared) || squared <= squared_slack) continue;
    bound = graph.approx_length(e) + 2 * graph.slack();
    shortest = std::move(squared);
  }
  return shortest;
}

/// The exponent of ten of a positive number.
int decade(double value) {
  const std::string text = fmt::format("{:.16e}", value);
  return std::stoi(text.substr(text.find('e') + 1));
}

/// The largest of each decade, those below the slack being one, and the largest that spares all
/// detail.
std::vector<ToleranceEffect> effects(const std::vector<double>& proposed,
                                     const std::optional<Rational>& squared_detail, double slack) {
  const auto spares = [&](double tolerance) {
    const Rational t = rational_from(tolerance);
    return !squared_detail || t * t < *squared_detail;
  };
  const auto end_of_sparing = static_cast<std::size_t>(
      std::partition_point(proposed.begin(), proposed.end(), spares) - proposed.begin());
  std::vector<ToleranceEffect> result;
  for (std::size_t mended = 1; mended <= proposed.size(); ++mended) {
    const double tolerance = proposed[mended - 1];
    const bool is_last = mended == proposed.size();
    if (!is_last && proposed[mended] == tolerance) continue;
    const bool ends_decade =
        is_last || tolerance == 0 ||
        (proposed[mended] > slack && decade(tolerance) != decade(proposed[mended]));
    if (ends_decade || mended == end_of_sparing) {
      result.push_back({tolerance, mended, mended <= end_of_sparing});
    }
  }
  return result;
}

}  // namespace

Diagnosis diagnose(const SegmentSet& input, const ExactComplex& complex,
                   const DiagnoseOptions& options) {
  if (options.within && sgn(*options.within) < 0) {
    throw Error(ErrorCode::BadInput, "the search distance is negative", {},
                exact_text(*options.within));
  }
  Diagnosis result;
  const Rational side = longer_side(complex);
  result.within = options.within ? *options.within : Rational(side / kDefaultPart);
  const LineGraph graph(complex);
  const diagnose_steps::NearEdges near(graph, result.within);
  const diagnose_steps::Subject subject{
      input, graph, near, result.within, result.within * result.within, options.most_listed};
  const diagnose_steps::Tips tips = diagnose_steps::classify_tips(subject);
  Defects defects = diagnose_steps::duplicates_and_overlaps(subject);
  defects.append(diagnose_steps::dangling_lines(subject, tips));
  defects.append(diagnose_steps::near_misses(subject, tips));
  defects.append(diagnose_steps::bridges(subject));
  defects.append(diagnose_steps::slivers(subject));
  defects.append(diagnose_steps::short_edges(subject));
  defects.append(diagnose_steps::nearly_parallel_edges(subject));
  defects.append(diagnose_steps::invalid_rings(subject));
  const Range doors = options.doors.value_or(Range{side / kMostDoors, side / kLeastDoors});
  std::vector<VertexId> dangling;
  for (const diagnose_steps::Tip& tip : tips.tips) {
    if (tip.kind == DefectKind::Dangle) dangling.push_back(tip.vertex);
  }
  result.openings = diagnose_steps::openings(subject.graph, dangling, doors);
  result.shared_sides = repetitions(input, complex).shared_sides;
  result.found = defects.found();
  result.cut_short = defects.cut_short();
  result.tips = tips.tips.size();
  result.squared_detail = shortest_detail(graph, defects.accidents());
  result.tolerances = effects(defects.proposed_tolerances(), result.squared_detail, graph.slack());
  result.defects = defects.take_listed();
  for (Defect& defect : result.defects) defect.message = diagnose_steps::describe(subject, defect);
  return result;
}

}  // namespace plumbline
