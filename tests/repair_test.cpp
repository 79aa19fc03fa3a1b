#include "plumbline/repair.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <random>

#include "plumbline/arrange.hpp"
#include "plumbline/read.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

Rational number(const std::string& text) { return parse_decimal(text); }

/// Tolerances that are given are numbers; the others are 0.
RepairOptions within(const std::string& weld, const std::string& grow, const std::string& trim,
                     const std::string& sliver = "0") {
  RepairOptions options;
  options.weld = number(weld);
  options.grow = number(grow);
  options.trim = number(trim);
  options.sliver = number(sliver);
  return options;
}

RepairOptions with_doors(const std::string& least, const std::string& most) {
  RepairOptions options = within("0", "0", "0");
  options.doors = Range{number(least), number(most)};
  return options;
}

/// A drawing, and what is right.
struct Case {
  std::string name, drawing, right;
  RepairOptions options;
};

const std::string box = "0 0 10 0  10 0 10 8  10 8 0 8  0 8 0 0  ";

std::vector<Case> cases() {
  return {
      {"corner", "0 0 10.03 0  10 0.02 10 8  10 8 0 8  0 8 0 0", box, within("0", "0.05", "0.05")},
      {"first hit", "0 0 10.04 0  10 0 10 8  10.04 0 10.04 8  10.04 8 0 8  0 8 0 0  0 4 9.98 4",
       "0 0 10.04 0  10 0 10 8  10.04 0 10.04 8  10.04 8 0 8  0 8 0 0  0 4 10 4",
       within("0", "0.1", "0.1")},
      {"pieces", "0 0 5 0  5.06 0 5.1 0  5.15 0 10 0  10 0 10 8  10 8 0 8  0 8 0 0", box,
       within("0", "0.1", "0.1")},
      {"niche",
       "0 0 4 0  4 0 4 -0.05  4 -0.05 4.6 -0.05  4.6 -0.05 4.6 0  4.6 0 9.96 0  10 0 10 8  10 8 0 "
       "8  "
       "0 8 0 0",
       "0 0 4 0  4 0 4 -0.05  4 -0.05 4.6 -0.05  4.6 -0.05 4.6 0  4.6 0 10 0  10 0 10 8  10 8 0 8  "
       "0 8 0 0",
       within("0", "0.06", "0.06")},
      {"star", box + "0 4 4.97 4  5.03 4 10 4  5 0 5 3.97  5 4.03 5 8", box + "0 4 10 4  5 0 5 8",
       within("0", "0.1", "0.1")},
      {"across",
       "0 0 10 0  0 -4 10 -4  0 4 10 4  0 -4 0 4  10 -4 10 4  5 0.03 5 4  5.02 -0.03 5.02 -4",
       "0 0 10 0  0 -4 10 -4  0 4 10 4  0 -4 0 4  10 -4 10 4  5 0 5 4  5.02 0 5.02 -4",
       within("0", "0.1", "0.1")},
      {"door between lines",
       "0 0 12 0  12 0 12 6  12 6 0 6  0 6 0 0  6 0 6 2.5  6 3.4 6 6  6.6 3 8.5 3  9 0 9 1.5  "
       "9 4.5 9 6",
       "0 0 12 0  12 0 12 6  12 6 0 6  0 6 0 0  6 0 6 2.5  6 2.5 6 3.4  6 3.4 6 6  6.6 3 8.5 3  "
       "9 0 9 1.5  9 4.5 9 6",
       with_doors("0.6", "1.2")},
      {"door between faces of walls",
       "0 0 12 0  12 0 12 6  12 6 0 6  0 6 0 0  5.9 0 6.1 0  6.1 0 6.1 2.5  6.1 2.5 5.9 2.5  "
       "5.9 2.5 5.9 0  5.9 3.4 6.1 3.4  6.1 3.4 6.1 6  6.1 6 5.9 6  5.9 6 5.9 3.4",
       "0 0 12 0  12 0 12 6  12 6 0 6  0 6 0 0  5.9 0 6.1 0  6.1 0 6.1 2.5  6.1 2.5 5.9 2.5  "
       "5.9 2.5 5.9 0  5.9 3.4 6.1 3.4  6.1 3.4 6.1 6  6.1 6 5.9 6  5.9 6 5.9 3.4  "
       "5.9 2.5 5.9 3.4  6.1 2.5 6.1 3.4",
       with_doors("0.6", "1.2")},
      {"doubled wall", "0 0 10 0  0 0.002 7 0.002  10 0 10 8  10 8 0 8  0 8 0 0  4 0.002 4 8",
       "0 0 10 0  10 0 10 8  10 8 0 8  0 8 0 0  4 0 4 8", within("0.01", "0", "0")},
      {"tree of dangles", box + "5 0 5 0.2  5 0.2 4.7 0.2  5 0.2 5 0.6", box + "5 0 5 0.6",
       within("0", "0", "0.5")},
      {"nothing",
       "0 0 7 0  7 0 7 11  7 11 0 11  0 11 0 0  0 1 7 1  0.943 0.648 1.343 0.263  "
       "1.023 0.571 0.543 0.573",
       "", within("0.05", "0.05", "0.05", "0.05")},
  };
}

