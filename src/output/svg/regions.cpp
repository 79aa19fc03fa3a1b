// Pictures of overlays and of selected regions: faces in colours of what they lie in.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "output/svg/kit.hpp"
#include "output/svg/panel.hpp"
#include "output/svg/sheet.hpp"
#include "output/text/terminal.hpp"
#include "plumbline/output/regions.hpp"

namespace plumbline {
namespace {

/// ColorBrewer's "Paired": what is in the first, in the second, in both.
constexpr const char* kFirst = "#a6cee3";
constexpr const char* kSecond = "#fdbf6f";
constexpr const char* kBoth = "#6a9f58";

struct Legend {
  const char* colour;
  std::string words;
};

/// `colours` has one for each face, null for those that are not filled.
std::string sheet_of(const SegmentSet& input, const ExactComplex& complex,
                     const std::vector<const char*>& colours, const std::string& words,
                     const std::vector<Legend>& legend) {
  using namespace svg;
  constexpr double kAbove = 64, kBelow = 52, kSize = 14;
  constexpr double kLeast = 300, kGreatest = 1500, kMargin = 0.01;
  const Box content = widened(bounds(extent(complex)), kMargin);
  const double width = sheet::kWidth - 2 * sheet::kMargin;
  const double height = std::clamp(width * content.height() / content.width(), kLeast, kGreatest);
  const Box panel{{sheet::kMargin, kAbove}, {sheet::kMargin + width, kAbove + height}};
  const Frame frame = sheet::frame(content, panel, input.y_up);
  std::string result = sheet::open(sheet::kWidth, panel.high.y + kBelow);
  result +=
      svg::text({sheet::kMargin, 40}, 22, " font-weight=\"bold\"", sheet::titled(input, words));
  result += "<g stroke=\"none\" fill-rule=\"evenodd\">\n";
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    if (colours[f] == nullptr) continue;
    result += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", colours[f],
                          face_path(complex, FaceId(f), frame));
  }
  result += "</g>\n" + edge_paths(complex, frame, sheet::pen(panel, complex.edge_count()));
  double x = sheet::kMargin;
  for (const auto& [colour, meaning] : legend) {
    constexpr double kOfLetter = 8, kGap = 50;
    const double y = panel.high.y + 22;
    result += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"12\" height=\"12\" fill=\"{}\" stroke=\"{}\" "
        "stroke-width=\"0.5\"/>\n",
        x, y, colour, kInk);
    result += svg::text({x + 20, y + 11}, kSize, "", meaning);
    x += kGap + kOfLetter * static_cast<double>(meaning.size());
  }
  return result + "</svg>\n";
}

}  // namespace

std::string to_svg(const Overlay& overlay, OverlayHow how) {
  std::vector<const char*> colours(overlay.complex.face_count(), nullptr);
  for (const Piece& piece : overlay.pieces) {
    for (const FaceId f : piece.faces) {
      colours[f] = piece.first.empty() ? kSecond : piece.second.empty() ? kFirst : kBoth;
    }
  }
  const std::string words =
      fmt::format("{}, {}, area {}", to_text(how), counted(overlay.pieces.size(), "piece"),
                  short_number(nearest_double(overlay.area())));
  return sheet_of(
      overlay.input, overlay.complex, colours, words,
      {{kFirst, "in the first alone"}, {kSecond, "in the second alone"}, {kBoth, "in both"}});
}

std::string to_svg(const SegmentSet& input, const ExactComplex& complex, const FaceSet& selected) {
  std::vector<const char*> colours(complex.face_count(), nullptr);
  for (std::size_t f = 0; f < selected.size(); ++f) {
    if (selected[f]) colours[f] = kBoth;
  }
  return sheet_of(input, complex, colours,
                  "area " + short_number(nearest_double(area(complex, selected))),
                  {{kBoth, "selected"}});
}

}  // namespace plumbline
