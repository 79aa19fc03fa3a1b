// Curves of paths, circles, ellipses and rounded rects, through read_svg.

#include <catch2/catch.hpp>

#include "plumbline/read.hpp"
#include "support/listing.hpp"

using namespace plumbline;

namespace {

SegmentSet drawn(const std::string& element, const Rational& tolerance = 0) {
  ReadOptions options;
  options.chord_tolerance = tolerance;
  return evaluate(read_svg("<svg>" + element + "</svg>", "a.svg", options));
}

/// The points that a path passes through, in a row.
std::string points(const std::string& data, const Rational& tolerance) {
  const SegmentSet set = drawn("<path d=\"" + data + "\"/>", tolerance);
  std::string text = to_text(set.segments[0].a);
  for (const Segment& segment : set.segments) text += ", " + to_text(segment.b);
  return text;
}

std::vector<Point> vertices(const SegmentSet& set) {
  std::vector<Point> result;
  for (const Segment& segment : set.segments) result.push_back(segment.a);
  return result;
}

bool is_closed(const SegmentSet& set) {
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    if (!(set.segments[i].b == set.segments[(i + 1) % set.segments.size()].a)) return false;
  }
  return true;
}

Rational squared_norm(const Point& p) { return p.x * p.x + p.y * p.y; }

}  // namespace

TEST_CASE("the curves of the specification's examples pass through their middles") {
  // SVG 1.1, 8.3.6 and 8.3.7; the middle of a cubic curve is (p0 + 3 p1 + 3 p2 + p3) / 8, that of a
  // quadratic one (p0 + 2 p1 + p2) / 4.
  CHECK(points("M100,200 C100,100 250,100 250,200 S400,300 400,200", 40) ==
        "100 200, 175 125, 250 200, 325 275, 400 200");
  CHECK(points("M200,300 Q400,50 600,300 T1000,300", 40) ==
        "200 300, 400 175, 600 300, 800 425, 1000 300");
}

TEST_CASE("relative curves are relative to the point before the curve") {
  CHECK(points("M100,200 c0,-100 150,-100 150,0 s150,100 150,0", 40) ==
        points("M100,200 C100,100 250,100 250,200 S400,300 400,200", 40));
  CHECK(points("M200,300 q200,-250 400,0 t400,0 400,0", 40) ==
        points("M200,300 Q400,50 600,300 T1000,300 T1400,300", 40));
  CHECK(points("m3,4 a5,5 0 0 0 1,-1", 1) == points("M3,4 A5,5 0 0 0 4,3", 1));
}

TEST_CASE("a smooth curve mirrors a control point of its own degree only") {
  // SVG 1.1, 8.3.6: otherwise the first control point is the current point.
  CHECK(points("M0 0 L100 0 S200 100 300 0", 40) == points("M0 0 L100 0 C100 0 200 100 300 0", 40));
  CHECK(points("M0 0 Q50 90 100 0 S200 100 300 0", 40) ==
        points("M0 0 Q50 90 100 0 C100 0 200 100 300 0", 40));
  CHECK(points("M0 0 C50 90 60 90 100 0 T300 0", 40) ==
        points("M0 0 C50 90 60 90 100 0 Q100 0 300 0", 40));
  CHECK(points("M0 0 C50 90 60 90 100 0 h0 S200 100 300 0", 40) ==
        points("M0 0 C50 90 60 90 100 0 h0 C100 0 200 100 300 0", 40));
}

TEST_CASE("the ledger counts curves by their command, with the largest bound") {
  const SegmentSet set =
      drawn("<path id='p' d='M0 0 C0 1 1 1 1 0 C1 1 2 1 2 0 Q3 1 4 0 L9 9'/>", Rational(1, 10));
  CHECK(set.rejected.empty());
  REQUIRE(set.ledger.size() == 2);
  CHECK(to_text(set.ledger[0].source, set.files) == "a.svg:1:6 path #p");
  CHECK(set.ledger[0].what == "curve C (2 times) by 8 chords");
  // The second difference is (1, -1), sqrt(2) long: 3/4 of it by 16 is 0.0663.
  CHECK(set.ledger[0].bound == "0.067 units");
  CHECK(set.ledger[1].what == "curve Q by 4 chords");
}

