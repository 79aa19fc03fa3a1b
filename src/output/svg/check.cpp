// The report as one picture: exact left, float right, the findings marked in both.

#include <fmt/format.h>

#include <algorithm>

#include "output/svg/labels.hpp"
#include "output/svg/marks.hpp"
#include "output/svg/panel.hpp"
#include "output/svg/sheet.hpp"
#include "output/text/verdict.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

namespace sheet = svg::sheet;

constexpr double kCheckHeader = 96, kLegend = 56;  // in pixels

struct Layout {
  svg::Box content;
  svg::Box left, right;
  double height;
};

Layout layout(const FloatComplex& exact_rounded, const FloatComplex& float_complex) {
  const bool has_exact = !exact_rounded.vertices.empty();
  const bool has_float = !float_complex.vertices.empty();
  svg::Box content = svg::bounds(extent(has_exact ? exact_rounded : float_complex));
  if (has_exact && has_float) content = svg::hull(content, svg::bounds(extent(float_complex)));
  content = sheet::content(content);
  const double height = sheet::panel_height(content);
  const auto panel_at = [&](double x) {
    return svg::Box{{x, kCheckHeader}, {x + sheet::kPanelWidth, kCheckHeader + height}};
  };
  return {content, panel_at(sheet::kMargin), panel_at(2 * sheet::kMargin + sheet::kPanelWidth),
          kCheckHeader + height + kLegend};
}

std::string drawn_panel(const svg::Box& box, const Layout& where, const FloatComplex& complex,
                        const svg::Marks& marks, const Check& check) {
  const Comparison& comparison = check.comparison;
  const svg::Frame frame = sheet::frame(where.content, box, check.input.y_up);
  std::vector<FindingPlace> places;
  for (std::size_t g = 0; g < check.groups.size(); ++g) {
    const Finding& lead = comparison.findings[check.groups[g].lead - 1];
    if (lead.kind != CellKind::Complex) places.push_back({frame(nearest(lead.where)), g + 1});
  }
  return sheet::ground(box) +
         svg::panel(complex, frame, sheet::pen(box, complex.edge_count()), marks) +
         labelled_rings(places, box);
}

std::string panel_title(const svg::Box& box, const std::string& title, const Counts& counts) {
  const std::string numbers =
      fmt::format("V {}   E {}   F {}", counts.vertices, counts.edges, counts.faces);
  return svg::text({box.low.x, kCheckHeader - 12}, 18, " font-weight=\"bold\"", title) +
         svg::text({box.high.x, kCheckHeader - 12}, 16,
                   " text-anchor=\"end\" xml:space=\"preserve\"", numbers);
}

std::string legend(const Layout& where, const Check& check) {
  const double y = where.height - kLegend / 2;
  const std::size_t deepest =
      std::max(check.comparison.exact_counts.depth, check.comparison.float_counts.depth);
  double x = sheet::kMargin;
  std::string svg = svg::text({x, y + 5}, 14, "", "depth");
  x += 52;
  for (std::size_t depth = 1; depth <= std::min(deepest, svg::kDepthColours.size()); ++depth) {
    svg += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"18\" height=\"14\" fill=\"{}\" stroke=\"{}\" "
        "stroke-width=\"0.5\"/>\n",
        x, y - 7, svg::kDepthColours[depth - 1], svg::kInk);
    const bool is_last_colour = depth == svg::kDepthColours.size() && depth < deepest;
    svg += svg::text({x + 24, y + 5}, 14, "", std::to_string(depth) + (is_last_colour ? "+" : ""));
    x += 52;
  }
  svg += fmt::format(
      "<path d=\"M{} {}h36\" stroke=\"{}\" stroke-width=\"1.5\" "
      "stroke-dasharray=\"4\"/>\n",
      x + 12, y, svg::kInk);
  svg += svg::text({x + 56, y + 5}, 14, "", "antenna");
  svg += svg::circle({x + 142, y}, 8,
                     fmt::format(" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"", svg::kMark));
  svg += svg::text({x + 158, y + 5}, 14, "", "group of findings, by its number in the report");
  return svg;
}

std::string header(const Check& check, const Layout& where) {
  const Comparison& c = check.comparison;
  std::string words = sheet::titled(check.input, verdict(check));
  if (!c.float_valid) words += "; the float result is not a valid complex";
  const std::string colour = c.agree() ? svg::kInk : svg::kMark;
  return svg::text({sheet::kMargin, 40}, 24, " font-weight=\"bold\" fill=\"" + colour + "\"",
                   words) +
         svg::text({sheet::kWidth - sheet::kMargin, 40}, 16, " text-anchor=\"end\"",
                   "tolerance " + shortest_text(c.tolerance)) +
         panel_title(where.left, "exact", c.exact_counts) +
         panel_title(
             where.right,
             check.answer.title +
                 (check.answer.radius ? ", radius " + shortest_text(*check.answer.radius) : ""),
             c.float_counts);
}

}  // namespace

std::string to_svg(const Check& check) {
  const FloatComplex exact_rounded = nearest(check.exact_complex);
  const Layout where = layout(exact_rounded, check.answer.complex);
  const Comparison& c = check.comparison;
  return sheet::open(sheet::kWidth, where.height) + header(check, where) +
         drawn_panel(where.left, where, exact_rounded,
                     svg::marks_of(c, check.exact_complex, &Finding::exact_cells), check) +
         drawn_panel(where.right, where, check.answer.complex,
                     svg::marks_of(c, check.answer.complex, &Finding::float_cells), check) +
         legend(where, check) + "</svg>\n";
}

}  // namespace plumbline
