// A picture of a repair: what is there after it and what is no longer, over the faces that it
// changed; the edits that do most in a list beside it.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "output/svg/kit.hpp"
#include "output/svg/labels.hpp"
#include "output/svg/panel.hpp"
#include "output/svg/repair_parts.hpp"
#include "output/svg/sheet.hpp"
#include "output/text/edits.hpp"
#include "output/text/escape.hpp"
#include "output/text/terminal.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

/// How lines of a fate are drawn. Of Okabe and Ito, as far as red allows.
struct Style {
  const char* colour;
  double pens;
  double dash;  ///< pens; 0: none
  const char* words;
};
constexpr std::array<Style, kLineFates> kStyles{{{svg::kInk, 1, 0, "as it was"},
                                                 {"#009e73", 3, 0, "added"},
                                                 {"#c8102e", 3, 0, "removed"},
                                                 {"#3d7edb", 1.5, 5, "moved, before"},
                                                 {"#0057c2", 2, 0, "moved, after"},
                                                 {"#009e73", 3, 6, "virtual"}}};
/// From below: what was moved hides nothing.
constexpr std::array kOrder{LineFate::Kept,    LineFate::MovedFrom, LineFate::MovedTo,
                            LineFate::Removed, LineFate::Added,     LineFate::Virtual};

struct Fill {
  const char* colour;
  const char* words;
  const char* other = "";  ///< the second colour of faces after
};
const std::map<std::string, Fill> kFills{{"closed", {"#c9ecd9", "face closed", "#def0c6"}},
                                         {"split", {"#ddd3f3", "part of a split face", "#f0d5ee"}},
                                         {"joined", {"#fbd7a0", "face joined to another one"}},
                                         {"opened", {"#f7c6c9", "face opened"}},
                                         {"virtual", {"#e4f1ec", "face with a virtual border"}}};

constexpr double kAside = 440, kRow = 20, kFont = 14;
constexpr double kStage = svg::sheet::kWidth - 3 * svg::sheet::kMargin - kAside;
constexpr double kLetterWidth = 0.56 * kFont;

struct Picture {
  std::vector<LinePart> lines;
  std::vector<ShownFace> faces;
  std::vector<std::size_t> order;           ///< of edits that can be seen, what does most first
  std::vector<std::size_t> ringed, dotted;  ///< the same edits
  svg::Box panel;
  svg::Frame frame;
};

std::string fills(const Picture& picture, const ExactComplex& before, const ExactComplex& after) {
  std::string text = "<g stroke=\"none\" fill-rule=\"evenodd\">\n";
  // What went into a face lies upon it.
  for (const bool is_after : {true, false}) {
    for (const ShownFace& face : picture.faces) {
      if (face.is_after != is_after) continue;
      const Fill& fill = kFills.at(face.what);
      text += fmt::format("<path fill=\"{}\" d=\"{}\"><title>{}</title></path>\n",
                          face.is_other ? fill.other : fill.colour,
                          svg::face_path(is_after ? after : before, face.face, picture.frame),
                          xml_text(face.title));
    }
  }
  return text + "</g>\n";
}

std::string stroke(LineFate fate, double pen) {
  const Style& style = kStyles.at(static_cast<std::size_t>(fate));
  std::string text = fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{:.3g}\"",
                                 style.colour, style.pens * pen);
  if (style.dash == 0) return text + " stroke-linecap=\"round\"";
  return text + fmt::format(" stroke-dasharray=\"{0:.3g} {0:.3g}\"", style.dash * pen);
}

std::string lines(const Picture& picture) {
  const double pen = svg::sheet::pen(picture.panel, picture.lines.size());
  std::string text;
  for (const LineFate fate : kOrder) {
    const std::string style = stroke(fate, pen);
    std::string path;
    const auto draw = [&] {
      if (!path.empty()) text += fmt::format("<path {} d=\"{}\"/>\n", style, path);
      path.clear();
    };
    for (const LinePart& part : picture.lines) {
      if (part.fate != fate) continue;
      path += fmt::format("M{}L{}", svg::coordinates(picture.frame(nearest(part.segment.a))),
                          svg::coordinates(picture.frame(nearest(part.segment.b))));
      if (path.size() > svg::kLargestPath) draw();
    }
    draw();
  }
  return text;
}

