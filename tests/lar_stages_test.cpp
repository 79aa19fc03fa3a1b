// Stages of the repaired float pipeline up to the graph of cut segments, and all of them together.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <sstream>

#include "plumbline/engines/lar_stages.hpp"
#include "support/lar_graph.hpp"

using namespace plumbline;
using namespace plumbline::lar;

namespace {

std::string to_text(const Graph& g) {
  std::ostringstream text;
  for (std::size_t e = 0; e < g.edges.size(); ++e) {
    const PointD& a = g.vertices[g.edges[e].tail];
    const PointD& b = g.vertices[g.edges[e].head];
    text << a.x << ' ' << a.y << ", " << b.x << ' ' << b.y << " of";
    for (SegmentId s : g.edge_sources[e]) text << ' ' << std::size_t(s);
    text << '\n';
  }
  return text.str();
}

std::string to_text(const CutPair& cuts) {
  std::ostringstream text;
  for (const Cut& c : cuts) text << c.parameter << " at " << c.point.x << ' ' << c.point.y << "; ";
  return text.str();
}

std::string meeting(const SegmentD& s, const SegmentD& t, double radius) {
  const Meeting m = meet(s, t, radius);
  return to_text(m.on_first) + "| " + to_text(m.on_second);
}

template <class T>
std::string to_text(const Lists<T>& lists) {
  std::string text;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    for (const T& item : lists[i]) text += std::to_string(std::size_t(item)) + ' ';
    text += '\n';
  }
  return text;
}

std::vector<Box> random_boxes(std::size_t n, double side, std::mt19937& random) {
  std::uniform_real_distribution<double> at(0, 1);
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = at(random), y = at(random);
    boxes.push_back({x, y, x + side * at(random), y + side * at(random)});
  }
  return boxes;
}

/// Pairs of boxes that meet and share no bucket.
std::size_t lost_pairs(const std::vector<Box>& boxes, const Lists<EdgeId>& buckets) {
  std::set<std::pair<EdgeId, EdgeId>> together;
  for (std::size_t b = 0; b < buckets.size(); ++b) {
    for (EdgeId s : buckets[b]) {
      for (EdgeId t : buckets[b]) together.insert({s, t});
    }
  }
  std::size_t lost = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Box &s = boxes[i], &t = boxes[j];
      const bool meet = s[0] <= t[2] && t[0] <= s[2] && s[1] <= t[3] && t[1] <= s[3];
      lost += meet && !together.count({EdgeId(i), EdgeId(j)});
    }
  }
  return lost;
}

/// The partition of the points by transitive nearness, from all pairs.
std::vector<std::size_t> classes_by_brute_force(const std::vector<PointD>& points, double radius) {
  std::vector<std::size_t> least(points.size());
  std::iota(least.begin(), least.end(), std::size_t{0});
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = 0; j < points.size(); ++j) {
        const double dx = points[i].x - points[j].x, dy = points[i].y - points[j].y;
        if (dx * dx + dy * dy > radius * radius || least[j] <= least[i]) continue;
        least[j] = least[i];
        changed = true;
      }
    }
  }
  return least;
}

}  // namespace

TEST_CASE("coordinates are rounded to nearest, segments distinct and from left to right") {
  const Graph g = graph("1 0 0 1/3  0 1/3 1 0  2 0 2 1  0 1/3 1 0  + 5 5");
  CHECK(to_text(g) == "0 0.333333, 1 0 of 0 1 3\n2 0, 2 1 of 2\n5 5, 5 5 of\n");
  CHECK(g.vertices[0].y == 1.0 / 3.0);
}

TEST_CASE("containment boxes are grown by the margin on all sides") {
  const std::vector<Box> boxes = containment_boxes(graph("0 4 2 1"), 0.5);
  CHECK(boxes == std::vector<Box>{{-0.5, 0.5, 2.5, 4.5}});
}

TEST_CASE("boxes that meet share a bucket, whatever their sizes") {
  std::mt19937 random(1);
  for (const double side : {0.0, 0.01, 0.1, 1.0}) {
    std::vector<Box> boxes = random_boxes(300, side, random);
    boxes.push_back({0.5, 0, 0.5, 1});  // long ones, and a far one that draws the centroid away
    boxes.push_back({0, 0.25, 1, 0.25});
    boxes.push_back({1e9, 1e9, 1e9, 1e9});
    CHECK(lost_pairs(boxes, box_buckets(boxes)) == 0);
  }
}

TEST_CASE("buckets of small boxes are small, outliers or not") {
  std::mt19937 random(2);
  for (const double far : {1.0, 1e3, 1e9}) {
    std::vector<Box> boxes = random_boxes(5000, 0.005, random);
    for (int i = 0; i < 3; ++i) boxes.push_back({far, far, far, far});
    const Lists<EdgeId> buckets = box_buckets(boxes);
    std::size_t pairs = 0;
    for (std::size_t b = 0; b < buckets.size(); ++b) pairs += buckets[b].size() * buckets[b].size();
    CHECK(pairs < 50 * boxes.size());
  }
}

