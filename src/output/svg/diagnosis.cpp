// The diagnosis as one picture: a panel for each kind of defect, over the same drawing.

#include <fmt/format.h>

#include <algorithm>

#include "output/svg/labels.hpp"
#include "output/svg/panel.hpp"
#include "output/svg/sheet.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

namespace sheet = svg::sheet;

constexpr double kDiagnosisHeader = 64, kTitle = 40;  // in pixels
constexpr std::size_t kColumns = 2;
constexpr double kDefectPens = 2.5;

/// Defects of one kind: positions in the list of all.
struct Group {
  DefectKind kind;
  std::size_t begin, end;
};

std::vector<Group> groups(const Diagnosis& diagnosis) {
  std::vector<Group> result;
  const std::vector<Defect>& defects = diagnosis.defects;
  for (std::size_t i = 0; i < defects.size(); ++i) {
    if (result.empty() || result.back().kind != defects[i].kind) {
      result.push_back({defects[i].kind, i, i});
    }
    result.back().end = i + 1;
  }
  return result;
}

/// The drawing itself, which every panel shows, and how it is placed.
struct Base {
  FloatComplex complex;
  svg::Frame frame;  ///< onto a panel at (0, 0)
  svg::Box panel;
  double pen;
};

Base base_of(const ExactComplex& exact_complex, bool y_up) {
  FloatComplex complex = nearest(exact_complex);
  const svg::Box content = sheet::content(svg::bounds(extent(complex)));
  const svg::Box panel{{0, 0}, {sheet::kPanelWidth, sheet::panel_height(content)}};
  const svg::Frame frame = sheet::frame(content, panel, y_up);
  const double pen = sheet::pen(panel, complex.edge_count());
  return {std::move(complex), frame, panel, pen};
}

/// Whether its edges are the defect; else they are what it is near to.
bool is_made_of_edges(const Defect& defect) {
  const DefectKind kind = defect.kind;
  return (kind == DefectKind::Overshoot && defect.vertices.size() == 1) ||
         kind == DefectKind::Dangle || kind == DefectKind::Bridge ||
         kind == DefectKind::ShortEdge || kind == DefectKind::Sliver;
}

std::string marked_edges(const Base& base, const Diagnosis& diagnosis, const Group& group) {
  std::string path;
  for (std::size_t i = group.begin; i < group.end; ++i) {
    if (!is_made_of_edges(diagnosis.defects[i])) continue;
    for (const EdgeId e : diagnosis.defects[i].edges) {
      const Edge& edge = base.complex.edges[e];
      path += 'M' + svg::coordinates(base.frame(base.complex.vertices[edge.tail])) + 'L' +
              svg::coordinates(base.frame(base.complex.vertices[edge.head]));
    }
  }
  if (path.empty()) return {};
  return fmt::format(
      "<path fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\" "
      "d=\"{}\"/>\n",
      svg::kMark, shortest_text(kDefectPens * base.pen), path);
}

std::string title(const Diagnosis& diagnosis, const Group& group) {
  const std::size_t found = diagnosis.count(group.kind), listed = group.end - group.begin;
  return fmt::format("{}: {}{}", to_text(group.kind), found,
                     listed < found ? fmt::format(", of which {} are marked", listed) : "");
}

std::string panel(const Base& base, const Diagnosis& diagnosis, const Group& group,
                  const PointD& place) {
  std::vector<FindingPlace> places;
  for (std::size_t i = group.begin; i < group.end; ++i) {
    places.push_back({base.frame(nearest(diagnosis.defects[i].where)), i + 1});
  }
  return fmt::format("<g transform=\"translate({} {})\">\n<use href=\"#drawing\"/>\n", place.x,
                     place.y) +
         marked_edges(base, diagnosis, group) + labelled_rings(places, base.panel) +
         svg::text({0, -10}, 18, " font-weight=\"bold\"", title(diagnosis, group)) + "</g>\n";
}

std::string header(const Diagnosis& diagnosis, const SegmentSet& input) {
  std::size_t total = 0;
  for (const std::size_t found : diagnosis.found) total += found;
  const std::string words = fmt::format("{} defect{}", total, total == 1 ? "" : "s");
  return svg::text({sheet::kMargin, 40}, 24, " font-weight=\"bold\"", sheet::titled(input, words)) +
         svg::text({sheet::kWidth - sheet::kMargin, 40}, 16, " text-anchor=\"end\"",
                   fmt::format("near is within {:.6g}", nearest_double(diagnosis.within)));
}

}  // namespace

std::string to_svg(const Diagnosis& diagnosis, const SegmentSet& input,
                   const ExactComplex& complex) {
  const Base base = base_of(complex, input.y_up);
  const std::vector<Group> kinds = groups(diagnosis);
  const std::size_t panels = std::max<std::size_t>(kinds.size(), 1);
  const std::size_t rows = (panels + kColumns - 1) / kColumns;
  const double row_height = base.panel.height() + kTitle + sheet::kMargin;
  std::string svg =
      sheet::open(sheet::kWidth, kDiagnosisHeader + static_cast<double>(rows) * row_height);
  svg += fmt::format(
      "<defs><g id=\"drawing\">\n<rect width=\"{}\" height=\"{}\" fill=\"#ffffff\" "
      "stroke=\"#c9d1d9\"/>\n{}</g></defs>\n",
      base.panel.width(), base.panel.height(), svg::panel(base.complex, base.frame, base.pen));
  svg += header(diagnosis, input);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const std::size_t row = i / kColumns, column = i % kColumns;
    svg +=
        panel(base, diagnosis, kinds[i],
              {sheet::kMargin + static_cast<double>(column) * (sheet::kPanelWidth + sheet::kMargin),
               kDiagnosisHeader + kTitle + static_cast<double>(row) * row_height});
  }
  if (kinds.empty()) {
    svg += fmt::format("<use href=\"#drawing\" x=\"{}\" y=\"{}\"/>\n", sheet::kMargin,
                       kDiagnosisHeader + kTitle);
  }
  return svg + "</svg>\n";
}

}  // namespace plumbline
