#include "plumbline/compare.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "plumbline/arrange.hpp"
#include "plumbline/error.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

ExactComplex drawn(const std::string& text) { return arrange(segments(text)); }

std::string list(const char* side, const std::vector<std::size_t>& cells) {
  std::string text;
  for (const std::size_t cell : cells) text += ' ' + std::to_string(cell);
  return text.empty() ? text : std::string(" ") + side + text;
}

/// One finding a line: kind, disagreement, cells on both sides.
std::string findings(const Comparison& result) {
  std::string text;
  for (const Finding& f : result.findings) {
    text += to_text(f.kind) + ' ' + to_text(f.disagreement) + list("exact", f.exact_cells) +
            list("float", f.float_cells) + '\n';
  }
  return text;
}

std::string findings(const std::string& exact_drawing, const std::string& float_drawing,
                     double tolerance) {
  return findings(compare(drawn(exact_drawing), nearest(drawn(float_drawing)), tolerance));
}

/// A copy whose face `to` has the hole or isolated vertex of face `from` as well; `from` loses it.
template <class T>
Lists<T> moved(const Lists<T>& lists, T item, FaceId from, FaceId to) {
  Lists<T> result;
  for (std::size_t f = 0; f < lists.size(); ++f) {
    std::vector<T> list(lists[f].begin(), lists[f].end());
    if (f == from) std::erase(list, item);
    if (f == to) list.push_back(item);
    result.push_back(list);
  }
  return result;
}

/// Two drawings in which every vertex, edge and face differs in a known way.
struct Pair {
  const char* name;
  std::string exact_drawing, float_drawing;
};
const std::string kTriangle = "0 0 1 0  1 0 0 1  0 1 0 0  ";
const std::string kRoom = rectangle(0, 0, 9, 9);

}  // namespace

TEST_CASE("a complex agrees with its own nearest doubles") {
  const ExactComplex plan = drawn(kRoom + rectangle(2, 2, 5, 5) + "1/3 0 1/7 9  7 1 7 8  + 3 3");
  const Comparison result = compare(plan, nearest(plan), 0x1p-50);
  CHECK(findings(result) == "");
  CHECK(result.agree());
  CHECK(result.float_valid);
  CHECK(result.exact_counts == result.float_counts);
  CHECK(result.matched_vertices == plan.vertices.size());
  CHECK(result.matched_edges == plan.edge_count());
  CHECK(result.matched_faces == plan.face_count());
  // 1/3 is not a double; the nearest one is 1/3 - 2^-54/3.
  CHECK(result.largest_displacement == Approx(0x1p-54 / 3));
}

TEST_CASE("empty drawings agree; all of a drawing is missing from an empty result") {
  CHECK(findings("", "", 0) == "");
  CHECK(findings(kTriangle, "", 1) ==
        "vertex missing exact 0\nvertex missing exact 1\nvertex missing exact 2\n"
        "edge missing exact 0\nedge missing exact 1\nedge missing exact 2\n"
        "face missing exact 1\n");
}

TEST_CASE("counts are those of the cells; holes are those of bounded faces") {
  const ExactComplex plan = drawn(kRoom + rectangle(2, 2, 5, 5) + "7 1 7 8  + 3 3");
  const Counts expected{11, 9, 3, 2, 1, 4, 1, 2};
  CHECK(counts(plan, plan.vertices.size()) == expected);
}

