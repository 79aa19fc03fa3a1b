#include "plumbline/ladder.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <sstream>

#include "plumbline/arrange.hpp"
#include "plumbline/structure.hpp"
#include "support/affine_image.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

/// "4 4 2; 1: 1 0 1": V, E and F at radius 0, then squared radii with V, E and F from there on.
std::string text(const ToleranceLadder& ladder) {
  std::ostringstream text;
  text << ladder.vertices << ' ' << ladder.edges << ' ' << ladder.faces;
  for (const LadderStep& s : ladder.steps) {
    text << "; " << exact_text(s.squared_radius) << ": " << s.vertices << ' ' << s.edges << ' '
         << s.faces;
  }
  if (!ladder.is_complete) text << "; ...";
  return text.str();
}

std::string ladder_of(const std::string& drawing) {
  return text(tolerance_ladder(arrange(segments(drawing))));
}

/// The definition, taken literally: everything anew for every radius, in O(n^3).
class Definition {
 public:
  explicit Definition(const ExactComplex& complex) : c_(complex), n_(complex.vertices.size()) {}

  ToleranceLadder ladder() const {
    std::set<Rational> radii;
    for (std::size_t v = 0; v < n_; ++v) {
      for (std::size_t w = 0; w < v; ++w) radii.insert(between(v, w));
      for (const Edge& e : c_.edges) {
        if (passes(e, v)) radii.insert(from(e, v));
      }
    }
    ToleranceLadder ladder;
    std::tie(ladder.vertices, ladder.edges, ladder.faces) = counts(0);
    auto last = counts(0);
    for (const Rational& radius : radii) {
      const auto now = counts(radius);
      if (now == last && !ladder.steps.empty()) continue;
      last = now;
      LadderStep step;
      step.squared_radius = radius;
      std::tie(step.vertices, step.edges, step.faces) = now;
      ladder.steps.push_back(step);
    }
    return ladder;
  }

 private:
  Rational between(std::size_t v, std::size_t w) const {
    return squared_distance(c_.vertices[v], c_.vertices[w]);
  }
  Rational from(const Edge& e, std::size_t v) const {
    return squared_distance(c_.vertices[v], c_.vertices[e.tail], c_.vertices[e.head]);
  }
  bool passes(const Edge& e, std::size_t v) const {
    const Rational length = between(e.tail, e.head);
    return v != e.tail && v != e.head && between(v, e.tail) < length && between(v, e.head) < length;
  }

  /// The least vertex that each is one with, by spreading from neighbour to neighbour.
  std::vector<std::size_t> clusters(const Rational& squared_radius) const {
    std::vector<std::size_t> cluster(n_, n_);
    for (std::size_t first = 0; first < n_; ++first) {
      std::vector<std::size_t> reached;
      if (cluster[first] == n_) reached.push_back(cluster[first] = first);
      while (!reached.empty()) {
        const std::size_t v = reached.back();
        reached.pop_back();
        for (std::size_t w = 0; w < n_; ++w) {
          if (cluster[w] == n_ && between(v, w) <= squared_radius) {
            cluster[w] = first;
            reached.push_back(w);
          }
        }
      }
    }
    return cluster;
  }

  std::tuple<std::size_t, std::size_t, std::size_t> counts(const Rational& squared_radius) const {
    const auto cluster = clusters(squared_radius);
    std::set<std::set<std::size_t>> edges;
    for (const Edge& e : c_.edges) {
      // Feet as parameters from 0 to 1.
      std::set<std::pair<Rational, std::size_t>> way{{0, e.tail}, {1, e.head}};
      const Point &a = c_.vertices[e.tail], &b = c_.vertices[e.head];
      for (std::size_t v = 0; v < n_; ++v) {
        if (!passes(e, v) || from(e, v) > squared_radius) continue;
        const Point& p = c_.vertices[v];
        way.emplace(
            ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / between(e.tail, e.head), v);
      }
      for (auto stop = way.begin(); std::next(stop) != way.end(); ++stop) {
        edges.insert({cluster[stop->second], cluster[std::next(stop)->second]});
      }
    }
    std::erase_if(edges, [](const auto& ends) { return ends.size() == 1; });
    const std::set<std::size_t> vertices(cluster.begin(), cluster.end());
    std::set<std::size_t> unseen = vertices;
    std::size_t components = 0;
    while (!unseen.empty()) {
      ++components;
      std::vector<std::size_t> reached{*unseen.begin()};
      unseen.erase(unseen.begin());
      while (!reached.empty()) {
        const std::size_t v = reached.back();
        reached.pop_back();
        for (const auto& ends : edges) {
          if (ends.count(v) != 0) {
            for (const std::size_t w : ends) {
              if (unseen.erase(w) != 0) reached.push_back(w);
            }
          }
        }
      }
    }
    return {vertices.size(), edges.size(), 1 + components + edges.size() - vertices.size()};
  }

