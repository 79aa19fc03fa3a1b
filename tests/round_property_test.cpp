// The guarantees of rounding, on random inputs, each checked by means of its own: definitions in
// exact numbers, all pairs of edges and pixels.

#include <catch2/catch.hpp>

#include <random>
#include <set>

#include "inputs/families.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/round.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

const std::vector<Grid> kGrids{{}, {0}, {1}, {3}, {9}};

Rational power(int base, int exponent) {
  mpz_class result;
  mpz_ui_pow_ui(result.get_mpz_t(), static_cast<unsigned long>(base),
                static_cast<unsigned long>(exponent));
  return result;
}

bool is_on(const Grid& grid, const Rational& value) {
  if (grid.decimals) return Rational(value * power(10, *grid.decimals)).get_den() == 1;
  return Rational(value.get_d()) == value;
}

Point nearest_point(const Point& p, const Rational& spacing) {
  const auto rounded = [&](const Rational& value) {
    const Rational shifted = value / spacing + Rational(1, 2);
    mpz_class floor;
    mpz_fdiv_q(floor.get_mpz_t(), shifted.get_num_mpz_t(), shifted.get_den_mpz_t());
    return Rational(floor * spacing);
  };
  return {rounded(p.x), rounded(p.y)};
}

/// Whether the segment meets the closed box, by separating lines: sides of the box, then the
/// segment's own line.
bool meets_box(const Point& a, const Point& b, const Point& low, const Point& high) {
  if (std::max(a.x, b.x) < low.x || high.x < std::min(a.x, b.x)) return false;
  if (std::max(a.y, b.y) < low.y || high.y < std::min(a.y, b.y)) return false;
  std::set<int> sides;
  for (const Rational& x : {low.x, high.x}) {
    for (const Rational& y : {low.y, high.y}) sides.insert(orientation(a, b, {x, y}));
  }
  return sides != std::set{1} && sides != std::set{-1};
}

/// Whether it meets the half-open pixel around the centre: its upper sides less than nothing away.
bool meets_pixel(const Point& a, const Point& b, const Point& centre, const Rational& spacing) {
  static const Rational kNothing = 1 / power(2, 4000);
  const Rational half = spacing / 2, less = half - spacing * kNothing;
  return meets_box(a, b, {centre.x - half, centre.y - half}, {centre.x + less, centre.y + less});
}

std::set<std::pair<Point, Point>> edges(const ExactComplex& c) {
  std::set<std::pair<Point, Point>> result;
  for (const auto& [tail, head] : c.edges) result.insert({c.vertices[tail], c.vertices[head]});
  return result;
}

/// The edges of the snap rounded complex, by its definition.
std::set<std::pair<Point, Point>> snapped_edges(const ExactComplex& c, const Rational& spacing) {
  std::set<Point> centres;
  for (const Point& p : c.vertices) centres.insert(nearest_point(p, spacing));
  std::set<std::pair<Point, Point>> result;
  for (const auto& [tail, head] : c.edges) {
    const Point &a = c.vertices[tail], &b = c.vertices[head];
    std::vector<Point> met;
    for (const Point& centre : centres) {
      if (meets_pixel(a, b, centre, spacing)) met.push_back(centre);
    }
    const auto along = [&](const Point& p) {
      return Rational((b.x - a.x) * p.x + (b.y - a.y) * p.y);
    };
    std::sort(met.begin(), met.end(),
              [&](const Point& p, const Point& q) { return along(p) < along(q); });
    for (std::size_t i = 1; i < met.size(); ++i) result.insert(std::minmax(met[i - 1], met[i]));
  }
  return result;
}

/// Per vertex where simple rounding takes it.
std::vector<Point> nearest_points(const ExactComplex& c, const Grid& grid,
                                  const Rational& spacing) {
  std::vector<Point> result;
  for (const Point& p : c.vertices) {
    result.push_back(grid.decimals ? nearest_point(p, spacing) : exact(nearest(p)));
  }
  return result;
}