TEST_CASE("a vertex moved by just the tolerance matches, beyond it it is moved") {
  const auto moved_to = [](double x) {
    FloatComplex result = nearest(drawn(kTriangle));
    result.vertices[2].x = x;
    return result;
  };
  const ExactComplex triangle = drawn(kTriangle);
  const Comparison inside = compare(triangle, moved_to(1.25), 0.25);
  CHECK(findings(inside) == "");
  CHECK(inside.largest_displacement == 0.25);
  const Comparison outside = compare(triangle, moved_to(1.25 + 0x1p-52), 0.25);
  CHECK(findings(outside) == "vertex moved exact 2 float 2\n");
  CHECK(outside.findings[0].distance == 0.25 + 0x1p-52);
  const Rational by = Rational(1, 4) + Rational(1, mpz_class(1) << 52);
  CHECK(outside.findings[0].squared_distance == Rational(by * by));
  CHECK(to_text(outside.findings[0].where) == "1 0");
  CHECK(outside.matched_vertices == 2);
  CHECK(outside.largest_displacement == 0);
  CHECK(outside.matched_edges == 3);
  CHECK(outside.matched_faces == 2);
}

TEST_CASE("a vertex that leads elsewhere has not moved: it is missing, the other one extra") {
  // Of the same neighbours, but along other segments; of other neighbours.
  const Comparison antenna =
      compare(drawn("0 0 4 0  4 0 4 3"), nearest(drawn("0 0 4 0  0 0 0 4")), 0.1);
  CHECK(findings(antenna) ==
        "vertex missing exact 2\nvertex extra float 1\nedge missing exact 1\nedge extra float 0\n");
  CHECK(antenna.findings[2].message ==
        "an exact edge is missing from the float result, because of finding 1");
  FloatComplex other = nearest(drawn("0 0 4 0  4 0 4 3"));
  other.vertices[2] = {6, 3};
  other.edge_sources = {};
  for (const std::size_t source : {0, 7}) {
    other.edge_sources.push_back(std::vector{SegmentId(source)});
  }
  CHECK(findings(compare(drawn("0 0 4 0  4 0 4 3"), other, 0.1)) ==
        "vertex missing exact 2\nvertex extra float 2\nedge missing exact 1\nedge extra float 1\n");
}

TEST_CASE("a drawing that was shifted as a whole has all its vertices moved") {
  const ExactComplex plan = drawn(kRoom + rectangle(2, 2, 5, 5) + "+ 3 3");
  FloatComplex shifted = nearest(plan);
  for (PointD& p : shifted.vertices) p.x += 0.5;
  const Comparison result = compare(plan, shifted, 0.1);
  REQUIRE(result.findings.size() == plan.vertices.size());
  for (const Finding& f : result.findings) {
    CHECK(f.disagreement == Disagreement::Moved);
    CHECK(f.squared_distance == Rational(1, 4));
  }
  CHECK(result.matched_vertices == 0);
  CHECK(result.matched_faces == plan.face_count());
}

TEST_CASE("two vertices that became one are merged, and the edge between them is collapsed") {
  const Comparison result = compare(drawn("0 0 4 0  4 0 4 0.01  4 0.01 0 4  0 4 0 0"),
                                    nearest(drawn("0 0 4 0  4 0 0 4  0 4 0 0")), 0.1);
  CHECK(findings(result) ==
        "vertex merged exact 2 3 float 2\nedge merged exact 3\nface reshaped exact 1 float 1\n");
  CHECK(result.findings[0].message == "two exact vertices 0.01 apart became one float vertex");
  CHECK(to_text(result.findings[0].where) == "4 0");
  CHECK(result.findings[0].distance == Approx(0.01));
  CHECK(result.findings[0].segments == std::vector{SegmentId(0), SegmentId(1), SegmentId(2)});
  CHECK(result.findings[2].message ==
        "a face has other edges on its outer boundary, because of finding 2");
}

TEST_CASE("a lost wall merges two rooms") {
  const Comparison result =
      compare(drawn(rectangle(0, 0, 4, 2) + "2 0 2 2"),
              nearest(drawn("0 0 2 0  2 0 4 0  4 0 4 2  4 2 2 2  2 2 0 2  0 2 0 0")), 0.1);
  CHECK(findings(result) == "edge missing exact 3\nface merged exact 1 2 float 1\n");
  CHECK(to_text(result.findings[0].where) == "2 1");
  CHECK(result.findings[0].segments == std::vector{SegmentId(4)});
}