using Map = std::function<Point(const Point&)>;

/// How plans are moved, and how much longer lengths become.
struct Motion {
  std::string name;
  Map map;
  Rational scale;
};

std::vector<Motion> motions() {
  const Rational third(1, 3);
  return {
      {"as it is", [](const Point& p) { return p; }, 1},
      {"turned by 3-4-5",
       [](const Point& p) {
         return Point{(3 * p.x - 4 * p.y) / 5 + Rational(1, 7), (4 * p.x + 3 * p.y) / 5};
       },
       1},
      {"mirrored",
       [](const Point& p) {
         return Point{-p.x, p.y};
       },
       1},
      {"scaled by 1/3",
       [third](const Point& p) {
         return Point{p.x * third, p.y * third};
       },
       third},
      {"scaled by 1000",
       [](const Point& p) {
         return Point{p.x * 1000, p.y * 1000};
       },
       1000},
      {"moved by 1e6",
       [](const Point& p) {
         return Point{p.x + 1000000, p.y - 1000000};
       },
       1},
  };
}

SegmentSet moved(SegmentSet set, const Map& map) {
  set.segments = changed(set.segments, [&](Segment& s) { s = {map(s.a), map(s.b)}; });
  return set;
}

RepairOptions scaled(RepairOptions options, const Rational& scale) {
  for (auto* tolerance : {&options.weld, &options.grow, &options.trim, &options.sliver}) {
    if (*tolerance) **tolerance *= scale;
  }
  if (options.doors) {
    options.doors = Range{options.doors->least * scale, options.doors->most * scale};
  }
  return options;
}

std::string signature_of(const SegmentSet& set) { return signature(arrange(set)); }

}  // namespace

TEST_CASE("plans with right answers are repaired to them, wherever they lie") {
  for (const Case& c : cases()) {
    for (const Motion& motion : motions()) {
      INFO(c.name << ", " << motion.name);
      const SegmentSet drawing = moved(segments(c.drawing), motion.map);
      const SegmentSet right = moved(segments(c.right.empty() ? c.drawing : c.right), motion.map);
      const RepairOptions options = scaled(c.options, motion.scale);
      const Repair repaired = repair(drawing, options);
      for (const Edit& edit : repaired.edits) {
        UNSCOPED_INFO(to_text(edit.kind) << " at " << to_text(edit.where) << " by "
                                         << nearest_sqrt(edit.squared_size));
      }
      CHECK(signature_of(repaired.output) == signature_of(right));
      CHECK(repair(repaired.output, options).edits.empty());
    }
  }
}

TEST_CASE("order, direction and repetition of segments do not change what a repair makes") {
  std::mt19937 random(5);
  for (const Case& c : cases()) {
    INFO(c.name);
    const SegmentSet drawing = segments(c.drawing);
    const std::string expected = signature_of(repair(drawing, c.options).output);
    for (int i = 0; i < 5; ++i) {
      SegmentSet other = drawing;
      other.segments = shuffled(drawing.segments, random);
      if (i % 2 == 1) other.segments = reversed(other.segments);
      CHECK(signature_of(repair(other, c.options).output) == expected);
      other.segments = joined(other.segments, drawing.segments);
      other.segment_source.insert(other.segment_source.end(), drawing.segment_source.begin(),
                                  drawing.segment_source.end());
      CHECK(signature_of(repair(other, c.options).output) == expected);
    }
  }
}

TEST_CASE("a vertex between two lines stays where one of them is given twice") {
  const SegmentSet twice = segments("0 0 1 0  1 0 2 0  1 0 2 0");
  const Repair merged = repair(twice, within("0", "0", "0"));
  CHECK(signature_of(merged.output) == signature_of(segments("0 0 1 0  1 0 2 0")));
}

TEST_CASE("a vertex between two lines goes where one of them is merged with its part") {
  RepairOptions options = within("0", "0", "0");
  options.simplify = number("0.04");
  const Repair simpler = repair(segments("0 0 1 1  1 1 3 3  1 1 2 2"), options);
  CHECK(signature_of(simpler.output) == signature_of(segments("0 0 3 3")));
  CHECK(repair(simpler.output, options).edits.empty());
}