TEST_CASE("equal boxes end in one bucket; fewer than two boxes make none") {
  const std::vector<Box> equal(1000, Box{0, 0.7, 1, 0.7});
  CHECK(box_buckets(equal).size() == 1);
  CHECK(box_buckets(std::vector<Box>{}).size() == 0);
  CHECK(box_buckets(std::vector<Box>{{0, 0, 1, 1}}).size() == 0);
}

TEST_CASE("long boxes are not repeated without bound") {
  std::vector<Box> boxes;  // a grid of long walls, where every split repeats half of the members
  for (int i = 0; i < 200; ++i) {
    boxes.push_back({0, double(i), 200, double(i)});
    boxes.push_back({double(i), 0, double(i), 200});
  }
  CHECK(box_buckets(boxes).flat().size() < 100 * boxes.size());
}

TEST_CASE("full buckets of slanted edges are refined, and near edges still share one") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(0, 1);
  Graph hatching;
  for (int i = 0; i < 500; ++i) {
    const double x = i, turn = at(random);
    hatching.vertices.push_back({x, 0});
    hatching.vertices.push_back({x + 300 + turn, 500});
  }
  for (int i = 0; i < 100; ++i) {  // short ones between, across the lines
    const double x = 800 * at(random), y = 500 * at(random);
    hatching.vertices.push_back({x, y});
    hatching.vertices.push_back({x + 3 * at(random), y - 2});
  }
  for (std::size_t v = 0; v < hatching.vertices.size(); v += 2) {
    hatching.edges.push_back({VertexId(v), VertexId(v + 1)});
  }
  const double radius = 0.01;
  const std::vector<Box> boxes = containment_boxes(hatching, radius);
  const Lists<EdgeId> buckets = box_buckets(boxes);
  const Lists<EdgeId> refined = refine_buckets(hatching, buckets, radius);
  const auto pairs = [](const Lists<EdgeId>& lists) {
    std::size_t sum = 0;
    for (std::size_t b = 0; b < lists.size(); ++b) sum += lists[b].size() * lists[b].size();
    return sum;
  };
  CHECK(10 * pairs(refined) < pairs(buckets));
  const auto cuts = [&](const Lists<EdgeId>& lists) {
    std::string text;
    const Lists<Cut> found = cut_edges(hatching, boxes, lists, radius);
    for (std::size_t e = 0; e < found.size(); ++e) {
      for (const Cut& c : found[e]) text += std::to_string(c.parameter) + ' ';
      text += '\n';
    }
    return text;
  };
  std::vector<EdgeId> all;
  for (std::size_t e = 0; e < hatching.edges.size(); ++e) all.emplace_back(e);
  Lists<EdgeId> one_bucket;
  one_bucket.push_back(all);
  CHECK(cuts(refined) == cuts(one_bucket));
}

TEST_CASE("edges that fork at a common end meet nowhere else, unless an end is near") {
  CHECK(meeting({{0, 0}, {4, 0}}, {{0, 0}, {4, 1}}, 0.5) == "| ");
  CHECK(meeting({{4, 0}, {0, 0}}, {{4, 1}, {0, 0}}, 0.5) == "| ");
  CHECK(meeting({{0, 0}, {4, 0}}, {{3, 0.1}, {0, 0}}, 0.5) == "0.75 at 3 0.1; | ");
}

TEST_CASE("a proper crossing cuts both segments in one point") {
  CHECK(meeting({{0, 0}, {4, 0}}, {{1, -1}, {1, 3}}, 1e-9) == "0.25 at 1 0; | 0.25 at 1 0; ");
  CHECK(meeting({{0, 0}, {4, 0}}, {{1, 1}, {1, 3}}, 1e-9) == "| ");
  CHECK(meeting({{0, 0}, {4, 4}}, {{1, 0}, {5, 4}}, 1e-9) == "| ");
}

TEST_CASE("an end within the radius of the other segment cuts it at that end") {
  const SegmentD wall{{0, 0}, {7, 11}};
  CHECK(meeting({{0, 0}, {0, 11}}, {{0, 1}, {7, 1}}, 1e-9) == "0.0909091 at 0 1; | ");
  CHECK(meeting({{0, 0}, {4, 0}}, {{1, 0.1}, {1, 3}}, 0.11) == "0.25 at 1 0.1; | ");
  CHECK(meeting({{0, 0}, {4, 0}}, {{1, 0.1}, {1, 3}}, 0.09) == "| ");
  CHECK(meeting({{0, 0}, {4, 0}}, {{1, -0.1}, {1, 3}}, 0.11) == "0.25 at 1 -0.1; | ");
  CHECK(meeting(wall, {{0, 0}, {1, 0}}, 1e-9) == "| ");  // ends that pruning merges
  CHECK(meeting({{0, 0}, {4, 0}}, {{2, 0}, {2, 0}}, 1e-9) == "0.5 at 2 0; 0.5 at 2 0; | ");
}

