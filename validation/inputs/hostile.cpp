#include "inputs/hostile.hpp"

#include <cmath>
#include <string_view>
#include <utility>

#include "inputs/workloads.hpp"

namespace plumbline::inputs {
namespace {

using Size = std::uint64_t;
using Cells = Hostile::Cells;

constexpr Size kCopies = 1000;

/// A SegmentSet from integers.
class IntegerBuilder {
 public:
  IntegerBuilder() : source_(set_.add_source({})) {}
  void add(long ax, long ay, long bx, long by) { add({{ax, ay}, {bx, by}}); }
  void add(Segment s) { set_.add(std::move(s), source_); }
  void add_square(long x0, long y0, long x1, long y1) {
    add(x0, y0, x1, y0);
    add(x1, y0, x1, y1);
    add(x1, y1, x0, y1);
    add(x0, y1, x0, y0);
  }
  SegmentSet take() { return std::move(set_); }

 private:
  SegmentSet set_;
  SourceId source_;
};

long signed_size(Size size) { return static_cast<long>(size); }

SegmentSet repeated(const SegmentSet& input, Size copies) { return tiles(input, copies, 0, 0); }

SegmentSet mapped(const SegmentSet& input, Point (*map)(const Point&)) {
  IntegerBuilder builder;
  for (const Segment& s : input.segments) builder.add({map(s.a), map(s.b)});
  return builder.take();
}

SegmentSet one_segment(Size copies) {
  IntegerBuilder builder;
  builder.add(0, 0, 1000, 777);
  return repeated(builder.take(), copies);
}

SegmentSet copied_segments(Size distinct) { return repeated(random_segments(distinct), kCopies); }

/// Square rooms in rows and columns, four walls each.
SegmentSet rooms(Size rows) {
  IntegerBuilder builder;
  for (long x = 0; x < signed_size(rows); ++x) {
    for (long y = 0; y < signed_size(rows); ++y) builder.add_square(x, y, x + 1, y + 1);
  }
  return builder.take();
}

SegmentSet copied_rooms(Size rows) { return repeated(rooms(rows), kCopies); }

SegmentSet rooms_twice(Size rows) { return repeated(rooms(rows), 2); }

std::optional<Cells> rooms_cells(Size rows) {
  return Cells{(rows + 1) * (rows + 1), 2 * rows * (rows + 1), rows * rows + 1};
}

SegmentSet in_a_corner(Size n) {
  SegmentSet set = mapped(random_segments(n), [](const Point& p) {
    return Point{p.x / 1'000'000, p.y / 1'000'000};
  });
  set.add({{Rational(1, 1000), Rational(1, 1000)}, {1, 1}}, SourceId(0));
  return set;
}

/// A fan of unit-sized bars on a lattice of pitch 4 and one segment above them, 4 n times as long.
SegmentSet one_huge(Size n) {
  IntegerBuilder builder;
  const long side = 1 + static_cast<long>(std::sqrt(static_cast<double>(n)));
  for (long i = 0; i < signed_size(n); ++i) {
    const long x = 4 * (i % side), y = 4 * (i / side);
    builder.add(x, y, x + 1 + i % 3, y + 1 + i % 2);
  }
  builder.add(-4, 4 * side, 4 * signed_size(n), 4 * side + 1);
  return builder.take();
}

SegmentSet squeezed(Size n) {
  return mapped(random_segments(n), [](const Point& p) { return Point{p.x, p.y / 1'000'000}; });
}

/// Squeezed, and rounded to 1e-9: 1000 rows.
SegmentSet squeezed_and_rounded(Size n) {
  return mapped(random_segments(n), [](const Point& p) {
    const Rational thousandths = p.y * 1000;
    const mpz_class floor = thousandths.get_num() / thousandths.get_den();
    Rational y(floor, 1'000'000'000);
    y.canonicalize();
    return Point{p.x, y};
  });
}

SegmentSet nested_overlaps(Size n) {
  IntegerBuilder builder;
  for (long i = 0; i < signed_size(n); ++i) builder.add(i, 0, 2 * signed_size(n) - i, 0);
  return builder.take();
}

constexpr Size kOverlap = 10;

SegmentSet successive_overlaps(Size n) {
  IntegerBuilder builder;
  for (long i = 0; i < signed_size(n); ++i) builder.add(i, i, i + kOverlap, i + kOverlap);
  return builder.take();
}

SegmentSet hatch(Size n) {
  IntegerBuilder builder;
  for (long i = 0; i < signed_size(n); ++i) builder.add(i, 0, i + signed_size(n), signed_size(n));
  return builder.take();
}

SegmentSet concentric_squares(Size n) {
  IntegerBuilder builder;
  for (long i = 1; i <= signed_size(n); ++i) builder.add_square(-i, -i, i, i);
  return builder.take();
}

/// A spine and teeth on it.
SegmentSet comb(Size teeth) {
  IntegerBuilder builder;
  builder.add(0, 0, 2 * signed_size(teeth), 0);
  for (long i = 0; i < signed_size(teeth); ++i) builder.add(2 * i + 1, 0, 2 * i + 1, 7);
  return builder.take();
}

/// R1 and one segment far away.
SegmentSet one_far_away(Size n) {
  SegmentSet set = random_segments(n);
  const Rational far = Rational(mpz_class("1000000000000000000000000000000"));
  set.add({{far, far}, {far, 2 * far}}, SourceId(0));
  return set;
}

SegmentSet stairs_of_slants(Size n) {
  IntegerBuilder builder;
  for (long i = 0; i < signed_size(n); ++i) {
    builder.add(i, -3 * i, 10'000'000 + i, 3'000'000 - 3 * i);
  }
  return builder.take();
}

SegmentSet concentric_triangles(Size n) {
  IntegerBuilder builder;
  for (long i = 1; i <= signed_size(n); ++i) {
    const long k = 7 * i;
    builder.add(-3 * k, -2 * k, 4 * k, -3 * k);
    builder.add(4 * k, -3 * k, k, 5 * k);
    builder.add(k, 5 * k, -3 * k, -2 * k);
  }
  return builder.take();
}

/// Level lines and, beside them, as many upright ones.
SegmentSet two_bundles(Size n) {
  IntegerBuilder builder;
  const long length = 20 * signed_size(n);
  for (long i = 0; i < signed_size(n); ++i) {
    builder.add(0, i, length, i);
    builder.add(-1 - i, 0, -1 - i, length);
  }
  return builder.take();
}

std::optional<Cells> unknown(Size) { return std::nullopt; }
std::optional<Cells> one_edge(Size) { return Cells{2, 1, 1}; }
std::optional<Cells> disjoint(Size n) { return Cells{2 * n, n, 1}; }
std::optional<Cells> chain(Size n) { return Cells{2 * n, 2 * n - 1, 1}; }

std::optional<Cells> one_more_than_disjoint(Size n) { return disjoint(n + 1); }
std::optional<Cells> successive_chain(Size n) { return Cells{n + kOverlap, n + kOverlap - 1, 1}; }
std::optional<Cells> lines_through_a_point(Size n) { return Cells{2 * n + 1, 2 * n, 1}; }
std::optional<Cells> squares_cells(Size n) { return Cells{4 * n, 4 * n, n + 1}; }
std::optional<Cells> triangles_cells(Size n) { return Cells{3 * n, 3 * n, n + 1}; }
std::optional<Cells> two_bundles_cells(Size n) { return disjoint(2 * n); }
std::optional<Cells> comb_cells(Size n) { return Cells{2 * n + 2, 2 * n + 1, 1}; }

/// Those of random_segments, which affine maps and copies leave as they are.
std::optional<Cells> random_cells(Size n) {
  for (const Known& k : known()) {
    if (std::string_view(k.name).starts_with("R1_") && k.segments == n) {
      return Cells{k.vertices, k.edges, k.faces};
    }
  }
  return std::nullopt;
}

std::optional<Cells> with_a_wall(Size n) {
  std::optional<Cells> cells = random_cells(n);
  if (cells) *cells = {cells->vertices + 2, cells->edges + 1, cells->faces};
  return cells;
}

}  // namespace

const std::vector<Hostile>& hostile() {
  constexpr Size k1e3 = 1000, k1e4 = 10'000, k1e5 = 100'000, k1e6 = 1'000'000;
  static const std::vector<Hostile> all{
      {"copies of one segment", one_segment, k1e5, k1e3, one_edge},
      {"copies of one segment", one_segment, k1e6, k1e4, one_edge},
      {"R1_1e3, 1,000 copies of each segment", copied_segments, k1e3, 10, random_cells},
      {"a plan of 5 x 5 rooms, 1,000 copies of each wall", copied_rooms, 5, 1, rooms_cells},
      {"a plan of 100 x 100 rooms, drawn twice", rooms_twice, 100, 5, rooms_cells},
      {"lines through one point", pencil, k1e4, 100, lines_through_a_point},
      {"R1 in a corner of 1e-6 of the extent", in_a_corner, k1e5, k1e3, with_a_wall},
      {"one huge segment, the others tiny", one_huge, k1e6, 100, one_more_than_disjoint},
      {"R1 squeezed by 1e6", squeezed, k1e5, k1e3, random_cells},
      {"R1 squeezed by 1e6, rounded to 1,000 rows", squeezed_and_rounded, k1e5, k1e3, unknown},
      {"nested collinear overlaps", nested_overlaps, k1e5, 100, chain},
      {"successive collinear overlaps", successive_overlaps, k1e5, 100, successive_chain},
      {"parallel diagonals", hatch, k1e4, 100, disjoint},
      {"parallel diagonals", hatch, k1e5, 1000, disjoint},
      {"concentric squares", concentric_squares, k1e4, 50, squares_cells},
      {"concentric triangles", concentric_triangles, k1e5, 50, triangles_cells},
      {"R1 and one segment at 1e30", one_far_away, k1e5, k1e3, with_a_wall},
      {"slanted parallels that begin ever lower", stairs_of_slants, k1e5, k1e3, disjoint},
      {"two bundles of parallels", two_bundles, k1e5, k1e3, two_bundles_cells},
      {"a comb", comb, k1e5, 100, comb_cells},
  };
  return all;
}

}  // namespace plumbline::inputs
