// A plan of rooms to pin up: each with its number, name and area; a list of them, a scale bar.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "output/svg/kit.hpp"
#include "output/svg/panel.hpp"
#include "output/svg/rooms.hpp"
#include "output/svg/sheet.hpp"
#include "output/text/rooms.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

/// ColorBrewer's "Set3": neighbours are told apart, by day and in print.
constexpr std::array kColours = {"#8dd3c7", "#ffffb3", "#bebada", "#fdb462", "#b3de69", "#fccde5",
                                 "#80b1d3", "#ffed6f", "#ccebc5", "#d9d9d9", "#fb8072", "#bc80bd"};
constexpr const char* kNarrow = "#e9ecef";  // walls, and what else is no room
constexpr double kListWidth = 380, kHead = 64, kFoot = 56, kLine = 20, kWords = 14;
constexpr double kPlanWidth = svg::sheet::kWidth - 3 * svg::sheet::kMargin - kListWidth;

constexpr double kLetter = 0.62, kSpacing = 1.25;  // width of a letter and of a line, by its height

double hundredths(double value) { return std::round(value * 100) / 100; }

/// How many letters: bytes of UTF-8 that begin one.
double letters(const std::string& text) {
  return static_cast<double>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
  }));
}

std::string names_text(const Room& room) { return fmt::format("{}", fmt::join(room.names, ", ")); }

/// As many letters as there is space for.
std::string shortened(const std::string& text, double most) {
  if (letters(text) <= most) return text;
  std::string result;
  double count = 0;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xc0U) != 0x80U && ++count > most - 1) break;
    result += c;
  }
  return result + "\u2026";
}

std::string fills(const Rooms& rooms, const ExactComplex& complex, const svg::Frame& frame) {
  std::vector<std::string> colour(complex.face_count(), kNarrow);
  std::vector<std::size_t> room_of(complex.face_count());
  const std::vector<std::size_t> colours = room_colours(rooms);
  for (std::size_t r = 0; r < colours.size(); ++r) {
    colour[rooms.rooms[r].face] = kColours[colours[r] % kColours.size()];
    room_of[rooms.rooms[r].face] = r + 1;
  }
  std::string text = "<g stroke=\"none\" fill-rule=\"evenodd\">\n";
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    const std::string room = room_of[f] == 0 ? "" : fmt::format(" data-room=\"{}\"", room_of[f]);
    text += fmt::format("<path{} fill=\"{}\" d=\"{}\"/>\n", room, colour[f],
                        svg::face_path(complex, FaceId(f), frame));
  }
  return text + "</g>\n";
}

/// What is written in a room at best: its number, its first name and its area.
std::vector<std::string> lines_in(const Rooms& rooms, std::size_t r) {
  const Room& room = rooms.rooms[r];
  std::vector<std::string> lines{std::to_string(r + 1)};
  if (!room.names.empty()) lines.push_back(room.names.front());
  lines.push_back(area_text(rooms, room.area));
  return lines;
}

/// How high letters are so that the corners of these lines lie on a circle.
double size_in_circle(const std::vector<std::string>& lines, double width) {
  double longest = 0;
  for (const std::string& line : lines) longest = std::max(longest, letters(line) * kLetter);
  return width / std::hypot(longest, static_cast<double>(lines.size()) * kSpacing);
}

/// The lines about the middle of the room, as large as its circle allows, and what is legible of
/// them: without the area, without the name, the number alone.
std::string words_in(const Rooms& rooms, std::size_t r, const svg::Frame& frame) {
  constexpr double kLargest = 15, kLegible = 5, kLeast = 2, kOfCircle = 0.94;
  const Room& room = rooms.rooms[r];
  const double width = room.width * frame.scale * kOfCircle;
  const std::vector<std::string> all = lines_in(rooms, r);
  std::vector<std::string> lines = all;
  for (const auto& fewer :
       {std::vector{all[0], all[1]}, std::vector{all[0], all.back()}, std::vector{all[0]}}) {
    if (size_in_circle(lines, width) < kLegible) lines = fewer;
  }
  const double size = std::min(kLargest, size_in_circle(lines, width));
  if (size < kLeast) return {};
  const PointD middle = frame(room.middle);
  std::string text;
  double y = middle.y - (static_cast<double>(lines.size()) * kSpacing / 2 - 1) * size;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    text += svg::text({middle.x, hundredths(y)}, hundredths(size),
                      i == 0 ? " font-weight=\"bold\"" : "", lines[i]);
    y += kSpacing * size;
  }
  return text;
}

std::string swatch(const PointD& corner, const char* colour) {
  return fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"12\" height=\"12\" fill=\"{}\" stroke=\"{}\" "
      "stroke-width=\"0.5\"/>\n",
      corner.x, corner.y, colour, svg::kInk);
}