/// Parts the edits into those that get a ring with their number, of very many some that stand apart
/// or in one place, and the rest, which get dots.
void choose_rings(Picture& picture, const Repair& repair) {
  constexpr double kSame = 1, kApart = 22;
  const bool is_sparse = picture.order.size() <= kAllNumbered;
  std::vector<PointD> rings;
  for (const std::size_t e : picture.order) {
    const PointD p = picture.frame(nearest(repair.edits[e].where));
    const auto is_clear = [&](const PointD& q) {
      const double distance = std::hypot(p.x - q.x, p.y - q.y);
      return is_sparse || distance < kSame || distance > kApart;
    };
    const bool is_ringed =
        picture.ringed.size() < kAllNumbered && std::ranges::all_of(rings, is_clear);
    if (is_ringed) rings.push_back(p);
    (is_ringed ? picture.ringed : picture.dotted).push_back(e);
  }
}

/// Rings and dots, and crosses where something was refused.
std::string marks(const Picture& picture, const Repair& repair) {
  constexpr double kDot = 2.2, kCross = 4;
  const auto place_of = [&](std::size_t e) {
    return picture.frame(nearest(repair.edits[e].where));
  };
  std::string text = fmt::format("<g fill=\"{}\">\n", svg::kMark);
  for (const std::size_t e : picture.dotted) text += svg::circle(place_of(e), kDot, "");
  text += "</g>\n";
  std::vector<FindingPlace> ringed;
  for (const std::size_t e : picture.ringed) ringed.push_back({place_of(e), e + 1});
  std::string crosses;
  for (const Refusal& refusal : repair.refused) {
    const PointD p = picture.frame(nearest(refusal.where));
    crosses += fmt::format("M{:.2f} {:.2f}l{} {}m0-{}l-{} {}", p.x - kCross, p.y - kCross,
                           2 * kCross, 2 * kCross, 2 * kCross, 2 * kCross, 2 * kCross);
  }
  if (!crosses.empty()) {
    text += fmt::format("<path fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" d=\"{}\"/>\n",
                        svg::kInk, crosses);
  }
  return text + labelled_rings(ringed, picture.panel);
}

/// What the colours mean, as far as there is any of them. Moves `y` on.
std::string legend(const Picture& picture, const Repair& repair, double left, double& y) {
  std::string text;
  const auto row = [&](const std::string& sample, const std::string& words) {
    y += kRow;
    text += sample + svg::text({left + 44, y}, kFont, "", words);
  };
  const auto line = [&](const std::string& style) {
    return fmt::format("<path {} d=\"M{} {}h32\"/>\n", style, left, y + kRow - 5);
  };
  for (const LineFate fate : kOrder) {
    const auto count = std::ranges::count(picture.lines, fate, &LinePart::fate);
    if (count > 0) row(line(stroke(fate, 1)), kStyles.at(static_cast<std::size_t>(fate)).words);
  }
  for (const auto& [what, fill] : kFills) {
    const auto count = std::ranges::count(picture.faces, what, &ShownFace::what);
    if (count == 0) continue;
    const std::string sample =
        fmt::format("<rect x=\"{}\" y=\"{}\" width=\"32\" height=\"12\" fill=\"{}\"/>\n", left,
                    y + kRow - 11, fill.colour);
    row(sample, fmt::format("{} ({})", fill.words, count));
  }
  if (!picture.dotted.empty()) {
    row(svg::circle({left + 16, y + kRow - 5}, 3, fmt::format(" fill=\"{}\"", svg::kMark)),
        counted(picture.dotted.size(), "more edit"));
  }
  if (!repair.refused.empty()) {
    row(fmt::format("<path fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" d=\"M{} {}l8 8m0 "
                    "-8l-8 8\"/>\n",
                    svg::kInk, left + 12, y + kRow - 9),
        fmt::format("refused ({})", repair.refused.size()));
  }
  y += kRow;
  return text;
}