TEST_CASE("a vertex too many on a side splits an edge and reshapes its face") {
  CHECK(findings(rectangle(0, 0, 4, 2), "0 0 2 0  2 0 4 0  4 0 4 2  4 2 0 2  0 2 0 0", 0.1) ==
        "vertex extra float 2\nedge split exact 1 float 1 3\nface reshaped exact 1 float 1\n");
}

TEST_CASE("a room without its pillar lacks vertices, edges, a face and a hole") {
  CHECK(findings(kRoom + rectangle(2, 2, 4, 4), kRoom, 0.1) ==
        "vertex missing exact 2\nvertex missing exact 3\n"
        "vertex missing exact 4\nvertex missing exact 5\n"
        "edge missing exact 3\nedge missing exact 4\nedge missing exact 5\nedge missing exact 6\n"
        "face missing exact 2\nhole missing exact 2\n");
}

TEST_CASE("thin faces along a collapsed double wall are missing, their neighbour is reshaped") {
  CHECK(findings(kRoom + "0 0 9 0.01  0 0.01 9 0.01", kRoom, 0.1) ==
        "vertex merged exact 0 1 float 0\nvertex merged exact 3 4 float 2\n"
        "edge merged exact 0\nedge merged exact 6\nedge merged exact 1 2 4 float 1\n"
        "face reshaped exact 3 float 1\nface missing exact 1\nface missing exact 2\n");
}

TEST_CASE("a chord swallowed by a chain within the tolerance is merged with it") {
  const std::string chain = "0 0 5 0.01  5 0.01 9 0  0 0 0 9  0 9 9 0  ";
  CHECK(findings(chain + "0 0 9 0", chain, 0.1) ==
        "edge merged exact 1 2 4 float 1 3\nface missing exact 2\n");
  // Its middle vertex is 0.01 from the chord: beyond the tolerance the chord is missing.
  CHECK(findings(chain + "0 0 9 0", chain, 0.009) ==
        "edge missing exact 2\nface missing exact 2\n");
}

TEST_CASE("a pillar that strays over a wall is a component in the wrong face") {
  const ExactComplex plan =
      drawn(rectangle(0, 0, 10, 10) + rectangle(2, 2, 4, 4) + "6 0 6 10  + 1 1");
  REQUIRE(summary(plan) == "V 11 E 11 F 4 C 3 holes 1 isolated 1 depth 2");
  const FaceId left = locate(plan, {1, 2}), right = locate(plan, {7, 1});
  FloatComplex broken = nearest(plan);
  broken.face_holes = moved(plan.face_holes, plan.face_holes[left][0], left, right);
  const Comparison hole_moved = compare(plan, canonical(broken), 0);
  CHECK(findings(hole_moved) == "vertex invalid float 3\nhole wrong parent exact 2 float 2\n");
  CHECK_FALSE(hole_moved.float_valid);

  broken = nearest(plan);
  broken.face_isolated_vertices =
      moved(plan.face_isolated_vertices, plan.face_isolated_vertices[left][0], left, right);
  CHECK(findings(compare(plan, canonical(broken), 0)) ==
        "vertex invalid float 2\nvertex wrong parent exact 2 float 2\n");
}

TEST_CASE("a missed crossing is invalid, a missing vertex and two pairs of merged edges") {
  const ExactComplex cross = drawn("0 0 2 2  0 2 2 0");
  FloatComplex missed = nearest(drawn("0 0 2 2  5 2 7 0"));  // the second edge lies apart ...
  REQUIRE(missed.vertices[2] == PointD{5, 2});
  missed.vertices[2].x = 0;  // ... and is moved onto the first, without a vertex where they cross
  missed.vertices[3].x = 2;
  CHECK(findings(compare(cross, canonical(missed), 0.1)) ==
        "edge invalid float 0 1\nvertex missing exact 2\n"
        "edge merged exact 0 3 float 0\nedge merged exact 1 2 float 1\n");
}

