// Rooms as a page: the plan and a table, which answer to each other.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "output/page/assets.hpp"
#include "output/svg/rooms.hpp"
#include "output/svg/sheet.hpp"
#include "output/text/escape.hpp"
#include "output/text/rooms.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

std::string joined(const std::vector<std::string>& texts) {
  return xml_text(fmt::format("{}", fmt::join(texts, ", ")));
}

std::string neighbours_of(const Room& room) {
  std::vector<std::string> texts;
  for (const RoomNeighbour& next : room.neighbours) {
    texts.push_back(std::to_string(next.room + 1) + (next.door ? " (door)" : ""));
  }
  return joined(texts);
}

std::string row(const Rooms& rooms, std::size_t r) {
  const Room& room = rooms.rooms[r];
  return fmt::format(
      "<tr data-room=\"{0}\" tabindex=\"0\"><td class=\"number\" data-value=\"{0}\">{0}</td>"
      "<td>{1}</td><td class=\"number\" data-value=\"{2}\">{3}</td><td>{5}</td><td "
      "class=\"layers\" title=\"{4}\">{4}</td></tr>\n",
      r + 1, joined(room.names), shortest_text(nearest_double(room.area)),
      area_text(rooms, room.area), joined(own_names(room.layers)), neighbours_of(room));
}

std::string list_section(const Rooms& rooms, const SegmentSet& input, const std::string& title) {
  std::string text = fmt::format(
      "<section id=\"list\">\n<h1>{}</h1>\n<p>{}</p>\n"
      "<input id=\"search\" type=\"search\" placeholder=\"Search names, layers, numbers\" "
      "aria-label=\"Search rooms\">\n<p id=\"found\" aria-live=\"polite\"></p>\n"
      "<table id=\"rooms\"><thead><tr>",
      xml_text(title), rooms_line(rooms));
  for (const char* heading : {"room", "name", "area", "neighbours", "layers"}) {
    text += fmt::format("<th scope=\"col\"><button type=\"button\">{}</button></th>", heading);
  }
  text += "</tr></thead>\n<tbody>\n";
  for (std::size_t r = 0; r < rooms.rooms.size(); ++r) text += row(rooms, r);
  text += "</tbody></table>\n";
  const std::string rest = rest_text(rooms, input);
  return text + (rest.empty() ? "" : "<p>" + xml_text(rest) + "</p>\n") + "</section>\n";
}

}  // namespace

std::string to_html(const Rooms& rooms, const SegmentSet& input, const ExactComplex& complex) {
  const std::string title = svg::sheet::titled(input, "rooms");
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src "
      "'unsafe-inline'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n<section id=\"plan\">\n{}"
      "<button id=\"whole\" type=\"button\">whole plan</button>\n</section>\n{}"
      "<script>\n{}</script>\n</body>\n</html>\n",
      xml_text(title), kRoomsStyle, plan_of_rooms(rooms, input, complex),
      list_section(rooms, input, title), kRoomsScript);
}

}  // namespace plumbline
