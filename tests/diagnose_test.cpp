#include "plumbline/diagnose.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <random>

#include "diagnose/edge_tree.hpp"
#include "diagnose/roots.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "plumbline/structure.hpp"
#include "support/diagnoses.hpp"

using namespace plumbline;
using diagnose_steps::EdgeTree;

TEST_CASE("a drawing of closed rooms has no defects") {
  CHECK(list(kRoom + "5 0 5 10  0 5 5 5", "1") == "");
  const SegmentSet rooms = segments(kRoom + "5 0 5 10");
  const Diagnosis result = diagnose(rooms, arrange(rooms));
  CHECK(result.within == Rational(1, 100));
  CHECK(result.tips == 0);
  CHECK(result.tolerances.empty());
  CHECK(result.squared_detail == Rational(25));
}

TEST_CASE("equal segments are duplicates, one defect a group, in either direction") {
  CHECK(list(kRoom + "0 0 10 0  10 0 0 0  0 10 0 0", "1") ==
        "duplicate at 0 5 squared 100 tolerance 0 of 4 7\n"
        "duplicate at 5 0 squared 100 tolerance 0 of 1 5 6\n");
}

TEST_CASE("collinear segments that share more than a point overlap") {
  // 0..6 and 4..10 share 4..6; both contain 5..5.5, which is drawn twice.
  CHECK(list("0 0 6 0  4 0 10 0  5 0 5.5 0  5.5 0 5 0  0 0 0 9  10 0 0 9", "0.1") ==
        "duplicate at 5.25 0 squared 0.25 tolerance 0 of 3 4\n"
        "overlap at 5 0 squared 4 tolerance 0 of 1 2\n"
        "overlap at 5.25 0 squared 0.25 tolerance 0 of 1 3\n"
        "overlap at 5.25 0 squared 0.25 tolerance 0 of 2 3\n");
}

TEST_CASE("messages say what a CAD user sees") {
  const auto message = [](const std::string& drawing) {
    return diagnosis(segments(drawing), "0.5").defects.at(0).message;
  };
  CHECK(message(kRoom + "5 0 5 10.25") == "a line goes 0.25 beyond the one that it crosses");
  CHECK(message(kRoom + "5 0 5 12") == "a line goes 2 beyond the last one that it crosses");
  CHECK(message(kRoom + "5 10 5 12") == "a line of length 2 has a loose end");
  CHECK(message("0 0 3 4  3 4 3 6") ==
        "a line of length 7, in 2 edges has two loose ends, 6.7082 apart");
  CHECK(message(kRoom + "0 0 10 0") == "2 equal segments of length 10");
}

TEST_CASE("a bridge is the only connection of two closed parts") {
  CHECK(list(kRoom + rectangle(20, 0, 30, 10) + "10 5 20 5", "0.1") ==
        "bridge at 15 5 squared 100 of 9\n");
  // In a room, to a column; in two edges. What dangles from a bridge does not end it.
  CHECK(list(kRoom + rectangle(4, 4, 6, 6) + "0 5 2 5  2 5 4 5", "0.1") ==
        "bridge at 3 5 size 4 of 9 10\n");
  // A tree dangles, whatever its stem looks like.
  CHECK(list(kRoom + "0 5 2 5  2 5 3 6  2 5 3 4", "0.1") ==
        "dangle at 3 4 squared 2 of 7\ndangle at 3 6 squared 2 of 6\n");
}

TEST_CASE("a thin long face is a sliver, a small square none") {
  // 10 x 0.25: area 5/2, perimeter 20.5.
  CHECK(list(kRoom + "0 9.75 10 9.75", "0.25") ==
        "sliver at 5 9.875 area 2.5 size " + shortest_text(5 / 20.5) + " of 2 3 4 5\n");
  CHECK(list(rectangle(0, 0, 1, 1) + rectangle(5, 5, 95, 95), "2") == "");
  // The ratio of sides w + 1 / w + 2 = 10 is reached at w = 4 + sqrt(15) = 7.87.
  CHECK(list("0 0 787 0  787 0 787 100  787 100 0 100  0 100 0 0", "90") == "");
  CHECK(list("0 0 788 0  788 0 788 100  788 100 0 100  0 100 0 0", "90").substr(0, 6) == "sliver");
}