  const ExactComplex& c_;
  std::size_t n_;
};

/// Segments between points of a small lattice, or of a fine one.
SegmentSet random_drawing(std::mt19937& random) {
  const int size = std::uniform_int_distribution(0, 1)(random) == 0 ? 6 : 1000;
  std::uniform_int_distribution<int> coordinate(0, size), count(1, 7);
  SegmentSet set;
  const SourceId source = set.add_source({0, 1, 1, "random", "", ""});
  const auto point = [&] {
    const int x = coordinate(random), y = coordinate(random);
    return Point{x, y};
  };
  for (int i = count(random); i > 0; --i) {
    const Point a = point(), b = point();
    if (a != b) set.add({a, b}, source);
  }
  if (count(random) > 5) set.add_point(point(), source);
  return set;
}

}  // namespace

TEST_CASE("a square becomes a point at the length of its sides") {
  CHECK(ladder_of(rectangle(0, 0, 3, 3)) == "4 4 2; 9: 1 0 1");
}

TEST_CASE("a grid of equal squares becomes a point all at once") {
  std::ostringstream grid;
  for (int i = 0; i <= 30; ++i) grid << i << " 0 " << i << " 30  0 " << i << " 30 " << i << "  ";
  CHECK(ladder_of(grid.str()) == "961 1860 901; 1: 1 0 1");
}

TEST_CASE("a rectangle becomes an edge, then a point") {
  CHECK(ladder_of(rectangle(0, 0, 3, 2)) == "4 4 2; 4: 2 1 1; 9: 1 0 1");
}

TEST_CASE("nearness is transitive: a chain of walls 0.0009 apart becomes one wall at once") {
  std::ostringstream walls;
  for (int i = 0; i < 12; ++i) walls << i * 9 << "/10000 0 " << i * 9 << "/10000 1  ";
  CHECK(ladder_of(walls.str()) == "24 12 1; 0.00000081: 2 1 1; 1: 1 0 1");
}

TEST_CASE("an edge is led through a vertex that it passes: a gap closes, a room arises") {
  // A room of side 10 whose upper wall ends 1 short of, and its right wall 2 below the corner.
  CHECK(ladder_of("0 0 10 0  0 0 0 10  0 10 9 10  10 0 10 12") ==
        "5 4 1; 1: 5 5 2; 5: 4 4 2; 81: 3 3 2; 100: 1 0 1");
}

TEST_CASE("an edge is not led through a vertex that is no nearer to its ends than these are") {
  // The equilateral triangle's height is less than its side, but no side becomes shorter.
  CHECK(ladder_of("0 0 4 0  2 3 2 100") == "4 2 1; 9: 4 3 1; 13: 2 1 1; 9409: 1 0 1");
  CHECK(ladder_of("0 0 4 0  2 4 2 100") == "4 2 1; 16: 3 1 1; 20: 2 1 1; 9216: 1 0 1");
}

TEST_CASE("the first step is the first change, even if no number changes") {
  // Two edges from one point: one is led through the end of the other, which leaves two edges.
  CHECK(ladder_of("0 0 8 0  0 0 4 1") == "3 2 1; 1: 3 2 1; 17: 1 0 1");
}

TEST_CASE("components join where they come together") {
  CHECK(ladder_of("0 0 0 10  3 0 3 10") == "4 2 1; 9: 2 1 1; 100: 1 0 1");
  CHECK(ladder_of("0 0 0 10  + 3 5") == "3 1 1; 9: 3 2 1; 34: 1 0 1");
}

TEST_CASE("each step names what is that near") {
  const ExactComplex c = arrange(segments("0 0 10 0  5 1/3 5 3  9 2 9 7/4"));
  const ToleranceLadder ladder = tolerance_ladder(c);
  REQUIRE(ladder.steps.size() >= 2);
  const LadderStep &first = ladder.steps[0], &second = ladder.steps[1];
  CHECK(first.squared_radius == Rational(1, 16));
  CHECK(c.vertices[first.vertex] == Point{9, Rational(7, 4)});
  CHECK(c.vertices[first.other_vertex] == Point{9, 2});
  CHECK_FALSE(first.edge.valid());
  CHECK(second.squared_radius == Rational(1, 9));
  CHECK(c.vertices[second.vertex] == Point{5, Rational(1, 3)});
  CHECK(c.vertices[c.edges[second.edge].head] == Point{10, 0});
  CHECK_FALSE(second.other_vertex.valid());
}