TEST_CASE("what is missing and merged one way round is extra and split the other way round") {
  const Pair pairs[] = {
      {"moved vertex", kTriangle, "0 0 2 0  2 0 0 1  0 1 0 0"},
      {"merged vertices", "0 0 4 0  4 0 4 1/64  4 1/64 0 4  0 4 0 0", "0 0 4 0  4 0 0 4  0 4 0 0"},
      {"double wall", kRoom + "0 0 9 1/64  0 1/64 9 1/64", kRoom},
      {"pillar", kRoom + rectangle(2, 2, 4, 4), kRoom},
      {"wall", kRoom + "0 0 9 9", kRoom},
      {"joined pillars", kRoom + rectangle(2, 2, 4, 4) + rectangle(5, 5, 6, 6) + "4 4 5 5",
       kRoom + rectangle(2, 2, 4, 4) + rectangle(5, 5, 6, 6)},
  };
  const auto mirrored = [](Disagreement d) {
    switch (d) {
      case Disagreement::Missing:
        return Disagreement::Extra;
      case Disagreement::Merged:
        return Disagreement::Split;
      default:
        return d;
    }
  };
  for (const Pair& pair : pairs) {
    INFO(pair.name);
    const ExactComplex a = drawn(pair.exact_drawing), b = drawn(pair.float_drawing);
    const auto forth = compare(a, nearest(b), 1. / 16).findings;
    const auto back = compare(b, nearest(a), 1. / 16).findings;
    std::vector<std::string> expected, got;
    for (const Finding& f : forth) {
      expected.push_back(to_text(f.kind) + ' ' + to_text(mirrored(f.disagreement)) +
                         list("exact", f.float_cells) + list("float", f.exact_cells));
    }
    for (const Finding& f : back) {
      got.push_back(to_text(f.kind) + ' ' + to_text(mirrored(mirrored(f.disagreement))) +
                    list("exact", f.exact_cells) + list("float", f.float_cells));
    }
    std::sort(expected.begin(), expected.end());
    std::sort(got.begin(), got.end());
    CHECK(!expected.empty());
    CHECK(got == expected);
  }
}

TEST_CASE("a hole that two holes became is merged") {
  const std::string pillars = rectangle(2, 2, 4, 4) + rectangle(5, 5, 6, 6);
  CHECK(findings(kRoom + pillars, kRoom + pillars + "4 4 5 5", 0.1) ==
        "edge extra float 7\nhole merged exact 2 4 float 2\n");
}

TEST_CASE("a closed gap makes a face, and the merged vertices are named as its cause") {
  const std::string open = "0 0 4 0  4 0 4 4  4 4 0 4  0 4 0 0.01";
  const Comparison result = compare(drawn(open), nearest(drawn(rectangle(0, 0, 4, 4))), 0.1);
  CHECK(findings(result) == "vertex merged exact 0 1 float 0\nface extra float 1\n");
  CHECK(result.findings[1].message ==
        "a float face has no exact counterpart; its place is in the unbounded exact face, because "
        "of finding 1");
}

TEST_CASE("a drawing and a part of it agree just if their complexes are equal") {
  std::mt19937 random(1);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  int agreements = 0;
  constexpr int kRounds = 300;
  for (int round = 0; round < kRounds; ++round) {
    std::string all, part;
    for (int i = 1 + below(9); i > 0; --i) {
      const int x = below(6), y = below(6), right = x + 1 + below(4), top = y + 1 + below(4);
      const std::string item = below(2) == 0
                                   ? rectangle(x, y, right, top)
                                   : std::to_string(x) + ' ' + std::to_string(top) + ' ' +
                                         std::to_string(right) + ' ' + std::to_string(y) + ' ';
      all += item;
      if (below(8) != 0) part += item;
    }
    INFO(all << "| " << part);
    const ExactComplex whole = drawn(all), other = drawn(part);
    const bool are_equal = signature(whole) == signature(other);
    agreements += are_equal;
    // Grid points and their crossings are further apart than this.
    CHECK(compare(whole, nearest(other), 1e-6).agree() == are_equal);
  }
  CHECK(agreements > kRounds / 10);
  CHECK(agreements < kRounds * 9 / 10);
}