TEST_CASE("a piece of a line shorter than the distance is a short edge, a drawn side is none") {
  CHECK(list(kRoom + "5 0 5 10  5.5 0 7 10", "0.5").find("short edge at 5.25 0 squared 0.25") !=
        std::string::npos);
  // The end of a wall.
  CHECK(list(kRoom + "5 0 5 10  5.5 0 5.5 10", "0.5").find("short edge") == std::string::npos);
  // A niche 0.6 x 0.05 is a detail; the gap of 0.04 is none.
  const SegmentSet niche = segments(
      "0 0 4 0  4 0 4 -0.05  4 -0.05 4.6 -0.05  4.6 -0.05 4.6 0  4.6 0 9.96 0  10 0 10 8"
      "  10 8 0 8  0 8 0 0");
  const Diagnosis result = diagnosis(niche, "0.06");
  CHECK(list(result) == "gap at 9.98 0 squared 0.0016 tolerance 0.04 of 5 6\n");
  CHECK(result.squared_detail == Rational(1, 400));
  REQUIRE(result.tolerances.size() == 1);
  CHECK(result.tolerances[0].spares_detail);
}

TEST_CASE("what programs add to decimals is no detail") {
  const Diagnosis result =
      diagnosis(segments("0 0 500.00000000000006 0  500 0 500 300  500 300 0 300  0 300 0 0  "
                         "250 0 250 300.0000000000001"),
                "1");
  CHECK(result.squared_detail == Rational(250 * 250));
  CHECK(result.tolerances.size() == 1);
}

TEST_CASE("a spike has its name at the corner that makes it") {
  // The corner (4, 0.001) of the upper triangle should lie on the lower one's side.
  CHECK(list("0 0 10 0  10 0 5 -5  5 -5 0 0  0 0 4 0.001  4 0.001 2 6  2 6 0 0", "0.01") ==
        "near-miss at 4 0.001 squared 0.000001 tolerance 0.001 of 1 4 5\n");
  // Two parcels, one of which lacks the other's corner.
  const SegmentSet parcels = evaluate(read_wkt(
      "POLYGON ((-72.696428 41.797527, -72.712274 41.785347, -72.66441 41.751403, "
      "-72.635534 41.778325, -72.696428 41.797527)); "
      "POLYGON ((-72.700578 41.794337, -72.692501 41.791197, -72.699563 41.785815, "
      "-72.692501 41.782889, -72.681386 41.792784, -72.696428 41.797527, -72.700578 41.794337))",
      "a.wkt"));
  const Diagnosis result = diagnose(parcels, arrange(parcels));
  CHECK(result.count(DefectKind::NearlyParallel) == 0);
  REQUIRE(result.count(DefectKind::NearMiss) == 1);
  CHECK(to_text(result.defects.at(0).where) == "-72.700578 41.794337");
  CHECK(result.defects.at(0).size == Approx(8.706e-8).epsilon(1e-4));
}

TEST_CASE("what neighbours draw as closed shapes is drawn once by each") {
  const auto svg = [](const std::string& shapes) {
    return evaluate(read_svg("<svg xmlns='http://www.w3.org/2000/svg'>" + shapes + "</svg>", "a"));
  };
  const std::string grid =
      "<rect width='4' height='4'/><rect x='4' width='4' height='4'/>"
      "<rect y='4' width='8' height='4'/>";
  const SegmentSet neighbours = svg(grid);
  CHECK(list(diagnosis(neighbours, "0.01")) == "");
  CHECK(diagnosis(neighbours, "0.01").shared_sides == 3);
  CHECK(repetitions(neighbours, arrange(neighbours)).duplicates == 0);
  // The same shape twice, a line on a side, and shapes that overlap.
  CHECK(diagnosis(svg(grid + "<rect width='4' height='4'/>"), "0").count(DefectKind::Duplicate) ==
        4);
  CHECK(diagnosis(svg(grid + "<path d='M4 0V4'/>"), "0").count(DefectKind::Duplicate) == 1);
  CHECK(
      diagnosis(svg(grid + "<rect x='1' width='2' height='4'/>"), "0").count(DefectKind::Overlap) ==
      2);
}

TEST_CASE("openings as wide as doors are named, not counted") {
  const auto openings = [](const std::string& drawing, const std::optional<Range>& doors = {}) {
    const SegmentSet set = segments(drawing);
    std::string text;
    for (const Opening& o : diagnose(set, arrange(set), {std::nullopt, 1000, doors}).openings) {
      text += to_text(o.where) + " squared " + exact_text(o.squared_width) + "\n";
    }
    return text;
  };
  const std::string box = rectangle(0, 0, 12, 6);
  const std::string lines =
      box + "6 0 6 2.5  6 3.4 6 6  6.6 3 8.5 3  9 0 9 1.5  9 4.5 9 6";  // a screen, and 3 wide
  CHECK(openings(lines) == "6 2.95 squared 0.81\n");
  CHECK(openings(lines, Range{1, 3}) == "9 3 squared 9\n");
  CHECK(openings(lines + "  5 3 7 3") == "");
  // As programs print it.
  CHECK(openings(box + "6 0 6 2.5  6.0000000000000009 3.4 6 6").starts_with("6"));
  const std::string faces = box +
                            "5.9 0 6.1 0  6.1 0 6.1 2.5  6.1 2.5 5.9 2.5  5.9 2.5 5.9 0  "
                            "5.9 3.4 6.1 3.4  6.1 3.4 6.1 6  6.1 6 5.9 6  5.9 6 5.9 3.4";
  CHECK(openings(faces) == "6 2.95 squared 0.81\n");
  CHECK(openings(faces + "  5 3 7 3") == "");
}