TEST_CASE("a curve that is straight and even is a segment, and no entry in the ledger") {
  const SegmentSet set = drawn("<path d='M0 0 C1 1 2 2 3 3 Q4 4 5 5'/>");
  CHECK(segments_of(set) == "0 0, 3 3\n3 3, 5 5\n");
  CHECK(set.ledger.empty());
}

TEST_CASE("the flags of an arc choose among four, whose points are exactly on their circles") {
  // Through (3, 4) and (4, 3) with radius 5 there are two circles, around (0, 0) and (7, 7).
  const auto [flags, x, y, less_than_half] = GENERATE(table<std::string, int, int, bool>({
      {"0 0", 0, 0, true},
      {"0 1", 7, 7, true},
      {"1 0", 7, 7, false},
      {"1 1", 0, 0, false},
  }));
  CAPTURE(flags);
  const SegmentSet set = drawn("<path d='M3 4 A5 5 0 " + flags + " 4 3'/>");
  CHECK(to_text(set.segments[0].a) == "3 4");
  CHECK(to_text(set.segments[set.segments.size() - 1].b) == "4 3");
  const Point centre{x, y};
  double length = 0;
  for (const Segment& segment : set.segments) {
    CHECK(squared_distance(segment.b, centre) == 25);
    length += nearest_sqrt(squared_distance(segment.a, segment.b));
  }
  // Angles 2 atan(1/7) and the rest, times the radius.
  CHECK(length == Approx(less_than_half ? 10 * 0.1418970546 : 10 * (3.1415926536 - 0.1418970546))
                      .epsilon(0.002));
  CHECK(set.ledger.size() == 1);
}

TEST_CASE("two half circles are a circle, closed exactly") {
  const SegmentSet set = drawn("<path d='M-.1 0 a.1 .1 0 0 1 .2 0 a.1 .1 0 0 1 -.2 0 z'/>");
  CHECK(is_closed(set));
  for (const Point& p : vertices(set)) CHECK(squared_norm(p) == Rational(1, 100));
}

TEST_CASE("radii that are too small are scaled up to reach both ends") {
  // SVG 1.1, F.6.6: the ellipse of radii 1:2 through (-3, 0) and (3, 0) around their middle.
  const SegmentSet set = drawn("<path d='M-3 0 A1 2 0 0 1 3 0'/>");
  for (const Point& p : vertices(set)) CHECK(p.x * p.x / 9 + p.y * p.y / 36 == 1);
}

TEST_CASE("a quarter of an ellipse has an irrational cotangent or not, its ends are exact") {
  const SegmentSet right = drawn("<path d='M2 0 A2 3 0 0 1 0 3'/>");
  for (const Point& p : vertices(right)) CHECK(p.x * p.x / 4 + p.y * p.y / 9 == 1);
  // Turned by a right angle, the radii change places.
  const SegmentSet turned = drawn("<path d='M3 0 A2 3 90 0 1 0 2'/>");
  for (const Point& p : vertices(turned)) CHECK(p.x * p.x / 9 + p.y * p.y / 4 == 1);
  CHECK(turned.ledger.size() == 1);

  const SegmentSet slanted = drawn("<path d='M0 0 A2 1 30 0 1 1 1'/>");
  CHECK(to_text(slanted.segments[0].a) == "0 0");
  CHECK(to_text(slanted.segments[slanted.segments.size() - 1].b) == "1 1");
  REQUIRE(slanted.ledger.size() == 3);
  CHECK(slanted.ledger[0].what == "rotation of an arc by 30");
  CHECK(slanted.ledger[0].bound == "1e-15 rad");
  CHECK(slanted.ledger[1].what == "radii of an arc");
}

TEST_CASE("a circle starts at its right and has exact points") {
  const SegmentSet set = drawn("<circle cx='1' cy='2' r='.5'/>");
  CHECK(to_text(set.segments[0].a) == "1.5 2");
  CHECK(is_closed(set));
  for (const Point& p : vertices(set)) CHECK(squared_distance(p, {1, 2}) == Rational(1, 4));
  CHECK(set.ledger.at(0).what == "circle by " + std::to_string(set.segments.size()) + " chords");
  CHECK(set.ledger.at(0).bound == "0.001 units");
}