/// The edits that do most, as many as there is space for, and rooms with virtual borders.
std::string list(const Picture& picture, const Repair& repair, double left, double y) {
  constexpr double kNumber = 44, kKind = 54, kSize = 196, kRooms = 208;
  const auto most = static_cast<std::size_t>((kAside - kRooms) / kLetterWidth);
  const double bottom = picture.panel.high.y;
  const std::vector<std::string> rooms = room_texts(repair, 2);
  std::string text;
  std::size_t shown = 0;
  for (const std::size_t e : picture.order) {
    if (y + kRow > bottom - kRow) break;
    y += kRow;
    ++shown;
    const Edit& edit = repair.edits[e];
    text +=
        svg::text({left + kNumber, y}, kFont,
                  fmt::format(" text-anchor=\"end\" font-weight=\"bold\" fill=\"{}\"", svg::kMark),
                  std::to_string(e + 1));
    text += svg::text({left + kKind, y}, kFont, "", to_text(edit.kind));
    text += svg::text({left + kSize, y}, kFont, " text-anchor=\"end\"",
                      short_number(nearest_sqrt(edit.squared_size)));
    text += svg::text({left + kRooms, y}, kFont, "", cut(rooms[e], most));
  }
  const std::size_t rest = repair.edits.size() - shown;
  if (rest == 0) return text;
  const bool is_quiet = shown == picture.order.size();  // merged and dissolved lines alone are left
  return text +
         svg::text({left + kKind, y + kRow}, kFont, "",
                   fmt::format("\u2026 and {} more{}", rest, is_quiet ? " that move nothing" : ""));
}

/// Words in lines of so many letters at most.
std::vector<std::string> wrapped(const std::string& words, std::size_t most) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < words.size();) {
    std::size_t count = words.size() - from;
    if (count > most) {
      const std::size_t blank = words.rfind(' ', from + most);
      count = blank == words.npos || blank <= from ? most : blank - from;
    }
    lines.push_back(words.substr(from, count));
    from += count;
    while (from < words.size() && words[from] == ' ') ++from;
  }
  return lines;
}

Picture picture_of(const Repair& repair, const SegmentSet& input, const ExactComplex& before,
                   const ExactComplex& after, double top) {
  constexpr double kLeast = 500, kGreatest = 1500, kMargin = 0.03;
  const auto box = [](const ExactComplex& complex) { return svg::bounds(extent(complex)); };
  const svg::Box all = after.edge_count() == 0 ? box(before) : svg::hull(box(before), box(after));
  const svg::Box content = svg::widened(all, kMargin);
  const double height = std::clamp(kStage * content.height() / content.width(), kLeast, kGreatest);
  Picture picture;
  picture.lines = line_parts(input, repair);
  picture.faces = shown_faces(repair, after);
  picture.panel = {{svg::sheet::kMargin, top}, {svg::sheet::kMargin + kStage, top + height}};
  picture.frame = svg::sheet::frame(content, picture.panel, input.y_up);
  for (const std::size_t e : most_effective_first(repair)) {
    const EditKind kind = repair.edits[e].kind;
    if (kind != EditKind::Merge && kind != EditKind::Dissolve) picture.order.push_back(e);
  }
  choose_rings(picture, repair);
  return picture;
}

}  // namespace

std::string to_svg(const Repair& repair, const SegmentSet& input, const ExactComplex& before,
                   const ExactComplex& after) {
  using namespace svg;
  constexpr std::size_t kLetters = 190;
  constexpr double kTitle = 40, kGap = 16;
  std::vector<std::string> head = wrapped(repair_line(repair), kLetters);
  for (std::string& line : wrapped("tolerances: " + to_text(repair.tolerances), kLetters)) {
    head.push_back(std::move(line));
  }
  const double top = kTitle + kRow * static_cast<double>(head.size()) + kGap;
  const Picture picture = picture_of(repair, input, before, after, top);
  const double left = picture.panel.high.x + sheet::kMargin;
  std::string result = sheet::open(sheet::kWidth, picture.panel.high.y + sheet::kMargin);
  result +=
      text({sheet::kMargin, kTitle}, 22, " font-weight=\"bold\"", sheet::titled(input, "repair"));
  double y = kTitle;
  for (const std::string& line : head) result += text({sheet::kMargin, y += kRow}, kFont, "", line);
  result += fills(picture, before, after) + lines(picture) + marks(picture, repair);
  y = top - kRow;
  result += legend(picture, repair, left, y);
  result += list(picture, repair, left, y);
  return result + "</svg>\n";
}

}  // namespace plumbline