/// The complex with its vertices at these places, its incidences as they are.
ExactComplex moved(ExactComplex c, const std::vector<Point>& places) {
  for (std::size_t v = 0; v < c.vertices.size(); ++v) c.vertices.replace(v, places[v]);
  return canonical(std::move(c));
}

/// Whether a vertex that is above or below an edge is on its other side at these places. All pairs.
bool goes_past(const ExactComplex& c, const std::vector<Point>& places) {
  std::vector<Point> points(c.vertices.begin(), c.vertices.end());
  for (const auto& [a, b] : c.edges) {
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (points[v].x < points[a].x || points[b].x < points[v].x) continue;
      if (orientation(points[a], points[b], points[v]) *
              orientation(places[a], places[b], places[v]) <
          0) {
        return true;
      }
    }
  }
  return false;
}

Rational sup_distance(const Point& p, const Point& q) {
  const Rational x = abs(p.x - q.x), y = abs(p.y - q.y);
  return std::max(x, y);
}

void check_movement(const ExactComplex& c, const Rounding& r) {
  const Rational half = r.spacing / 2;
  for (std::size_t v = 0; v < c.vertices.size(); ++v) {
    REQUIRE(sup_distance(c.vertices[v], r.complex.vertices[r.vertex_image[v]]) <= half);
  }
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    const auto [tail, head] = c.edges[e];
    VertexId at = r.vertex_image[tail];
    for (const HalfedgeId h : r.edge_image[e]) {
      REQUIRE(r.complex.origin(h) == at);
      at = r.complex.target(h);
      const Point& p = r.complex.vertices[at];
      REQUIRE(meets_box(c.vertices[tail], c.vertices[head], {p.x - half, p.y - half},
                        {p.x + half, p.y + half}));
    }
    REQUIRE(at == r.vertex_image[head]);
  }
}

/// A point that no edge has moved across still lies in the face that it lay in.
std::size_t check_faces(const ExactComplex& c, const Rounding& r) {
  const Rational squared_reach = r.spacing * r.spacing / 2;
  std::size_t checked = 0;
  for (std::size_t f = 1; f < r.complex.face_count(); ++f) {
    const Point p = interior_point(r.complex, FaceId(f));
    bool is_clear = true;
    for (const auto& [tail, head] : c.edges) {
      is_clear =
          is_clear && squared_distance(p, c.vertices[tail], c.vertices[head]) > squared_reach;
    }
    if (!is_clear) continue;
    ++checked;
    REQUIRE(locate(c, p) == r.face_origin[f]);
  }
  return checked;
}

/// Whether all pairs of its cells are too many for a test.
bool is_large(const ExactComplex& c) { return c.vertices.size() * c.edge_count() > 20'000; }

/// Checks that simple rounding is taken just where it will do, and snapped edges by definition.
/// Whether simple rounding is no more wrong than that a vertex goes past an edge.
bool check_method(const ExactComplex& c, const Grid& grid) {
  const Rounding r = safely_rounded(c, grid);
  const std::vector<Point> places = nearest_points(c, grid, r.spacing);
  const ExactComplex simple = moved(c, places);
  const bool is_valid = validate(simple).empty(), is_past = goes_past(c, places);
  if (is_valid && !is_past) {
    REQUIRE(r.has_same_incidences());
    REQUIRE(r.complex == simple);
  } else if (grid.decimals) {
    REQUIRE(!r.has_same_incidences());
  }
  if (!r.has_same_incidences()) REQUIRE(edges(r.complex) == snapped_edges(c, r.spacing));
  return is_valid && is_past;
}

ExactComplex without_sources(ExactComplex c) {
  Lists<SegmentId> none;
  for (std::size_t e = 0; e < c.edge_count(); ++e) none.push_back(std::vector<SegmentId>());
  c.edge_sources = none;
  return c;
}

}  // namespace

