// How fast structures are walked and flattened: plans of placed four-wall rooms, as a Markdown
// table. The peer maps the same corners in GMP's rationals.
// Usage: plumbline_structure_times [INSTANCES]; one million if not given.

#include <fmt/format.h>
#include <sys/resource.h>

#include <cstdlib>

#include "plumbline/structure.hpp"
#include "times/table.hpp"

using namespace plumbline;

namespace {

constexpr std::size_t kRow = 1000;

long peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

/// Rows of a thousand rooms of 4 x 3, a wall of 0.1 apart, under a map.
Structure plan(std::size_t instances, const Affine& map) {
  LarModel room = cuboids({1, 1}, true);
  room = apply(scaling(4, 3), room);
  room.cells = {room.cells[1]};
  Struct row{"row", "", {}};
  for (std::size_t i = 0; i < kRow; ++i) {
    row.body.emplace_back(StructId(0));
    row.body.emplace_back(translation(Rational(41, 10), 0));
  }
  Struct whole{"plan", "", {map}};
  for (std::size_t i = 0; i < instances / kRow; ++i) {
    whole.body.emplace_back(StructId(1));
    whole.body.emplace_back(translation(0, Rational(31, 10)));
  }
  Structure structure;
  structure.structs = {{"room", "", {std::move(room)}}, std::move(row), std::move(whole)};
  structure.root = StructId(2);
  return structure;
}

/// The four corners of each room in GMP's rationals, nothing kept: the least that exact maps cost
/// without decimals in place.
double in_rationals(std::size_t instances, const Affine& map) {
  std::array<Rational, 6> e;
  for (std::size_t i = 0; i < e.size(); ++i) e[i] = map.entries()[i].rational();
  return times::seconds([&] {
    for (std::size_t i = 0; i < instances; ++i) {
      for (const int corner : {0, 1, 2, 3}) {
        Rational x(static_cast<long>(41 * (i % kRow)) + 40 * (corner % 2), 10);
        Rational y(static_cast<long>(31 * (i / kRow)) + 30 * (corner / 2), 10);
        x.canonicalize();
        y.canonicalize();
        const Rational image_x = e[0] * x + e[1] * y + e[2];
        const Rational image_y = e[3] * x + e[4] * y + e[5];
        if (image_x == image_y && sgn(image_x) != 0 && image_x == 1) std::abort();  // is used
      }
    }
  });
}

void print_row(const char* what, std::size_t instances, const Affine& map) {
  const Structure structure = plan(instances, map);
  std::size_t walked = 0;
  const double walking = times::seconds([&] {
    for (Traversal t(structure); t.next();) ++walked;
  });
  const double boxing = times::seconds([&] { box(structure); });
  std::size_t segments = 0;
  const double flattening = times::seconds([&] { segments = evaluate(structure).segments.size(); });
  const double rational = in_rationals(instances, map);
  fmt::print("| {} | {} | {:.2f} s | {:.3f} s | {:.2f} s | {} | {:.2f} s | {:.1f} | {} MB |\n",
             what, walked, walking, boxing, flattening, segments, rational, rational / flattening,
             peak_megabytes());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t instances = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000;
  fmt::print(
      "| maps | instances | walk | box | flatten | segments | corners in rationals | ratio | peak "
      "|\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  print_row("decimals", instances, Affine());
  print_row("quarter turn, mirrored", instances, Affine{0, 1, 1, 0, 0, 0});
  print_row("30 degrees, rational", instances, rotation(30).map);
}