TEST_CASE("a comb is left alone, and snapped by force it does not fall into one point") {
  std::string text = "0 0 0.0099 0  0 0.05 0.0099 0.05  ";
  for (int k = 0; k < 12; ++k) {
    const std::string x = exact_text(Rational(9 * k, 10000));
    text += x + " 0 " + x + " 0.05  ";
  }
  const SegmentSet comb = segments(text);
  const Repair untouched = repair(comb);
  CHECK(untouched.edits.empty());
  CHECK(untouched.tolerances == Tolerances{});

  RepairOptions forced = within("0", "0", "0");
  forced.snap = number("0.001");
  const Repair snapped = repair(comb, forced);
  for (const Edit& edit : snapped.edits) {
    CHECK(edit.squared_size <= forced.snap * forced.snap);
  }
  const ExactComplex complex = arrange(snapped.output);
  CHECK(complex.face_count() == 6);
  CHECK(feature_size(complex).squared_vertex_vertex > forced.snap * forced.snap);
  CHECK(repair(snapped.output, forced).edits.empty());
}

TEST_CASE("vertices go where nothing moves further than the tolerance") {
  const SegmentSet chain = segments("0 0 1 0.01  1 0.01 2 0  2 0 3 0.3  3 0.3 4 0");
  RepairOptions options = within("0", "0", "0");
  options.simplify = number("0.05");
  const Repair simpler = repair(chain, options);
  CHECK(signature_of(simpler.output) == signature_of(segments("0 0 2 0  2 0 3 0.3  3 0.3 4 0")));
  // Something in the triangle holds a vertex.
  const SegmentSet held = segments("0 0 1 0.01  1 0.01 2 0  1 0.005 1 0.004");
  CHECK(repair(held, options).edits.empty());
}

TEST_CASE("ends on parallel lines are joined where each is the only one for the other") {
  const SegmentSet offset = segments("0 0 5 0  5.02 0.03 10 0.03");
  const Repair joined = repair(offset, within("0", "0.1", "0"));
  REQUIRE(joined.edits.size() == 1);
  CHECK(joined.edits.front().kind == EditKind::Joint);
  CHECK(signature_of(joined.output) ==
        signature_of(segments("0 0 5 0  5 0 5.02 0.03  5.02 0.03 10 0.03")));
  const SegmentSet three = segments("0 0 5 0  5.02 0.03 10 0.03  5.02 -0.03 10 -0.03");
  const Repair refused = repair(three, within("0", "0.1", "0"));
  CHECK(refused.edits.empty());
  REQUIRE(refused.refused.size() >= 2);
  CHECK(refused.refused.back().kind == EditKind::Joint);
}

TEST_CASE("the flat keeps its rooms and its straight walls when doubled ones are welded") {
  const SegmentSet flat = evaluate(read(std::string(PLUMBLINE_TEST_DATA) + "/apartment.svg"));
  const auto large_faces = [](const ExactComplex& complex) {
    std::size_t count = 0;
    for (const Rational& area : face_areas(complex)) count += area > 100 ? 1 : 0;
    return count;
  };
  const auto skewed_edges = [](const ExactComplex& complex) {
    std::size_t count = 0;
    for (const Edge& edge : complex.edges) {
      const PointD p = complex.vertices.nearest(edge.tail), q = complex.vertices.nearest(edge.head);
      const double x = std::abs(p.x - q.x), y = std::abs(p.y - q.y);
      count += x > 0 && y > 0 && std::min(x, y) < 0.05 * std::max(x, y) ? 1 : 0;
    }
    return count;
  };
  const ExactComplex before = arrange(flat);
  REQUIRE(before.face_count() == 221);
  REQUIRE(large_faces(before) == 86);
  REQUIRE(skewed_edges(before) == 24);

  const RepairOptions options = within("0.018", "0", "0");
  const Repair welded = repair(flat, options);
  const ExactComplex after = arrange(welded.output);
  CHECK(after.face_count() == 152);
  CHECK(large_faces(after) == 86);
  CHECK(skewed_edges(after) <= 24);
  CHECK(repair(welded.output, options).edits.empty());

  const Repair chosen = repair(flat);
  CHECK(chosen.tolerances.weld >= number("0.018"));
  CHECK(chosen.tolerances.weld < number("0.027"));
  CHECK(large_faces(arrange(chosen.output)) == 86);
}

TEST_CASE("a tolerance is said so that it is read again as the same") {
  CHECK(tolerance_text(number("0.018")) == "0.018");
  CHECK(tolerance_text(number("0.00000000000271")) == "2.71e-12");
  CHECK(tolerance_text(Rational(1, 30)) == "1/30");
  for (const char* text : {"0.018", "2.71e-12", "1/30", "12", "0.1234567890123456789"}) {
    CHECK(number(tolerance_text(number(text))) == number(text));
  }
}

TEST_CASE("a repair ends where it is told not to go on") {
  RepairOptions options;
  int asked = 0;
  options.goes_on = [&] { return ++asked < 3; };
  try {
    repair(segments("0 0 4 0  4 0 4 3  4 3 0 3  0 3 0 0  2 0 2 2.99"), options);
    FAIL("it went on");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::Cancelled);
  }
  CHECK(asked == 3);
}
