// plumbline_study_inputs --list: names of families, a line each.
// plumbline_study_inputs FAMILY FIRST COUNT: drawings of a family for COUNT seeds from FIRST on.
// One JSON object a line:
// {"family": "plan", "seed": 7, "segments": [["0", "0", "1/3", "2.5"], ...]}, numbers as exact
// texts. Segments without length and isolated points are left out. Besides the families of the
// campaign there are floor plans in metres, half of them turned: "rooms", all walls closed, and
// "rooms with doors", with openings cut into walls.

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

#include "inputs/families.hpp"
#include "plumbline/number.hpp"
#include "repair/plans.hpp"

using namespace plumbline;

namespace {

constexpr std::string_view kRooms = "rooms", kDoors = "rooms with doors";

SegmentSet drawing(const std::string& family, std::uint64_t seed) {
  if (family != kRooms && family != kDoors) {
    return inputs::of_family(family, static_cast<unsigned>(seed));
  }
  const repairs::Plan plan = repairs::plan(repairs::Damage::Doors, Rational(0), seed);
  return family == kRooms ? plan.right : plan.damaged;
}

void print(const std::string& family, std::uint64_t seed) {
  std::string text;
  for (const Segment& s : drawing(family, seed).segments) {
    if (s.a == s.b) continue;
    if (!text.empty()) text += ", ";
    text += fmt::format(R"(["{}", "{}", "{}", "{}"])", exact_text(s.a.x), exact_text(s.a.y),
                        exact_text(s.b.x), exact_text(s.b.y));
  }
  fmt::print("{{\"family\": \"{}\", \"seed\": {}, \"segments\": [{}]}}\n", family, seed, text);
}

std::uint64_t number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw std::invalid_argument("no number: " + std::string(text));
  }
  return value;
}

void list() {
  for (const std::string& family : inputs::families()) fmt::print("{}\n", family);
  fmt::print("{}\n{}\n", kRooms, kDoors);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 2 && std::string_view(argv[1]) == "--list") {
      list();
      return 0;
    }
    if (argc != 4) {
      fmt::print(stderr, "usage: plumbline_study_inputs --list | FAMILY FIRST COUNT\n");
      return 2;
    }
    const std::uint64_t first = number(argv[2]), count = number(argv[3]);
    for (std::uint64_t i = 0; i < count; ++i) print(argv[1], first + i);
  } catch (const std::exception& error) {
    fmt::print(stderr, "plumbline_study_inputs: {}\n", error.what());
    return 2;
  }
  return 0;
}
