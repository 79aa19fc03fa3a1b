// The diagnosis as one picture: a panel for each kind of defect, over the same drawing.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "output/svg/labels.hpp"
#include "output/svg/picture.hpp"
#include "output/text/escape.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

using Out = std::back_insert_iterator<std::string>;
using PictureBox = svg::Box;

// All in pixels.
constexpr double kWidth = 1600, kMargin = 24, kHeader = 64, kTitle = 40;
constexpr std::size_t kColumns = 2;
constexpr double kPanelWidth = (kWidth - 3 * kMargin) / 2;
constexpr double kLeastHeight = 240, kGreatestHeight = 1200;
constexpr double kStepsPerPixel = 1000;
// Room around the drawing, for rings at its border; a part of its longer side.
constexpr double kRoom = 0.05;
// A drawing of more edges than this is drawn with thinner lines, so that it does not turn black.
constexpr double kEdgesAtFullPen = 3000, kThinnestPen = 0.2;
constexpr double kMarkPens = 2.5;

std::string text(double x, double y, double size, const std::string& rest, std::string_view words) {
  return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"{}>{}</text>\n", x, y, size, rest,
                     xml_text(words));
}

/// Defects of one kind: positions in the list of all.
struct Group {
  DefectKind kind;
  std::size_t begin, end;
};

std::vector<Group> groups(const Diagnosis& diagnosis) {
  std::vector<Group> result;
  const std::vector<Defect>& defects = diagnosis.defects;
  for (std::size_t i = 0; i < defects.size(); ++i) {
    if (result.empty() || result.back().kind != defects[i].kind)
      result.push_back({defects[i].kind, i, i});
    result.back().end = i + 1;
  }
  return result;
}

/// The drawing itself, which every panel shows, and how it is placed.
struct Base {
  FloatComplex complex;
  svg::Frame frame;  ///< onto a panel at (0, 0)
  PictureBox panel;
  double pen;
};

Base base_of(const ExactComplex& exact_complex, bool y_up) {
  FloatComplex complex = nearest(exact_complex);
  const PictureBox content = svg::widened(svg::bounds(complex), kRoom);
  const double height =
      std::clamp(kPanelWidth * content.height() / content.width(), kLeastHeight, kGreatestHeight);
  const PictureBox panel{{0, 0}, {kPanelWidth, height}};
  svg::Frame frame = svg::fit(content, panel, y_up);
  frame.steps = kStepsPerPixel;
  const double edges = static_cast<double>(complex.edge_count());
  const double pen =
      svg::pen_width(panel) *
      std::clamp(std::sqrt(kEdgesAtFullPen / std::max(edges, 1.0)), kThinnestPen, 1.0);
  return {std::move(complex), frame, panel, pen};
}

/// Whether its edges are the defect; else they are what it is near to.
bool is_made_of_edges(DefectKind kind) {
  return kind == DefectKind::Overshoot || kind == DefectKind::Dangle ||
         kind == DefectKind::Bridge || kind == DefectKind::ShortEdge || kind == DefectKind::Sliver;
}

std::string marked_edges(const Base& base, const Diagnosis& diagnosis, const Group& group) {
  if (!is_made_of_edges(group.kind)) return {};
  std::string path;
  for (std::size_t i = group.begin; i < group.end; ++i)
    for (const EdgeId e : diagnosis.defects[i].edges) {
      const Edge& edge = base.complex.edges[e];
      path += 'M' + svg::coordinates(base.frame(base.complex.vertices[edge.tail])) + 'L' +
              svg::coordinates(base.frame(base.complex.vertices[edge.head]));
    }
  return fmt::format(
      "<path fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\" "
      "d=\"{}\"/>\n",
      svg::kMark, shortest_text(kMarkPens * base.pen), path);
}

std::string title(const Diagnosis& diagnosis, const Group& group) {
  const std::size_t found = diagnosis.count(group.kind), listed = group.end - group.begin;
  return fmt::format("{}: {}{}", to_text(group.kind), found,
                     listed < found ? fmt::format(", of which {} are marked", listed) : "");
}

std::string panel(const Base& base, const Diagnosis& diagnosis, const Group& group,
                  const PointD& place) {
  std::vector<FindingPlace> places;
  for (std::size_t i = group.begin; i < group.end; ++i)
    places.push_back({base.frame(nearest(diagnosis.defects[i].where)), i + 1});
  return fmt::format("<g transform=\"translate({} {})\">\n<use href=\"#drawing\"/>\n", place.x,
                     place.y) +
         marked_edges(base, diagnosis, group) + labelled_rings(places, base.panel) +
         text(0, -10, 18, " font-weight=\"bold\"", title(diagnosis, group)) + "</g>\n";
}

std::string header(const Diagnosis& diagnosis, const SegmentSet& input) {
  std::size_t total = 0;
  for (const std::size_t found : diagnosis.found) total += found;
  std::string words = fmt::format("{} defect{}", total, total == 1 ? "" : "s");
  if (!input.files.empty())
    words = std::filesystem::path(input.files.front()).filename().string() + ": " + words;
  return text(kMargin, 40, 24, " font-weight=\"bold\"", words) +
         text(kWidth - kMargin, 40, 16, " text-anchor=\"end\"",
              fmt::format("near is within {:.6g}", nearest_double(diagnosis.within)));
}

}  // namespace

std::string to_svg(const Diagnosis& diagnosis, const SegmentSet& input,
                   const ExactComplex& complex) {
  const Base base = base_of(complex, input.y_up);
  const std::vector<Group> kinds = groups(diagnosis);
  const std::size_t panels = std::max<std::size_t>(kinds.size(), 1);
  const std::size_t rows = (panels + kColumns - 1) / kColumns;
  const double row_height = base.panel.height() + kTitle + kMargin;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0} {1:.0f}\" font-family=\"DejaVu Sans, Arial, sans-serif\" "
      "fill=\"{2}\">\n<rect width=\"{0}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>\n",
      kWidth, kHeader + static_cast<double>(rows) * row_height, svg::kInk);
  fmt::format_to(Out(svg),
                 "<defs><g id=\"drawing\">\n<rect width=\"{}\" height=\"{}\" fill=\"#ffffff\" "
                 "stroke=\"#c9d1d9\"/>\n{}</g></defs>\n",
                 base.panel.width(), base.panel.height(),
                 svg::panel(base.complex, base.frame, base.pen));
  svg += header(diagnosis, input);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const std::size_t row = i / kColumns, column = i % kColumns;
    svg += panel(base, diagnosis, kinds[i],
                 {kMargin + static_cast<double>(column) * (kPanelWidth + kMargin),
                  kHeader + kTitle + static_cast<double>(row) * row_height});
  }
  if (kinds.empty())
    fmt::format_to(Out(svg), "<use href=\"#drawing\" x=\"{}\" y=\"{}\"/>\n", kMargin,
                   kHeader + kTitle);
  return svg + "</svg>\n";
}

}  // namespace plumbline