TEST_CASE("a drawing of at most one vertex has no steps") {
  CHECK(ladder_of("") == "0 0 1");
  CHECK(ladder_of("+ 3 5") == "1 0 1");
}

TEST_CASE("a ladder ends where it is told to") {
  const ExactComplex c = arrange(segments(rectangle(0, 0, 3, 2) + rectangle(100, 0, 107, 5)));
  CHECK(text(tolerance_ladder(c)) ==
        "8 8 3; 4: 6 5 2; 9: 5 4 2; 25: 3 1 1; 49: 2 0 1; 9409: 1 0 1");
  CHECK(text(tolerance_ladder(c, {2, {}})) == "8 8 3; 4: 6 5 2; 9: 5 4 2; ...");
  CHECK(text(tolerance_ladder(c, {5, {}})) == text(tolerance_ladder(c)));
  CHECK(text(tolerance_ladder(c, {1000, 3})) == "8 8 3; 4: 6 5 2; 9: 5 4 2; ...");
  CHECK(text(tolerance_ladder(c, {1000, 2.99})) == "8 8 3; 4: 6 5 2; ...");
  CHECK(text(tolerance_ladder(c, {1000, 1e9})) == text(tolerance_ladder(c)));
  CHECK(text(tolerance_ladder(c, {1000, 0})) == "8 8 3; ...");
  CHECK_THROWS_AS(tolerance_ladder(c, {1000, -1}), Error);
}

TEST_CASE("the ladder is its definition, taken literally") {
  std::mt19937 random(7);
  for (int i = 0; i < 150; ++i) {
    const ExactComplex c = arrange(random_drawing(random));
    INFO("drawing " << i);
    CHECK(text(tolerance_ladder(c, {1'000'000, {}})) == text(Definition(c).ladder()));
  }
}

TEST_CASE("windows of pairs do not change the ladder") {
  // More pairs than a window holds, and most of them tied.
  std::ostringstream grid;
  for (int i = 0; i <= 12; ++i) {
    grid << 3 * i << " 0 " << 3 * i << " 24  0 " << 2 * i << " 36 " << 2 * i << "  ";
  }
  CHECK(ladder_of(grid.str()) == "169 312 145; 4: 13 12 1; 9: 1 0 1");
}

TEST_CASE("pairs that do nothing when they are passed count once they matter") {
  // A bundle whose ends merge at once, and places beside it between the feet of its ends.
  std::ostringstream drawing;
  drawing << "20 -30 20 -32  215 50 216 52";
  for (int i = 0; i < 12; ++i) {
    drawing << "  " << 3 * i << ' ' << i << "  " << 3 * i + 200 << ' ' << i;
  }
  const ExactComplex c = arrange(segments(drawing.str()));
  CHECK(text(tolerance_ladder(c)) == text(Definition(c).ladder()));
}

TEST_CASE("nested squares fall together in three steps, in no time for each pair of them") {
  constexpr int kSquares = 1000;
  std::string squares;
  for (int i = 1; i <= kSquares; ++i)
    squares += rectangle(-5000 - i, -5000 - i, 5000 + i, 5000 + i);
  CHECK(ladder_of(squares) == "4000 4000 1001; 1: 4000 7992 3994; 2: 4 4 2; 100040004: 1 0 1");
}

TEST_CASE("similar drawings have similar ladders, in any order of their segments") {
  std::mt19937 random(11);
  for (int i = 0; i < 40; ++i) {
    SegmentSet set = random_drawing(random);
    const ExactComplex c = arrange(set);
    const ToleranceLadder ladder = tolerance_ladder(c);
    set.segments = shuffled(reversed(set.segments), random);
    CHECK(text(tolerance_ladder(arrange(set))) == text(ladder));
    // Moved far away and scaled by 1/3; the order of feet stays.
    ToleranceLadder scaled = tolerance_ladder(
        affine_image(c, compose(translation(Rational("123456789123456789"), Rational(-7)),
                                scaling(Rational(1, 3), Rational(1, 3)))));
    for (LadderStep& step : scaled.steps) step.squared_radius *= 9;
    CHECK(text(scaled) == text(ladder));
  }
}