TEST_CASE("whatever is done to a float complex, the comparison ends with findings") {
  std::mt19937 random(2);
  const auto below = [&](std::size_t n) { return random() % n; };
  const ExactComplex plan =
      drawn(kRoom + rectangle(2, 2, 5, 5) + rectangle(3, 3, 4, 4) + "5 5 9 9  0 7 2 8  + 8 1");
  for (int round = 0; round < 300; ++round) {
    FloatComplex broken = nearest(plan);
    switch (round % 5) {
      case 0:  // a vertex on another one
        broken.vertices[below(plan.vertices.size())] = {0, 0};
        break;
      case 1:  // an edge between other vertices
        broken.edges[below(plan.edge_count())].head = VertexId(below(plan.vertices.size()));
        break;
      case 2:  // a cycle with a gap
        broken.cycles = Lists<HalfedgeId>();
        for (std::size_t c = 0; c < plan.cycles.size(); ++c) {
          broken.cycles.push_back(plan.cycles[c].subspan(plan.cycles[c].size() > 1 ? below(2) : 0));
        }
        break;
      case 3:  // two faces with each other's outer boundary
        std::swap(broken.face_outer[1 + below(plan.face_count() - 1)],
                  broken.face_outer[1 + below(plan.face_count() - 1)]);
        break;
      default:  // no hole at all
        broken.face_holes = Lists<CycleId>();
        for (std::size_t f = 0; f < plan.face_count(); ++f) {
          broken.face_holes.push_back(std::vector<CycleId>());
        }
    }
    broken = canonical(broken);
    INFO("round " << round);
    CHECK(compare(plan, broken, 1e-6).agree() == (broken == nearest(plan)));
  }
}

TEST_CASE("a tolerance that is negative or not finite is bad input") {
  const ExactComplex triangle = drawn(kTriangle);
  for (const double tolerance :
       {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_AS(compare(triangle, nearest(triangle), tolerance), Error);
  }
}

TEST_CASE("many points are located as one by one") {
  const ExactComplex plan = drawn(kRoom + rectangle(2, 2, 5, 5) + "3 3 4 4  1/3 0 1/7 9  5 2 9 9");
  std::vector<Point> points;
  std::vector<FaceId> expected;
  for (int x = -1; x <= 40; ++x) {
    for (int y = -1; y <= 40; ++y) {
      const Point p{Rational(x, 4), Rational(y, 4)};
      const auto is_on_edge = [&](const Edge& e) {
        return on_segment(plan.vertices[e.tail], plan.vertices[e.head], p);
      };
      if (std::any_of(plan.edges.begin(), plan.edges.end(), is_on_edge)) continue;
      points.push_back(p);
      expected.push_back(locate(plan, p));
    }
  }
  CHECK(points.size() > 1000);
  CHECK(plumbline::locate_all(plan, points) == expected);
}

TEST_CASE("of vertices that are one in doubles, the exactly nearest one is what a vertex repeats") {
  std::string points;
  for (int i = 10; i < 34; ++i) points += "+ 1 1.000000000000000000" + std::to_string(i) + "  ";
  const ExactComplex right = drawn(points);
  for (std::size_t v = 0; v < right.vertices.size(); ++v) {
    ExactComplex other = right;
    other.vertices.push_back(right.vertices[v]);
    other.face_isolated_vertices = moved(right.face_isolated_vertices,
                                         VertexId(right.vertices.size()), kUnbounded, kUnbounded);
    const std::string found = findings(compare(right, canonical(std::move(other)), 0));
    CHECK(found.find("vertex split exact " + std::to_string(v) + " float") != std::string::npos);
  }
}