TEST_CASE("rounding keeps its guarantees on every family of random segments") {
  const std::string family = GENERATE(from_range(inputs::families()));
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const ExactComplex c = arrange(inputs::of_family(family, seed));
    for (const Grid& grid : kGrids) {
      CAPTURE(family, seed, to_text(grid));
      const Rounding r = safely_rounded(c, grid);
      REQUIRE(to_text(validate(r.complex)) == "");
      for (const Point& p : r.complex.vertices) REQUIRE((is_on(grid, p.x) && is_on(grid, p.y)));
      check_movement(c, r);
      const Rounding again = safely_rounded(r.complex, grid);
      REQUIRE(again.has_same_incidences());
      REQUIRE(again.complex == r.complex);
    }
  }
}

TEST_CASE("snap rounding leads edges through the hot pixels that they meet, where needed") {
  const std::string family = GENERATE(from_range(inputs::families()));
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const ExactComplex c = arrange(inputs::of_family(family, seed));
    if (is_large(c)) continue;
    for (const Grid& grid : kGrids) {
      CAPTURE(family, seed, to_text(grid));
      check_method(c, grid);
    }
  }
}

TEST_CASE("loose pieces near lines are snapped just where they would go past one") {
  std::mt19937 random(5);
  const auto decimal = [&](int from, int to) {
    return Rational(static_cast<int>(random() % static_cast<unsigned>(to - from)) + from, 100);
  };
  std::size_t past = 0;
  for (unsigned trial = 0; trial < 400; ++trial) {
    SegmentSet set;
    const SourceId source = set.add_source({});
    const Rational slope = decimal(-100, 100);
    const auto add = [&](const Rational& from, const Rational& to, const Rational& above) {
      set.add({{from, slope * from + above}, {to, slope * to + above}}, source);
    };
    add(0, 20, 0);
    for (const int at : {1, 8, 14}) {
      const Rational from = at + decimal(0, 100);
      add(from, from + decimal(10, 400), decimal(-30, 30));
    }
    const ExactComplex c = arrange(set);
    CAPTURE(trial);
    past += check_method(c, {0}) ? 1 : 0;
  }
  CHECK(past > 10);
}

TEST_CASE("a point that no edge moves across lies in the face that it lay in") {
  std::size_t checked_faces = 0;
  for (const std::string& family : inputs::families()) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
      const ExactComplex c = arrange(inputs::of_family(family, seed));
      if (is_large(c)) continue;
      for (const Grid& grid : kGrids) {
        CAPTURE(family, seed, to_text(grid));
        const Rounding r = safely_rounded(c, grid);
        if (!r.has_same_incidences()) checked_faces += check_faces(c, r);
      }
    }
  }
  CHECK(checked_faces > 1000);
}

TEST_CASE("rounding does not depend on order and direction of the input, or on threads") {
  const std::string family = GENERATE(from_range(inputs::families()));
  std::mt19937 random(7);
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const SegmentSet input = inputs::of_family(family, seed);
    SegmentSet other = input;
    other.segments = shuffled(reversed(input.segments), random);
    const ExactComplex c = arrange(input), d = arrange(other);
    for (const Grid& grid : kGrids) {
      CAPTURE(family, seed, to_text(grid));
      const Rounding r = safely_rounded(c, grid, {1, {}}), s = safely_rounded(d, grid, {3, {}});
      CHECK(without_sources(r.complex) == without_sources(s.complex));
      CHECK(r.vertex_image == s.vertex_image);
      CHECK(r.edge_image == s.edge_image);
      CHECK(r.face_origin == s.face_origin);
      CHECK(r.method == s.method);
    }
  }
}

TEST_CASE("the random families need more than simple rounding") {
  std::size_t invalid_decimals = 0, invalid_doubles = 0, snapped_doubles = 0;
  for (const std::string& family : inputs::families()) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
      const ExactComplex c = arrange(inputs::of_family(family, seed));
      for (const Grid& grid : kGrids) {
        const Rounding r = safely_rounded(c, grid);
        if (grid.decimals) {
          invalid_decimals += r.has_same_incidences() ? 0 : 1;
        } else {
          invalid_doubles += r.method == RoundingMethod::NearestDoubles ? 0 : 1;
          snapped_doubles += r.has_same_incidences() ? 0 : 1;
        }
      }
    }
  }
  CHECK(invalid_decimals > 400);
  CHECK(invalid_doubles > 20);
  CHECK(snapped_doubles > 20);
}
