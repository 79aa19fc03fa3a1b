// Plans with known rooms, damaged, and repaired with one tolerance just above the damage and with
// automatic ones; what became of the rooms. Prints a JSON object a line for by_others.py. Usage:
// plumbline_rooms_again COUNT [FIRST-SEED [DRAWINGS]]; COUNT plans of each damage and size.
// DRAWINGS is a folder for the plans that come to harm.

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

#include "plumbline/arrange.hpp"
#include "plumbline/engines/lar.hpp"
#include "plumbline/error.hpp"
#include "repair/outcome.hpp"

using namespace plumbline;
using namespace plumbline::repairs;

namespace {

constexpr const char* kOutcomeNames[kOutcomes] = {"exact", "right", "listed", "unsaid", "harm"};

std::string lines_text(const SegmentSet& set) {
  std::string result;
  for (const Segment& s : set.segments) {
    const PointD a = nearest(s.a), b = nearest(s.b);
    result += fmt::format("{}[{},{},{},{}]", result.empty() ? "" : ",", a.x, a.y, b.x, b.y);
  }
  return "[" + result + "]";
}

std::string lines_text(const FloatComplex& complex) {
  std::string result;
  for (const Edge& edge : complex.edges) {
    const PointD a = complex.vertices[edge.tail], b = complex.vertices[edge.head];
    result += fmt::format("{}[{},{},{},{}]", result.empty() ? "" : ",", a.x, a.y, b.x, b.y);
  }
  return "[" + result + "]";
}

std::string rooms_text(const SegmentSet& right) {
  std::string result;
  for (const Room& room : rooms_of(arrange(right))) {
    const PointD p = nearest(room.inside);
    result += fmt::format("{}[{},{},{},{}]", result.empty() ? "" : ",", p.x, p.y,
                          nearest_double(room.area), room.perimeter);
  }
  return "[" + result + "]";
}

void write_lines(const std::string& path, const SegmentSet& set) {
  std::ofstream file(path);
  for (const Segment& s : set.segments) {
    file << exact_text(s.a.x) << ',' << exact_text(s.a.y) << ',' << exact_text(s.b.x) << ','
         << exact_text(s.b.y) << '\n';
  }
}

/// One plan, repaired in one way.
struct Attempt {
  Repair repair;
  Judgement judgement;
  std::size_t given_up = 0;
};

Attempt attempt(const Plan& plan, const RepairOptions& options) {
  Attempt result;
  result.repair = repair(plan.damaged, options);
  result.judgement = judged(plan, result.repair);
  for (const Refusal& refusal : result.repair.refused) {
    if (refusal.reason.find("promise") != std::string::npos) ++result.given_up;
  }
  return result;
}

std::string attempt_text(const Attempt& a) {
  return fmt::format(R"(["{}",{},{},"{}"])",
                     kOutcomeNames[static_cast<std::size_t>(a.judgement.outcome)],
                     a.judgement.harmed, a.given_up, a.judgement.where);
}

void one_plan(Damage damage, const Rational& ratio, std::uint64_t seed,
              const std::string& drawings) {
  const Plan drawn = plan(damage, ratio, seed);
  RepairOptions one, automatic;
  if (has_doors(damage)) one.doors = automatic.doors = door_widths();
  for (auto* each : {&one.weld, &one.grow, &one.trim, &one.sliver}) {
    *each = has_size(damage) ? drawn.size : Rational(0);
  }
  const Attempt with_one = attempt(drawn, one), with_automatic = attempt(drawn, automatic);
  const lar::Result by_lar = lar::arrange(drawn.damaged, {nearest_double(drawn.size)});
  fmt::print(R"({{"damage":"{}","ratio":"{}","size":{},"seed":{},"rooms":{},"damaged":{},)"
             R"("repaired":{},"lar":{},"one":{},"auto":{}}})"
             "\n",
             to_text(damage), exact_text(ratio), nearest_double(drawn.size), seed,
             rooms_text(drawn.right), lines_text(drawn.damaged), lines_text(with_one.repair.output),
             lines_text(by_lar.complex), attempt_text(with_one), attempt_text(with_automatic));
  const auto is_silent = [](const Attempt& a) { return a.judgement.outcome >= Outcome::Unsaid; };
  if (drawings.empty() || !(is_silent(with_one) || is_silent(with_automatic))) return;
  const std::string name =
      fmt::format("{}/{}-{}-{}", drawings, static_cast<int>(damage), nearest_double(ratio), seed);
  write_lines(name + ".lines", drawn.damaged);
  write_lines(name + ".right.lines", drawn.right);
}

}  // namespace

int main(int argc, char** argv) try {
  const unsigned long count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 0;
  const unsigned long first = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
  const std::string drawings = argc > 3 ? argv[3] : "";
  if (count == 0) {
    fmt::print(stderr, "usage: plumbline_rooms_again COUNT [FIRST-SEED [DRAWINGS]]\n");
    return 2;
  }
  for (std::size_t d = 0; d < kDamages; ++d) {
    for (int half = 32; half > 0; half /= 2) {
      const auto damage = static_cast<Damage>(d);
      if (!has_size(damage) && half != 1) continue;
      for (unsigned long seed = first; seed < first + count; ++seed) {
        one_plan(damage, Rational(1, half), seed, drawings);
      }
    }
  }
  return 0;
} catch (const Error& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
