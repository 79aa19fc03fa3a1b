#include "certificates/damage.hpp"

#include <gmpxx.h>

#include <algorithm>

#include "certificates/fields.hpp"
#include "certificates/forget_meetings.hpp"

namespace plumbline::certificates {

std::size_t below(Random& random, std::size_t bound) { return random() % bound; }

namespace {

const char* const kSections[] = {"vertices", "edges", "cycles", "faces", "components"};

Line& any_line(Fields& fields, Random& random) {
  return fields.lines[below(random, fields.lines.size())];
}
std::string& any_field(Fields& fields, Random& random) {
  Line& line = any_line(fields, random);
  return line[below(random, line.size())];
}

/// A line of a section drawn at random, or null.
Line* any_item(Fields& fields, Random& random, const char* section) {
  const std::size_t count = fields.count(section);
  return count > 0 ? &fields.item(section, below(random, count)) : nullptr;
}

/// A section with at least so many lines, or null.
const char* section_of(Fields& fields, Random& random, std::size_t count) {
  const char* section = kSections[below(random, std::size(kSections))];
  return fields.count(section) >= count ? section : nullptr;
}

void change_byte(Fields& fields, Random& random) {
  std::string& field = any_field(fields, random);
  if (!field.empty()) field[below(random, field.size())] = "0123456789+-/:. x"[below(random, 17)];
}
void insert_byte(Fields& fields, Random& random) {
  std::string& field = any_field(fields, random);
  field.insert(below(random, field.size() + 1), 1, "0123456789+-/:. x"[below(random, 17)]);
}
void drop_byte(Fields& fields, Random& random) {
  std::string& field = any_field(fields, random);
  if (!field.empty()) field.erase(below(random, field.size()), 1);
}
void cut_off(Fields& fields, Random& random) {
  fields.lines.resize(below(random, fields.lines.size()));
}
void replace_field(Fields& fields, Random& random) {
  std::string& field = any_field(fields, random);
  field = any_field(fields, random);
}
void exchange_fields(Fields& fields, Random& random) {
  std::string& a = any_field(fields, random);
  std::string& b = any_field(fields, random);
  std::swap(a, b);
}
void drop_field(Fields& fields, Random& random) {
  Line& line = any_line(fields, random);
  line.erase(line.begin() + static_cast<std::ptrdiff_t>(below(random, line.size())));
  if (line.empty()) line.emplace_back();
}
void repeat_field(Fields& fields, Random& random) {
  Line& line = any_line(fields, random);
  const auto at = line.begin() + static_cast<std::ptrdiff_t>(below(random, line.size()));
  line.insert(at, std::string(*at));
}
void count_on(Fields& fields, Random& random) {
  std::string& field = any_field(fields, random);
  mpz_class value;
  const std::size_t begin = field.find_last_of(":+-/") + 1;
  if (begin == field.size() || value.set_str(field.substr(begin), 10) != 0) return;
  value += below(random, 2) == 0 ? 1 : -1;
  field.replace(begin, field.npos, value.get_str());
}

void exchange_items(Fields& fields, Random& random) {
  const char* section = section_of(fields, random, 2);
  if (section == nullptr) return;
  std::swap(*any_item(fields, random, section), *any_item(fields, random, section));
}
void drop_item(Fields& fields, Random& random) {
  const char* section = section_of(fields, random, 1);
  if (section == nullptr) return;
  const std::size_t head = fields.head(section);
  const std::size_t count = fields.count(section);
  fields.lines.erase(fields.lines.begin() +
                     static_cast<std::ptrdiff_t>(head + 1 + below(random, count)));
  fields.lines[head][1] = std::to_string(count - 1);
}
void repeat_item(Fields& fields, Random& random) {
  const char* section = section_of(fields, random, 1);
  if (section == nullptr) return;
  const std::size_t head = fields.head(section);
  const std::size_t count = fields.count(section);
  const auto at =
      fields.lines.begin() + static_cast<std::ptrdiff_t>(head + 1 + below(random, count));
  fields.lines.insert(at, Line(*at));
  fields.lines[head][1] = std::to_string(count + 1);
}
void sort_section(Fields& fields, Random& random) {
  const char* section = section_of(fields, random, 2);
  if (section == nullptr) return;
  const auto begin = fields.lines.begin() + static_cast<std::ptrdiff_t>(fields.head(section) + 1);
  std::sort(begin, begin + static_cast<std::ptrdiff_t>(fields.count(section)));
}

void rotate_cycle(Fields& fields, Random& random) {
  Line* cycle = any_item(fields, random, "cycles");
  if (cycle == nullptr) return;
  std::rotate(cycle->begin(),
              cycle->begin() + static_cast<std::ptrdiff_t>(below(random, cycle->size())),
              cycle->end());
}
void reverse_cycle(Fields& fields, Random& random) {
  Line* cycle = any_item(fields, random, "cycles");
  if (cycle == nullptr) return;
  std::reverse(cycle->begin(), cycle->end());
  for (std::string& h : *cycle) h[0] = h[0] == '+' ? '-' : '+';
}
void exchange_halfedges(Fields& fields, Random& random) {
  Line* cycle = any_item(fields, random, "cycles");
  if (cycle == nullptr) return;
  std::swap((*cycle)[below(random, cycle->size())], (*cycle)[below(random, cycle->size())]);
}
void merge_cycles(Fields& fields, Random& random) {
  if (fields.count("cycles") < 2) return;
  const std::size_t head = fields.head("cycles");
  const std::size_t at = head + 1 + below(random, fields.count("cycles") - 1);
  Line& cycle = fields.lines[at];
  const Line& next = fields.lines[at + 1];
  cycle.insert(cycle.begin() + static_cast<std::ptrdiff_t>(1 + below(random, cycle.size())),
               next.begin(), next.end());
  fields.lines.erase(fields.lines.begin() + static_cast<std::ptrdiff_t>(at + 1));
  fields.lines[head][1] = std::to_string(fields.count("cycles") - 1);
}
void walk_twice(Fields& fields, Random& random) {
  Line* cycle = any_item(fields, random, "cycles");
  if (cycle == nullptr) return;
  const Line once = *cycle;
  cycle->insert(cycle->end(), once.begin(), once.end());
}

/// Moves an item of a list, holes or isolated, from one face to another.
void move_to_another_face(Fields& fields, Random& random) {
  std::vector<std::pair<std::size_t, std::string>>
      items;  // faces and their lists that have something
  for (std::size_t f = 0; f < fields.count("faces"); ++f) {
    const Line& face = fields.item("faces", f);
    for (std::size_t i = 1; i < face.size(); ++i) {
      const bool is_list = face[i - 1] == "holes" || face[i - 1] == "isolated";
      if (is_list && face[i] != "isolated" && face[i] != "inside") {
        items.emplace_back(f, face[i - 1]);
      }
    }
  }
  if (items.empty()) return;
  const auto& [f, list] = items[below(random, items.size())];
  Line& from = fields.item("faces", f);
  const auto at = std::find(from.begin(), from.end(), list) + 1;
  const std::string item = *at;
  from.erase(at);
  Line& to = *any_item(fields, random, "faces");
  const auto place = std::find(to.begin(), to.end(), list);
  if (place != to.end()) to.insert(place + 1, item);
}
void move_component(Fields& fields, Random& random) {
  Line* component = any_item(fields, random, "components");
  if (component == nullptr || fields.count("faces") == 0) return;
  component->back() = std::to_string(below(random, fields.count("faces")));
}
void change_parent(Fields& fields, Random& random) {
  Line* face = any_item(fields, random, "faces");
  if (face == nullptr || face->size() < 6) return;
  (*face)[5] = std::to_string(below(random, fields.count("faces")));
}

using Place = std::pair<mpq_class, mpq_class>;

Place place_of(const Line& line, std::size_t at) {
  return {mpq_class(line[at]), mpq_class(line[at + 1])};
}
void put(Line& line, std::size_t at, const Place& place) {
  line[at] = place.first.get_str();
  line[at + 1] = place.second.get_str();
}
/// 10^-k, k drawn at random.
mpq_class little(Random& random) {
  constexpr unsigned kMostDigits = 30;
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, below(random, kMostDigits));
  return mpq_class(below(random, 2) == 0 ? 1 : -1, power);
}
/// A point on the line through two, most often between them.
Place between(const Place& a, const Place& b, Random& random) {
  const mpq_class t(static_cast<unsigned long>(1 + below(random, 4)), 4);
  return {a.first + t * (b.first - a.first), a.second + t * (b.second - a.second)};
}

void move_vertex(Fields& fields, Random& random) {
  Line* vertex = any_item(fields, random, "vertices");
  if (vertex == nullptr) return;
  auto [x, y] = place_of(*vertex, 0);
  (below(random, 2) == 0 ? x : y) += little(random);
  put(*vertex, 0, {x, y});
}
void move_vertex_to_another(Fields& fields, Random& random) {
  if (fields.count("vertices") == 0) return;
  Line* vertex = any_item(fields, random, "vertices");
  Line* other = any_item(fields, random, "vertices");
  put(*vertex, 0, between(place_of(*vertex, 0), place_of(*other, 0), random));
}
void move_vertex_along_edge(Fields& fields, Random& random) {
  const Line* edge = any_item(fields, random, "edges");
  if (edge == nullptr) return;
  Line& tail = fields.item("vertices", std::stoul((*edge)[0]));
  Line& head = fields.item("vertices", std::stoul((*edge)[1]));
  Line& moved = below(random, 2) == 0 ? tail : head;
  put(moved, 0, between(place_of(tail, 0), place_of(head, 0), random));
}
void move_everything(Fields& fields, Random& random) {
  const mpq_class dx = little(random);
  const mpq_class dy = little(random);
  for (std::size_t v = 0; v < fields.count("vertices"); ++v) {
    Line& vertex = fields.item("vertices", v);
    const auto [x, y] = place_of(vertex, 0);
    put(vertex, 0, {x + dx, y + dy});
  }
}
void move_inside(Fields& fields, Random& random) {
  if (fields.count("faces") < 2) return;
  Line& face = fields.item("faces", 1 + below(random, fields.count("faces") - 1));
  const Line& a = *any_item(fields, random, "vertices");
  const Line& other = fields.item("faces", 1 + below(random, fields.count("faces") - 1));
  Place place = place_of(face, face.size() - 2);
  switch (below(random, 4)) {
    case 0:
      place = place_of(a, 0);
      break;
    case 1:
      place = between(place, place_of(a, 0), random);
      break;
    case 2:
      place = between(place_of(*any_item(fields, random, "vertices"), 0), place_of(a, 0), random);
      break;
    default:
      place = place_of(other, other.size() - 2);
  }
  put(face, face.size() - 2, place);
}

/// Gives two segments each other's pieces.
void exchange_segments(Fields& fields, Random& random) {
  const Line* edge = any_item(fields, random, "edges");
  const Line* other = any_item(fields, random, "edges");
  if (edge == nullptr) return;
  const auto segment = [](const std::string& field) { return field.substr(0, field.find(':')); };
  const std::string a = segment(edge->back());
  const std::string b = segment(other->back());
  for (std::size_t e = 0; e < fields.count("edges"); ++e) {
    Line& line = fields.item("edges", e);
    for (std::size_t i = 2; i < line.size(); ++i) {
      const std::string s = segment(line[i]);
      if (s == a || s == b) line[i].replace(0, s.size(), s == a ? b : a);
    }
  }
}
void forget_piece(Fields& fields, Random& random) {
  Line* edge = any_item(fields, random, "edges");
  if (edge == nullptr || edge->size() < 4) return;
  edge->erase(edge->begin() + static_cast<std::ptrdiff_t>(2 + below(random, edge->size() - 2)));
}
void change_reason(Fields& fields, Random& random) {
  Line* vertex = any_item(fields, random, "vertices");
  const Line* other = any_item(fields, random, "vertices");
  if (vertex == nullptr) return;
  const Line reason(other->begin() + 2, other->end());
  vertex->resize(2);
  vertex->insert(vertex->end(), reason.begin(), reason.end());
}

}  // namespace

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {
      {"change a byte", change_byte},
      {"insert a byte", insert_byte},
      {"drop a byte", drop_byte},
      {"cut off the end", cut_off},
      {"replace a field by another", replace_field},
      {"exchange two fields", exchange_fields},
      {"drop a field", drop_field},
      {"repeat a field", repeat_field},
      {"a number one more or less", count_on},
      {"exchange two lines of a section", exchange_items},
      {"drop a line and count on", drop_item},
      {"repeat a line and count on", repeat_item},
      {"sort a section as text", sort_section},
      {"start a cycle elsewhere", rotate_cycle},
      {"reverse a cycle", reverse_cycle},
      {"exchange two halfedges of a cycle", exchange_halfedges},
      {"merge two cycles", merge_cycles},
      {"walk a cycle twice", walk_twice},
      {"move a hole or isolated vertex to another face", move_to_another_face},
      {"move a component to another face", move_component},
      {"another parent", change_parent},
      {"move a vertex a little", move_vertex},
      {"move a vertex towards another", move_vertex_to_another},
      {"move a vertex along an edge", move_vertex_along_edge},
      {"move all vertices", move_everything},
      {"move a point inside a face", move_inside},
      {"exchange two segments", exchange_segments},
      {"forget where edges meet", forget_meetings},
      {"forget a segment that covers an edge", forget_piece},
      {"another reason of a vertex", change_reason},
  };
  return all;
}

std::string damaged(const std::string& text, const Kind& kind, Random& random) {
  Fields fields(text);
  kind.apply(fields, random);
  return fields.text();
}

}  // namespace plumbline::certificates
