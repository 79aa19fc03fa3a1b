#include "complex/planarity.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "complex/validate.hpp"
#include "geometry/filtered_points.hpp"
#include "inputs/families.hpp"
#include "plumbline/arrange.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

bool has_sound_incidences(const ExactComplex& complex) {
  Violations violations;
  validate_incidences(complex, violations);
  return violations.empty();
}

/// What is found in the plane.
std::string in_the_plane(const ExactComplex& complex) {
  Violations violations;
  validate_plane(complex, violations);
  return to_text(violations.take());
}

/// The same without any sweep over the vertices.
std::string slowly_in_the_plane(const ExactComplex& complex) {
  Violations violations;
  validate_graph(complex, violations);
  validate_faces(complex, violations);
  if (!violations.has(Invariant::Derived)) validate_nesting(complex, std::nullopt, violations);
  return to_text(violations.take());
}

}  // namespace

TEST_CASE("orientation is decided exactly, also where doubles cannot tell") {
  // Points of one line, moved off it by less than a double shows.
  const Rational off(1, mpz_class(1) << 200);
  const PointList points{{Rational(1, 3), Rational(1, 7)},
                         {Rational(4, 3), Rational(8, 7)},
                         {Rational(7, 3), Rational(15, 7)},
                         {Rational(7, 3), Rational(15, 7) + off},
                         {Rational(7, 3), Rational(15, 7) - off},
                         {Rational(7, 3) + off, Rational(15, 7)},
                         {rational_from(std::numeric_limits<double>::max()) * 2, 0},
                         {rational_from(std::numeric_limits<double>::denorm_min()) / 2, 0},
                         {0, 0}};
  const FilteredPoints filtered(points);
  CHECK(filtered.orientation(0, 1, 2) == 0);
  CHECK(filtered.orientation(0, 1, 3) == 1);
  CHECK(filtered.orientation(0, 1, 4) == -1);
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (std::size_t q = 0; q < points.size(); ++q) {
      CHECK(filtered.is_before(p, q) == (points[p] < points[q]));
      for (std::size_t r = 0; r < points.size(); ++r) {
        CHECK(filtered.orientation(p, q, r) == orientation(points[p], points[q], points[r]));
      }
    }
  }
}

TEST_CASE("orientation of points a few roundings off a line is that of exact arithmetic") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  int in_doubt = 0;
  for (int round = 0; round < 2000; ++round) {
    const PointD a{unit(random), unit(random)}, b{unit(random), unit(random)};
    const double t = unit(random);
    const PointD c{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    const PointList points{exact(a), exact(b), exact(c)};
    const int expected = orientation(points[0], points[1], points[2]);
    CHECK(FilteredPoints(points).orientation(0, 1, 2) == expected);
    in_doubt += expected == 0;
  }
  CHECK(in_doubt < 1000);  // most points lie off the line, if by little
}

TEST_CASE("the sweep certifies every arrangement") {
  for (const std::string& family : inputs::families()) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
      INFO(family << ' ' << seed);
      CHECK(is_certified(arrange(inputs::of_family(family, seed))));
    }
  }
}

TEST_CASE("the sweep refuses just what breaks an invariant in the plane") {
  std::mt19937 random(3);
  const auto below = [&](std::size_t n) { return random() % n; };
  std::size_t broken = 0, sound = 0;
  for (int round = 0; round < 3000; ++round) {
    const auto& families = inputs::families();
    ExactComplex c = arrange(inputs::of_family(families[round % families.size()],
                                               1000 + static_cast<unsigned>(round) / 50));
    if (c.vertices.size() < 2 || c.vertices.size() > 60 || c.edge_count() == 0) continue;
    const std::size_t v = below(c.vertices.size()), w = below(c.vertices.size());
    switch (round % 7) {
      case 0:  // a vertex elsewhere
        c.vertices.replace(v, {c.vertices[v].x, c.vertices[w].y});
        break;
      case 1: {  // a vertex a little elsewhere
        const Point p = c.vertices[v];
        c.vertices.replace(v, {p.x + (c.vertices[w].x - p.x) / 64, p.y});
        break;
      }
      case 2: {  // two vertices in each other's place
        const Point p = c.vertices[v], q = c.vertices[w];
        c.vertices.replace(v, q);
        c.vertices.replace(w, p);
        break;
      }
      case 3:  // all mirrored
        for (std::size_t i = 0; i < c.vertices.size(); ++i) {
          c.vertices.replace(i, {-c.vertices[i].x, c.vertices[i].y});
        }
        break;
      case 4: {  // onto an edge
        const Edge e = c.edges[below(c.edge_count())];
        const Point &a = c.vertices[e.tail], &b = c.vertices[e.head];
        c.vertices.replace(v, {(a.x + b.x) / 2, (a.y + b.y) / 2});
        break;
      }
      case 5: {  // a hole and an isolated vertex in other faces
        Lists<CycleId> holes;
        Lists<VertexId> isolated;
        for (std::size_t f = 0; f < c.face_count(); ++f) {
          holes.push_back(c.face_holes[(f + 1) % c.face_count()]);
          isolated.push_back(c.face_isolated_vertices[(f + 1) % c.face_count()]);
        }
        c.face_holes = holes;
        c.face_isolated_vertices = isolated;
        break;
      }
      default:  // another outer boundary
        if (c.face_count() > 2) {
          std::vector<std::vector<CycleId>> holes;
          for (std::size_t f = 0; f < c.face_count(); ++f) {
            holes.emplace_back(c.face_holes[f].begin(), c.face_holes[f].end());
          }
          const std::size_t f = 1 + below(c.face_count() - 1);
          for (auto& list : holes) {
            if (!list.empty()) {
              std::swap(list.front(), c.face_outer[f]);
              break;
            }
          }
          c.face_holes = Lists<CycleId>();
          for (const auto& list : holes) c.face_holes.push_back(list);
        }
    }
    c = canonical(c);
    if (!has_sound_incidences(c)) continue;
    const std::string found = slowly_in_the_plane(c);
    INFO(round << '\n' << found);
    CHECK(is_certified(c) == found.empty());
    CHECK(in_the_plane(c) == found);
    ++(found.empty() ? sound : broken);
  }
  CHECK(broken > 500);
  CHECK(sound > 100);
}

TEST_CASE("an outer boundary that two faces share is no certified complex") {
  ExactComplex c = arrange(segments(rectangle(0, 0, 1, 1) + rectangle(2, 0, 3, 1)));
  c.face_outer[2] = c.face_outer[1];
  CHECK_FALSE(validate(canonical(c)).empty());
}