TEST_CASE("lines that cross or meet at a tiny angle are nearly parallel, once a crossing") {
  // Slopes 0 and 1/100: squared sine 1 / 10001.
  const std::string crossing = "-100 0 100 0  -100 -1 100 1  ";
  const std::string frame = "-100 -1 -100 0  100 0 100 1";
  CHECK(list(crossing + frame, "0.1") == "nearly parallel at 0 0 squared 1/10001 of 1 2\n");
  CHECK(list("-100 0 100 0  -99 -1 99 1  -99 -1 -100 0  100 0 99 1", "0.1") == "");
}

TEST_CASE("hostile drawings are diagnosed") {
  CHECK(list("", "1") == "");
  const SegmentSet nothing;
  CHECK(diagnose(nothing, arrange(nothing)).within == 0);
  CHECK(list("+ 3 4", "1") == "");
  CHECK(list("+ 0 0  + 0 1  + 5 5", "1") == "near-miss at 0 0.5 squared 1 tolerance 1 of\n");
  CHECK(list("0 0 1e90 0  1e90 0 1e90 1e90  1e90 1e90 0 1", "2") ==
        "gap at 0 0.5 squared 1 tolerance 1 of 1 3\n");
  CHECK(list("0 0 1 1", "1e4000") == "dangle at 0 0 squared 2 tolerance 1.4142135623730951 of 1\n");
  const SegmentSet line = segments("0 0 1 1");
  CHECK_THROWS_AS(diagnose(line, arrange(line), {Rational(-1)}), Error);
}

TEST_CASE("of very many defects some are listed and all are counted") {
  SegmentSet pile;
  for (int i = 0; i < 3000; ++i) {
    pile.add({Point{0, 0}, Point{1, 1}}, SourceId());
    pile.add({Point{-i, 5}, Point{i + 1, 5}}, SourceId());  // each within the next
  }
  const Diagnosis result = diagnosis(pile, "0", 10);
  CHECK(result.count(DefectKind::Duplicate) == 1);
  CHECK(result.count(DefectKind::Overlap) == 3000 * 2999 / 2);
  CHECK(result.count(DefectKind::Dangle) == 1 + 1);
  CHECK(result.defects.size() == 1 + 10 + 2);
}

TEST_CASE("all ends of a hatch are found to stop short, however long and close the lines are") {
  constexpr int kSide = 1000;
  SegmentSet hatch = segments(rectangle(0, 0, kSide, kSide));
  const Rational off(1, 10);
  for (int i = 1; i < 2 * kSide; ++i) {
    const int low = std::max(0, i - kSide), high = std::min(i, kSide);
    hatch.add({Point{low + off, high - off}, Point{high - off, low + off}}, SourceId());
  }
  const Diagnosis result = diagnosis(hatch, "0.1");
  CHECK(result.count(DefectKind::Undershoot) == 2 * (2 * kSide - 1));
  CHECK(result.cut_short == 0);
}

TEST_CASE("a tree of edges finds what is near a point among parallels, fans and random edges") {
  std::mt19937 random(1);
  const auto number = [&] { return std::uniform_int_distribution<int>(0, 999)(random); };
  std::vector<PointD> points{{0, 0}};
  std::vector<Edge> edges;
  const auto add = [&](const PointD& a, const PointD& b) {
    points.insert(points.end(), {a, b});
    edges.push_back({VertexId(points.size() - 2), VertexId(points.size() - 1)});
  };
  for (int i = 0; i < 300; ++i) {
    add({1.0 * i, -3.0 * i}, {1000.0 + i, 300 - 3.0 * i});
    add({0, 0}, {1000, 1.0 * i});
    add({1.0 * number(), 1.0 * number()}, {1.0 * number(), 1.0 * number()});
    add({1.0 * i, 7}, {1.0 * i, 7});
  }
  constexpr double kReach = 9.7;
  const EdgeTree tree(edges, points);
  for (const PointD& p : points) {
    std::size_t found = 0, near = 0;
    tree.visit(p, kReach, [&](EdgeId, const EdgeTree::Foot&) { ++found; });
    for (const Edge& e : edges) {
      const PointD &a = points[e.tail], &b = points[e.head];
      const double squared = squared_distance(a, b), x = p.x - a.x, y = p.y - a.y;
      const double along = squared == 0 ? 0 : (x * (b.x - a.x) + y * (b.y - a.y)) / squared;
      if (distance(p, point_at({a, b}, std::clamp(along, 0.0, 1.0))) <= kReach) ++near;
    }
    CHECK(found == near);
  }
}

