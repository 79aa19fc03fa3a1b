// The minimised drawing as a picture: exact left, the answer right; below the place where most is
// near, magnified.

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "output/svg/marks.hpp"
#include "output/svg/sheet.hpp"
#include "output/svg/window.hpp"
#include "output/text/terminal.hpp"
#include "plumbline/output/minimised.hpp"

namespace plumbline {
namespace {

namespace sheet = svg::sheet;

constexpr double kTitles = 96, kBetweenViews = 56, kViewHeight = 520;  // pixels
constexpr double kWorthMagnifying = 4;
constexpr int kDistancesAcross = 8;  ///< a magnified window is so many of the least distances wide
constexpr double kLargestMagnification = 1e300;
constexpr std::size_t kMostPlaces = 50;

struct Side {
  const ExactComplex& complex;
  svg::Marks marks;
  std::string title;
  Counts counts;
  double left = 0;
};

svg::Box panel_of(const Side& side, double top) {
  return {{side.left, top}, {side.left + sheet::kPanelWidth, top + kViewHeight}};
}

/// The least distance from the place to what does not pass through it, squared; 0: none.
Rational least_distance(const Point& place, const ExactComplex& exact, const ExactComplex& answer) {
  Rational least = 0;
  const auto take = [&](const Rational& squared) {
    if (sgn(squared) > 0 && (sgn(least) == 0 || squared < least)) least = squared;
  };
  for (const ExactComplex* complex : {&exact, &answer}) {
    for (const Point& p : complex->vertices) take(squared_distance(p, place));
    for (const auto& [tail, head] : complex->edges) {
      take(squared_distance(place, complex->vertices[tail], complex->vertices[head]));
    }
  }
  return least;
}

/// Places to look at: those of findings, or of the least feature.
std::vector<Point> places_of(const Check& check) {
  std::vector<Point> places;
  for (const Finding& finding : check.comparison.findings) {
    const bool is_placed = finding.kind != CellKind::Complex;
    if (is_placed && places.size() < kMostPlaces) places.push_back(finding.where);
  }
  if (places.empty() && check.exact_complex.edge_count() > 0) {
    places.push_back(check.exact_complex.vertices[feature_size(check.exact_complex).v]);
  }
  return places;
}

/// What is magnified, the place where most is near; none where all can be seen in the whole
/// drawing.
std::optional<svg::Window> magnified(const Check& check, const Side& exact, const Side& answer,
                                     const Rational& whole) {
  std::optional<svg::Window> window;
  for (const Point& place : places_of(check)) {
    const Rational squared = least_distance(place, exact.complex, answer.complex);
    const double distance = nearest_sqrt(squared);
    if (distance == 0) continue;
    const Rational across = kDistancesAcross * rational_from(distance);
    if (!window || across < window->across) window = svg::Window{place, across};
  }
  if (!window) return std::nullopt;
  const double factor = nearest_double(whole / window->across);
  if (factor < kWorthMagnifying || factor > kLargestMagnification) return std::nullopt;
  return window;
}

std::string drawn(const Side& side, const svg::Window& window, double top, bool y_up) {
  const svg::Box panel = panel_of(side, top);
  return sheet::ground(panel) + svg::in_window(side.complex, window, panel, y_up, side.marks);
}

std::string titled(const Side& side) {
  const std::string numbers =
      fmt::format("V {}   E {}   F {}", side.counts.vertices, side.counts.edges, side.counts.faces);
  return svg::text({side.left, kTitles - 12}, 18, " font-weight=\"bold\"", side.title) +
         svg::text({side.left + sheet::kPanelWidth, kTitles - 12}, 16,
                   " text-anchor=\"end\" xml:space=\"preserve\"", numbers);
}

}  // namespace

std::string to_svg(const Minimised& minimised) {
  const Check& check = minimised.check;
  const Comparison& c = check.comparison;
  const ExactComplex answered =
      check.answer.exact_complex ? *check.answer.exact_complex : exact(check.answer.complex);
  const std::string radius =
      check.answer.radius ? ", radius " + short_number(*check.answer.radius) : "";
  const Side exact_side{check.exact_complex,
                        svg::marks_of(c, check.exact_complex, &Finding::exact_cells), "exact",
                        c.exact_counts, sheet::kMargin};
  const Side answer_side{answered, svg::marks_of(c, answered, &Finding::float_cells),
                         check.answer.title + radius, c.float_counts,
                         2 * sheet::kMargin + sheet::kPanelWidth};
  PointList all = check.exact_complex.vertices;
  for (const Point& p : answered.vertices) all.push_back(p);
  const svg::Window whole = svg::window_around(all, panel_of(exact_side, kTitles));
  const auto near = magnified(check, exact_side, answer_side, whole.across);
  const double second = kTitles + kViewHeight + kBetweenViews;
  const std::string words =
      minimised.outcome.outcome_class == OutcomeClass::Right
          ? "agree"
          : minimised.outcome.kind + ": " + counted(minimised.drawing.segments.size(), "segment");
  std::string picture =
      sheet::open(sheet::kWidth, near ? second + kViewHeight + sheet::kMargin : second) +
      svg::text({sheet::kMargin, 40}, 24, " font-weight=\"bold\"", words) + titled(exact_side) +
      titled(answer_side);
  for (const Side* side : {&exact_side, &answer_side}) {
    picture += drawn(*side, whole, kTitles, check.input.y_up);
    if (near) picture += drawn(*side, *near, second, check.input.y_up);
  }
  if (near) {
    const std::string factor = fmt::format("{:.2g}", nearest_double(whole.across / near->across));
    picture +=
        svg::text({sheet::kMargin, second - 12}, 16, "",
                  fmt::format("magnified {} times: {:.2g} across, around {}", factor,
                              nearest_double(near->across), place_text(near->centre, c.tolerance)));
  }
  return picture + "</svg>\n";
}

}  // namespace plumbline
