// Rooms for a terminal: a table.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "output/text/rooms.hpp"
#include "output/text/terminal.hpp"
#include "plumbline/error.hpp"
#include "plumbline/geometry/layers.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kShown = 25;

std::string neighbours_text(const Room& room) {
  std::string text;
  for (const RoomNeighbour& next : room.neighbours) {
    text += fmt::format("{}{}{}", text.empty() ? "" : " ", next.room + 1, next.door ? "d" : "");
  }
  return text;
}

std::string row(const Rooms& rooms, std::size_t r) {
  constexpr std::size_t kWidest = 40, kWidestList = 24;
  const Room& room = rooms.rooms[r];
  return fmt::format(
      "{:>5}  {:>12}  {:<40}  {:<24}  {}\n", r + 1, area_text(rooms, room.area),
      cut(line_text(fmt::format("{}", fmt::join(room.names, ", "))), kWidest),
      cut(neighbours_text(room), kWidestList),
      cut(line_text(fmt::format("{}", fmt::join(own_names(room.layers), ", "))), kWidestList));
}

/// "least width 0.5 m".
std::string length_text(const Rooms& rooms, const Rational& length) {
  if (!rooms.unit) return short_number(nearest_double(length));
  return short_number(nearest_double(length * rooms.unit->metres)) + " m";
}

/// " 22 m in inches (--unit in), ...": units that make a building of it.
std::string guesses(double extent) {
  constexpr double kLeast = 4, kMost = 500;
  constexpr std::array<std::pair<const char*, double>, 5> kUnits{
      {{"mm", 0.001}, {"cm", 0.01}, {"in", 0.0254}, {"ft", 0.3048}, {"m", 1}}};
  std::string text;
  for (const auto& [name, metres] : kUnits) {
    const double length = extent * metres;
    if (length < kLeast || length > kMost) continue;
    text += fmt::format("{} {:.3g} m with --unit {}", text.empty() ? "" : ",", length, name);
  }
  return text.empty() ? " what --unit says" : text;
}

std::string unit_line(const Rooms& rooms) {
  if (rooms.unit) {
    return fmt::format("a drawing unit is {} m{}\n", exact_text(rooms.unit->metres),
                       rooms.unit->name.empty() ? "" : " (" + line_text(rooms.unit->name) + ")");
  }
  if (rooms.doubted) {
    return fmt::format(
        "areas in drawing units: the file says {}, which would make the drawing {} m long; it "
        "would "
        "be{}\n",
        line_text(rooms.doubted->name),
        short_number(rooms.extent * nearest_double(rooms.doubted->metres)), guesses(rooms.extent));
  }
  return "areas in drawing units: the file does not say what they are (--unit mm, cm, m, in, ft)\n";
}

std::string left_out(const Rooms& rooms) {
  std::string text;
  const auto has_door = [](const Room& room) {
    return std::any_of(room.neighbours.begin(), room.neighbours.end(),
                       [](const RoomNeighbour& next) { return next.door; });
  };
  if (std::any_of(rooms.rooms.begin(), rooms.rooms.end(), has_door)) {
    text += "d: behind a door\n";
  }
  if (rooms.narrow > 0) {
    text += fmt::format("left out: {} not {} wide (walls; --min-width)\n",
                        counted(rooms.narrow, "area"), length_text(rooms, rooms.min_width));
  }
  if (rooms.small > 0) {
    text += fmt::format("left out: {} below {} (--min-area)\n", counted(rooms.small, "area"),
                        area_text(rooms, rooms.min_area));
  }
  return text;
}

std::string outside(const Rooms& rooms, const SegmentSet& input) {
  constexpr std::size_t kTexts = 4, kWidest = 24;
  if (rooms.outside.empty()) return {};
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < std::min(rooms.outside.size(), kTexts); ++i) {
    texts.push_back('"' + cut(line_text(input.labels[rooms.outside[i]].text), kWidest) + '"');
  }
  return fmt::format("{} in no room, or on a line: {}{}\n", counted(rooms.outside.size(), "text"),
                     fmt::join(texts, ", "), rooms.outside.size() > kTexts ? ", ..." : "");
}

}  // namespace

std::string rooms_line(const Rooms& rooms) {
  Rational sum;
  for (const Room& room : rooms.rooms) sum += room.area;
  return counted(rooms.rooms.size(), "room") + ", " + area_text(rooms, sum);
}

std::string area_text(const Rooms& rooms, const Rational& area) {
  if (!rooms.unit) return short_number(nearest_double(area));
  const Rational square = rooms.unit->metres * rooms.unit->metres;
  return fmt::format("{:.2f} m2", nearest_double(area * square));
}

std::vector<std::string> own_names(const std::vector<std::string>& layers) {
  std::vector<std::string> result;
  for (const std::string& layer : layers) {
    std::string name(own_layer_name(layer));
    if (std::find(result.begin(), result.end(), name) == result.end()) {
      result.push_back(std::move(name));
    }
  }
  return result;
}

std::string to_text(const Rooms& rooms, const SegmentSet& input,
                    std::optional<std::size_t> listed) {
  Rational sum;
  std::size_t named = 0;
  for (const Room& room : rooms.rooms) {
    sum += room.area;
    if (!room.names.empty()) ++named;
  }
  std::string text = fmt::format("{}, {} with a name, {} in all\n",
                                 counted(rooms.rooms.size(), "room"), named, area_text(rooms, sum));
  text += unit_line(rooms);
  std::vector<std::size_t> shown(rooms.rooms.size());
  for (std::size_t r = 0; r < shown.size(); ++r) shown[r] = r;
  const std::size_t most = listed.value_or(kShown);
  if (shown.size() > most) {
    std::stable_sort(shown.begin(), shown.end(), [&](std::size_t a, std::size_t b) {
      return rooms.rooms[a].area > rooms.rooms[b].area;
    });
    shown.resize(most);
    std::sort(shown.begin(), shown.end());
  }
  if (!shown.empty()) {
    text += fmt::format("{:>5}  {:>12}  {:<40}  {:<24}  {}\n", "room", "area", "name", "neighbours",
                        "layers");
  }
  for (const std::size_t r : shown) text += row(rooms, r);
  if (shown.size() < rooms.rooms.size()) {
    text += fmt::format("  ... and {} smaller (--list N, -o rooms.csv)\n",
                        rooms.rooms.size() - shown.size());
  }
  return text + rest_text(rooms, input);
}

std::string rest_text(const Rooms& rooms, const SegmentSet& input) {
  return left_out(rooms) + outside(rooms, input);
}

}  // namespace plumbline