TEST_CASE("tolerances say what they mend and what they destroy") {
  // A gap of 1/4, an undershoot of 1/2, and an edge of 3/8 of a fine line: a notch.
  const std::string drawing =
      "0 0 10 0  10 0 10 10  10 10 0 10  0 10 0 0.25  5 0 5 9.5  "
      "20 0 30 0  30 0 30 0.375  30 0.375 30.375 0.375  30.375 0.375 30.375 9  30.375 9 20 0";
  const Diagnosis result = diagnosis(segments(drawing), "1");
  REQUIRE(result.tolerances.size() == 2);
  CHECK(result.squared_detail == Rational(9, 64));
  CHECK(result.tolerances[0].tolerance == 0.25);
  CHECK(result.tolerances[0].mended == 1);
  CHECK(result.tolerances[0].spares_detail);
  CHECK(result.tolerances[1].tolerance == 0.5);
  CHECK(result.tolerances[1].mended == 2);
  CHECK_FALSE(result.tolerances[1].spares_detail);
}

TEST_CASE("sums of square roots are compared exactly") {
  using diagnose_steps::Roots;
  CHECK(Roots({4, Rational(9, 4)}).compare(Rational(7, 2)) == 0);
  // sqrt(2) + sqrt(3) = 3.146264369941972342...
  const Rational decimal = parse_decimal("3.14626436994197234");
  CHECK(Roots({2, 3}).compare(decimal) > 0);
  CHECK(Roots({2, 3}).compare(decimal + parse_decimal("1e-17")) < 0);
  CHECK(Roots().compare(0) == 0);
  CHECK(Roots({2}).rounded_up() == 1.4142135623730951);  // sqrt(2) = 1.41421356237309504...
  CHECK(Roots({3}).rounded_up() == 1.7320508075688774);  // sqrt(3) = 1.73205080756887729...
  CHECK(Roots({Rational(1, 100)}).rounded_up() == 0.1);  // the double 0.1 is a little more
}

TEST_CASE("order, direction and repetition of segments change nothing; similarities scale") {
  std::mt19937 random(5);
  for (int round = 0; round < 40; ++round) {
    SegmentSet set;
    const auto coordinate = [&] { return Rational(static_cast<int>(random() % 40), 4); };
    for (int i = 0; i < 25; ++i) {
      set.add({Point{coordinate(), coordinate()}, Point{coordinate(), coordinate()}}, SourceId());
    }
    const auto facts = [](const Diagnosis& result, const Rational& scale) {
      std::map<std::string, int> text;
      for (const Defect& d : result.defects) {
        if (d.kind == DefectKind::Duplicate) continue;
        ++text[to_text(d.kind) + ' ' +
               (d.squared_size && d.kind != DefectKind::NearlyParallel
                    ? exact_text(*d.squared_size / (scale * scale))
                    : "") +
               (d.area ? exact_text(*d.area / (scale * scale)) : "")];
      }
      return text;
    };
    const auto expected = facts(diagnosis(set, "0.5"), 1);
    const std::string listed = list(diagnosis(set, "0.5"));

    SegmentSet other = set;
    other.segments = reversed(shuffled(set.segments, random));
    const Diagnosis shuffled_result = diagnosis(other, "0.5");
    CHECK(facts(shuffled_result, 1) == expected);

    SegmentSet twice = set;
    for (const Segment& s : set.segments) twice.add(s, SourceId());
    CHECK(facts(diagnosis(twice, "0.5"), 1) == expected);

    SegmentSet turned;  // turned by the angle of 3-4-5, five times as large, moved
    const auto image = [](const Point& p) {
      return Point{3 * p.x - 4 * p.y + 17, 4 * p.x + 3 * p.y - Rational(1, 3)};
    };
    for (const Segment& s : set.segments) turned.add({image(s.a), image(s.b)}, SourceId());
    CHECK(facts(diagnosis(turned, "2.5"), 5) == expected);
  }
}