TEST_CASE("collinear overlaps cut each other at their ends") {
  CHECK(meeting({{0, 0}, {2, 0}}, {{1, 0}, {3, 0}}, 1e-9) == "0.5 at 1 0; | 0.5 at 2 0; ");
  CHECK(meeting({{0, 0}, {4, 0}}, {{1, 0}, {3, 0}}, 1e-9) == "0.25 at 1 0; 0.75 at 3 0; | ");
}

TEST_CASE(
    "the longest side of a small triangle is cut at the corner opposite, the others are not") {
  const double height = 0.9;  // of a triangle with sides 1.1; the radius is 1
  const double half = std::sqrt(1.1 * 1.1 - height * height);
  const SegmentD base{{-half, 0}, {half, 0}};
  CHECK(meeting(base, {{0, height}, {0, 9}}, 1) == "0.5 at 0 0.9; | ");
  CHECK(meeting({{-half, 0}, {0, height}}, {{half, 0}, {9, 0}}, 1) == "| ");
}

TEST_CASE("pieces follow the parameter, and doubled pieces name both segments") {
  CHECK(to_text(split_graph("0 0 3 0  1 0 2 0  2 -1 2 1")) ==
        "0 0, 1 0 of 0\n1 0, 2 0 of 0 1\n2 -1, 2 0 of 2\n2 0, 2 1 of 2\n2 0, 3 0 of 0\n");
}

TEST_CASE("pruning is the transitive closure of nearness, crowded or not") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> at(0, 1);
  for (const double radius : {0.001, 0.01, 0.03, 0.05, 0.2, 3.0}) {
    std::vector<PointD> points;
    for (int i = 0; i < 600; ++i) points.push_back({at(random), at(random) * (i % 2 ? 1 : 0.02)});
    std::sort(points.begin(), points.end());
    const Pruning pruning = prune_vertices(points, radius);
    const std::vector<std::size_t> expected = classes_by_brute_force(points, radius);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      wrong += pruning.vertex_map[i] != pruning.vertex_map[expected[i]];
    }
    CHECK(wrong == 0);
    CHECK(pruning.vertices.size() ==
          std::set<std::size_t>(expected.begin(), expected.end()).size());
    CHECK(std::is_sorted(pruning.vertices.begin(), pruning.vertices.end()));
  }
}

TEST_CASE("a cluster becomes its centroid, and keeps what its members have in common") {
  const std::vector<PointD> points{{0.1, 0.7}, {0.2, 0.7}, {0.3, 0.7}, {9, 9}};
  const Pruning pruning = prune_vertices(points, 0.11);
  REQUIRE(pruning.vertices.size() == 2);
  CHECK(pruning.vertices[0].x == Approx(0.2));
  CHECK(pruning.vertices[0].y == 0.7);
  CHECK(to_text(pruning.clusters) == "0 1 2 \n");
  CHECK(prune_vertices(std::vector<PointD>{}, 1).vertices.empty());
}

TEST_CASE("simplification drops zero edges and unused vertices and keeps isolated points") {
  const Graph g = graph("0 0 0.001 0  5 0 5 1  5.001 0 5.001 1  + 9 9");
  const Pruning pruning = prune_vertices(g.vertices, 0.01);
  CHECK(to_text(simplify(g, pruning)) == "5.0005 0, 5.0005 1 of 1 2\n9 9, 9 9 of\n");
}

TEST_CASE("the stages, called one after the other, make what the pipeline makes") {
  const SegmentSet input = segments(rectangle(0, 0, 9, 9) + rectangle(2, 2, 4, 4) +
                                    "0 3 9 7  1 8 3 9  5 1 5 2  + 3 3 + 20 5");
  const Drawing drawing = to_doubles(input, {1e-6});
  Graph g = drawing.graph;
  for (bool idle = false; !idle;) {
    const std::vector<Box> boxes = containment_boxes(g, drawing.radius);
    const Lists<EdgeId> buckets = refine_buckets(g, box_buckets(boxes), drawing.radius);
    const Lists<Cut> cuts = cut_edges(g, boxes, buckets, drawing.radius);
    const Graph split = split_edges(g, cuts);
    const Pruning pruning = prune_vertices(split.vertices, drawing.radius);
    g = simplify(split, pruning);
    idle = cuts.flat().empty() && pruning.clusters.size() == 0;
  }
  const Lists<HalfedgeId> order = edge_slope_ordering(g);
  const Lists<HalfedgeId> cycles = face_cycles(g, order);
  const FloatComplex complex =
      cells(g, cycles, exterior_cycles(g, order, cycles), cycle_areas(g, cycles));
  const Result result = lar::arrange(input, {1e-6});
  CHECK(canonical(complex) == result.complex);
  CHECK(result.complex.face_count() == 5);  // two halves, the square's two, the unbounded one
}
