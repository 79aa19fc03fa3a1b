// The diagnosis as one picture: the drawing, its defects marked, below it what the numbers are.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "plumbline/report.hpp"
#include "report/finding_labels.hpp"
#include "write/escape.hpp"
#include "write/picture.hpp"

namespace plumbline {
namespace {

using picture::Box;
using Out = std::back_insert_iterator<std::string>;

// All in pixels.
constexpr double kWidth = 1600, kMargin = 24, kHeader = 64, kRow = 24, kColumn = 380;
constexpr double kLeastHeight = 240, kGreatestHeight = 1600;
constexpr double kStepsPerPixel = 1000;
// Room around the drawing, for rings at its border; a part of its longer side.
constexpr double kRoom = 0.05;
// A drawing of more edges than this is drawn with thinner lines, so that it does not turn black.
constexpr double kEdgesAtFullPen = 3000, kThinnestPen = 0.2;

std::string text(double x, double y, double size, const std::string& rest, std::string_view words) {
  return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"{}>{}</text>\n", x, y, size, rest,
                     xml_text(words));
}

/// Whether its edges are the defect; else they are what it is near to.
bool is_made_of_edges(DefectKind kind) {
  return kind == DefectKind::Overshoot || kind == DefectKind::Dangle ||
         kind == DefectKind::Bridge || kind == DefectKind::ShortEdge;
}

picture::Marks marks_of(const Diagnosis& diagnosis) {
  picture::Marks marks;
  for (const Defect& defect : diagnosis.defects) {
    if (defect.face.valid()) marks.faces.push_back(defect.face);
    if (!is_made_of_edges(defect.kind)) continue;
    marks.edges.insert(marks.edges.end(), defect.edges.begin(), defect.edges.end());
  }
  std::sort(marks.edges.begin(), marks.edges.end());
  marks.edges.erase(std::unique(marks.edges.begin(), marks.edges.end()), marks.edges.end());
  return marks;
}

std::string drawing(const Box& box, const picture::Frame& frame, const FloatComplex& complex,
                    const Diagnosis& diagnosis) {
  const double edges = static_cast<double>(complex.edge_count());
  const double pen =
      picture::pen_width(box) *
      std::clamp(std::sqrt(kEdgesAtFullPen / std::max(edges, 1.0)), kThinnestPen, 1.0);
  std::vector<FindingPlace> places;
  for (std::size_t i = 0; i < diagnosis.defects.size(); ++i)
    places.push_back({frame(nearest(diagnosis.defects[i].where)), i + 1});
  return picture::panel(complex, frame, pen, marks_of(diagnosis)) + labelled_rings(places, box);
}

/// "gap 3: 12 to 14" for each kind that was found.
std::vector<std::string> legend(const Diagnosis& diagnosis) {
  std::vector<std::string> lines;
  std::size_t first = 1;
  for (std::size_t kind = 0; kind < kDefectKinds; ++kind) {
    if (diagnosis.found[kind] == 0) continue;
    std::size_t end = first;
    while (end <= diagnosis.defects.size() &&
           diagnosis.defects[end - 1].kind == static_cast<DefectKind>(kind))
      ++end;
    std::string line = fmt::format(
        "{}: {}", to_text(static_cast<DefectKind>(kind)),
        end - first == 1 ? fmt::format("{}", first) : fmt::format("{} to {}", first, end - 1));
    if (end - first < diagnosis.found[kind])
      line += fmt::format(", and {} more", diagnosis.found[kind] - (end - first));
    lines.push_back(std::move(line));
    first = end;
  }
  return lines;
}

std::string header(const Diagnosis& diagnosis, const SegmentSet& input) {
  std::size_t total = 0;
  for (const std::size_t found : diagnosis.found) total += found;
  std::string words = fmt::format("{} defects", total);
  if (!input.files.empty())
    words = std::filesystem::path(input.files.front()).filename().string() + ": " + words;
  return text(kMargin, 40, 24, " font-weight=\"bold\"", words) +
         text(kWidth - kMargin, 40, 16, " text-anchor=\"end\"",
              fmt::format("near is within {:.6g}", nearest_double(diagnosis.within)));
}

}  // namespace

std::string report_svg(const Diagnosis& diagnosis, const SegmentSet& input,
                       const ExactComplex& complex) {
  const FloatComplex rounded = nearest(complex);
  const picture::Box content = picture::widened(picture::bounds(rounded), kRoom);
  const double width = kWidth - 2 * kMargin;
  const double height =
      std::clamp(width * content.height() / content.width(), kLeastHeight, kGreatestHeight);
  const picture::Box box{{kMargin, kHeader}, {kMargin + width, kHeader + height}};
  picture::Frame frame = picture::fit(content, box, input.y_up);
  frame.steps = kStepsPerPixel;
  const std::vector<std::string> lines = legend(diagnosis);
  const auto columns = static_cast<std::size_t>(width / kColumn);
  const std::size_t rows = (lines.size() + columns - 1) / columns;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0} {1:.0f}\" font-family=\"DejaVu Sans, Arial, sans-serif\" "
      "fill=\"{2}\">\n<rect width=\"{0}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>\n",
      kWidth, box.high.y + static_cast<double>(rows) * kRow + 2 * kMargin, picture::kInk);
  svg += header(diagnosis, input) + drawing(box, frame, rounded, diagnosis);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t row = i / columns, column = i % columns;
    svg += text(kMargin + static_cast<double>(column) * kColumn,
                box.high.y + 2 * kMargin + static_cast<double>(row) * kRow, 15, "", lines[i]);
  }
  return svg + "</svg>\n";
}

}  // namespace plumbline