/// The rooms beside the plan, as many as there is space for.
std::string list_of(const Rooms& rooms, double left, double top, double bottom) {
  const auto space = static_cast<std::size_t>(std::max(1.0, (bottom - top) / kLine - 1));
  const std::vector<std::size_t> colours = room_colours(rooms);
  std::string text;
  const std::size_t shown =
      rooms.rooms.size() <= space ? rooms.rooms.size() : std::max<std::size_t>(space, 2) - 1;
  for (std::size_t r = 0; r < shown; ++r) {
    const double y = top + kLine * static_cast<double>(r + 1);
    text += swatch({left, y - 11}, kColours[colours[r] % kColours.size()]);
    text += svg::text({left + 46, y}, kWords, " text-anchor=\"end\"", std::to_string(r + 1));
    constexpr double kNameLetters = 26;
    text +=
        svg::text({left + 56, y}, kWords, "", shortened(names_text(rooms.rooms[r]), kNameLetters));
    text += svg::text({left + kListWidth, y}, kWords, " text-anchor=\"end\"",
                      area_text(rooms, rooms.rooms[r].area));
  }
  if (shown < rooms.rooms.size()) {
    text += svg::text({left + 56, top + kLine * static_cast<double>(shown + 1)}, kWords, "",
                      fmt::format("\u2026 and {} more", rooms.rooms.size() - shown));
  }
  return text;
}

/// A bar of 1, 2 or 5 times a power of ten, in metres where the unit is known.
std::string scale_bar(const Rooms& rooms, double scale, double left, double y) {
  constexpr double kLongest = 240;
  const double metres = rooms.unit ? nearest_double(rooms.unit->metres) : 1;
  const double most = kLongest / scale * metres;
  double length = std::pow(10, std::floor(std::log10(most)));
  for (const double times : {5.0, 2.0}) {
    if (times * length > most) continue;
    length *= times;
    break;
  }
  const double pixels = hundredths(length / metres * scale);
  return fmt::format(
             "<path fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" "
             "d=\"M{} {}v-8v4h{}v-4v8\"/>\n",
             svg::kInk, left, y + 4, pixels) +
         svg::text({left + pixels + 10, y + 5}, kWords, "",
                   shortest_text(length) + (rooms.unit ? " m" : " drawing units"));
}

/// Where the plan is drawn.
struct Plan {
  svg::Box panel;
  svg::Frame frame;
};

Plan placed(const SegmentSet& input, const ExactComplex& complex, double top) {
  constexpr double kLeast = 400, kGreatest = 1500, kMargin = 0.01;
  const svg::Box content = svg::widened(svg::bounds(extent(complex)), kMargin);
  const double height =
      std::clamp(kPlanWidth * content.height() / content.width(), kLeast, kGreatest);
  const svg::Box panel{{svg::sheet::kMargin, top},
                       {svg::sheet::kMargin + kPlanWidth, top + height}};
  return {panel, svg::sheet::frame(content, panel, input.y_up)};
}

std::string plan_with_words(const Rooms& rooms, const ExactComplex& complex, const Plan& plan) {
  std::string text = fills(rooms, complex, plan.frame);
  text += svg::edge_paths(complex, plan.frame, svg::sheet::pen(plan.panel, complex.edge_count()));
  text += "<g text-anchor=\"middle\" pointer-events=\"none\">\n";
  for (std::size_t r = 0; r < rooms.rooms.size(); ++r) text += words_in(rooms, r, plan.frame);
  return text + "</g>\n" +
         scale_bar(rooms, plan.frame.scale, svg::sheet::kMargin, plan.panel.high.y + 30);
}

}  // namespace

std::string to_svg(const Rooms& rooms, const SegmentSet& input, const ExactComplex& complex) {
  using namespace svg;
  const Plan plan = placed(input, complex, kHead);
  const double bottom = plan.panel.high.y, left = plan.panel.high.x + sheet::kMargin;
  std::string result = sheet::open(sheet::kWidth, bottom + kFoot);
  result += text({sheet::kMargin, 40}, 22, " font-weight=\"bold\"",
                 sheet::titled(input, rooms_line(rooms)));
  result += plan_with_words(rooms, complex, plan);
  result += list_of(rooms, left, kHead, bottom);
  result += swatch({left, bottom + 22}, kNarrow);
  result += text({left + 22, bottom + 33}, kWords, "", "no room: narrow or small");
  return result + "</svg>\n";
}

std::string plan_of_rooms(const Rooms& rooms, const SegmentSet& input,
                          const ExactComplex& complex) {
  const Plan plan = placed(input, complex, svg::sheet::kMargin);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {:.0f}\" "
      "font-family=\"DejaVu Sans, Arial, sans-serif\" fill=\"{}\">\n"
      "<g id=\"drawing\">\n{}</g>\n</svg>\n",
      kPlanWidth + 2 * svg::sheet::kMargin, plan.panel.high.y + kFoot, svg::kInk,
      plan_with_words(rooms, complex, plan));
}

}  // namespace plumbline