TEST_CASE("an ellipse has exact points; a missing radius is the other one") {
  const SegmentSet set = drawn("<ellipse cx='-1' rx='4' ry='2'/>");
  for (const Point& p : vertices(set)) CHECK((p.x + 1) * (p.x + 1) / 16 + p.y * p.y / 4 == 1);
  for (const Point& p : vertices(drawn("<ellipse rx='auto' ry='2'/>"))) {
    CHECK(squared_norm(p) == 4);
  }
}

TEST_CASE("round shapes that draw nothing are rejected") {
  CHECK(rejected_of(drawn("<circle r='0'/>")) == "a.svg:1:6 circle: zero r: r=\"0\"\n");
  CHECK(rejected_of(drawn("<circle r='-1'/>")) == "a.svg:1:6 circle: negative r: r=\"-1\"\n");
  CHECK(rejected_of(drawn("<ellipse rx='1' ry='0'/>")) == "a.svg:1:6 ellipse: zero ry: ry=\"0\"\n");
  CHECK(rejected_of(drawn("<ellipse/>")) == "a.svg:1:6 ellipse: ellipse without radii\n");
}

TEST_CASE("the corners of a rect are quarters of ellipses, no larger than half its sides") {
  const std::string rect = "<rect x='1' y='1' width='10' height='6' ";
  const SegmentSet set = drawn(rect + "rx='2' ry='1'/>");
  CHECK(is_closed(set));
  CHECK(to_text(set.segments[0]) == "3 1, 9 1");
  // SVG 1.1, 9.2: a missing radius is the other one; each is cut to half of its side.
  CHECK(drawn(rect + "rx='2'/>").segments == drawn(rect + "ry='2'/>").segments);
  CHECK(drawn(rect + "rx='9' ry='9'/>").segments == drawn(rect + "rx='5' ry='3'/>").segments);
  const SegmentSet oval = drawn(rect + "rx='5' ry='3'/>");
  for (const Point& p : vertices(oval)) {
    CHECK((p.x - 6) * (p.x - 6) / 25 + (p.y - 4) * (p.y - 4) / 9 == 1);
  }
  CHECK(oval.ledger.at(0).what.starts_with("rounded corner (4 times) by "));
}

TEST_CASE("a curve that would take too many chords is rejected alone") {
  const SegmentSet set = drawn("<path d='M0 0 H1 C2 3 4 5 6 0 H7'/>", Rational("1/1000000000000"));
  CHECK(segments_of(set) == "0 0, 1 0\n6 0, 7 0\n");
  CHECK(rejected_of(set) == "a.svg:1:6 path: curve of more than 131072 chords: C2 3 4 5 6 0\n");
}

TEST_CASE("Bezier curves of a large drawing are drawn as the drawing needs it, also when reduced") {
  const std::string letter = "<path d=\"M0 0c0 5.5 4.5 10 10 10s10 -4.5 10 -10\"/>";
  const std::string page = "<rect x=\"-9999\" width=\"10000\" height=\"1000\"/>";
  const std::size_t alone = drawn(letter).segments.size();
  const std::size_t on_page = drawn(letter + page).segments.size() - 4;
  CHECK(alone == 64);
  CHECK(on_page == 4);
  const std::string reduced = "<g transform=\"scale(0.01)\">";
  CHECK(drawn(reduced + letter + "</g>").segments.size() == alone);
  CHECK(drawn(reduced + letter + page + "</g>").segments.size() - 4 == on_page);
  CHECK(drawn(reduced + letter + "</g><rect width=\"0.2\" height=\"0.2\"/>").segments.size() - 4 ==
        alone);
}

TEST_CASE("a given tolerance holds for curves of any drawing") {
  const std::string circle = "<circle r=\"1\"/>", page = "<rect width=\"9999\" height=\"9999\"/>";
  const Rational fine(1, 10000);
  CHECK(drawn(circle + page, fine).segments.size() - 4 == drawn(circle, fine).segments.size());
}
