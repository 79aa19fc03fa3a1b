// Planted faults, whose least drawings are known, and those of float LAR.

#include "plumbline/minimise.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <stdexcept>

#include "inputs/families.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/engines/lar.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output.hpp"
#include "plumbline/read.hpp"
#include "plumbline/round.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

/// Arranges exactly what `damage` leaves of the segments.
template <class Damage>
Engine faulty(Damage damage) {
  return {"faulty",
          "1",
          "a planted fault",
          {},
          [damage](const SegmentSet& input, const Parameters&, std::size_t threads) {
            LineWork work = rounded(input);
            damage(work.segments);
            Answer answer;
            answer.complex = nearest(arrange(work, threads));
            return answer;
          }};
}

double length(const SegmentD& s) { return std::hypot(s.b.x - s.a.x, s.b.y - s.a.y); }

/// Segments longer than that are made points, so that they vanish.
Engine without_long_ones(double most) {
  return faulty([most](std::vector<SegmentD>& lines) {
    for (SegmentD& line : lines) {
      if (length(line) > most) line.b = line.a;
    }
  });
}

/// Ends nearer than that to an earlier one are that one.
Engine merging(double radius) {
  return faulty([radius](std::vector<SegmentD>& lines) {
    std::vector<PointD> seen;
    for (SegmentD& line : lines) {
      for (PointD* end : {&line.a, &line.b}) {
        const auto near = std::find_if(seen.begin(), seen.end(), [&](const PointD& p) {
          return length({p, *end}) < radius;
        });
        if (near == seen.end()) {
          seen.push_back(*end);
        } else {
          *end = *near;
        }
      }
    }
  });
}

bool cross(const SegmentD& s, const SegmentD& t) {
  const Point a = exact(s.a), b = exact(s.b), c = exact(t.a), d = exact(t.b);
  return orientation(a, b, c) * orientation(a, b, d) < 0 &&
         orientation(c, d, a) * orientation(c, d, b) < 0;
}

/// Throws where three segments cross each other.
Engine throwing_on_triples() {
  return faulty([](const std::vector<SegmentD>& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; cross(lines[i], lines[j]) && k < j; ++k) {
          if (!cross(lines[i], lines[k]) || !cross(lines[j], lines[k])) continue;
          throw std::runtime_error("TripleError: " + std::to_string(lines[i].a.x));
        }
      }
    }
  });
}

/// Squares of side 4 beside each other, side by side with gaps of 1.
std::string squares(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += rectangle(5 * i, 1, 5 * i + 4, 5);
  return text;
}

Outcome outcome_of(const SegmentSet& drawing, const Engine& engine,
                   const Parameters& parameters = {}) {
  try {
    return outcome(check(drawing, arrange(drawing), answer_of(engine, drawing, parameters)));
  } catch (const std::runtime_error& error) {
    return {OutcomeClass::Loud, error.what(), 0};
  }
}

SegmentSet without(const SegmentSet& drawing, std::size_t left_out) {
  SegmentSet result;
  for (std::size_t s = 0; s < drawing.segments.size(); ++s) {
    if (s != left_out) result.add(drawing.segments[s], SourceId{});
  }
  return result;
}

/// What is promised, by runs of the engine of the test's own.
void hold_promises(const Minimised& m, const Engine& engine) {
  CAPTURE(to_lines(m.drawing), m.outcome.kind);
  CHECK(m.is_one_minimal);
  CHECK(m.has_simple_numbers);
  CHECK(is_same(outcome_of(m.drawing, engine, m.parameters), m.outcome));
  CHECK(m.is_representable == is_kept_by_simple_rounding(arrange(m.drawing), {}));
  for (std::size_t s = 0; s < m.drawing.segments.size() && m.drawing.segments.size() > 1; ++s) {
    const SegmentSet smaller = without(m.drawing, s);
    const bool is_still_there = is_same(outcome_of(smaller, engine, m.parameters), m.outcome);
    const bool is_allowed = !m.is_representable || is_kept_by_simple_rounding(arrange(smaller), {});
    CHECK_FALSE((is_still_there && is_allowed));
  }
  const Minimised again = minimised(m.drawing, engine, m.parameters);
  CHECK(to_lines(again.drawing) == to_lines(m.drawing));
}

}  // namespace

TEST_CASE("an engine that is right leaves the drawing as it is, in doubles") {
  const SegmentSet input = segments("0 0 3 0.1  0 0.1 3 0  1/3 0 0.5 2");
  const Minimised m = minimised(input, faulty([](std::vector<SegmentD>&) {}));
  CHECK(m.outcome.outcome_class == OutcomeClass::Right);
  CHECK(m.outcome.kind.empty());
  CHECK(m.drawing.segments.size() == 3);
  CHECK(m.drawing.segments[0].b.y == rational_from(0.1));
  CHECK(m.check.agree());
  CHECK(m.runs == 1);
}

TEST_CASE("a lost face needs three segments, since two enclose none") {
  // One side of the third square is long.
  const SegmentSet input = segments(squares(5) + "10 0 10 30  21.5 0.25 23.75 0.25");
  const Engine engine = without_long_ones(20);
  const SegmentSet square = segments("0 0 4 0  4 0 4 4  4 4 0 4  0 30 0 0");
  SegmentSet both = input;
  both.segments = joined(input.segments, square.segments);
  both.segment_source.resize(both.segments.size(), SourceId(0));
  REQUIRE(outcome_of(both, engine).kind == "face lost");
  const Minimised m = minimised(both, engine);
  CHECK(m.outcome.kind == "face lost");
  CHECK(m.segments_before == both.segments.size());
  CHECK(m.drawing.segments.size() == 3);
  hold_promises(m, engine);
}

TEST_CASE("a dangling edge that is lost stands alone, on numbers of one or two characters") {
  const SegmentSet input = segments(squares(9) + "100.123 200.456 131.789 198.765");
  const Engine engine = without_long_ones(20);
  REQUIRE(outcome_of(input, engine).kind == "edge missing");
  const Minimised m = minimised(input, engine);
  CHECK(m.outcome.kind == "edge missing");
  REQUIRE(m.drawing.segments.size() == 1);
  CHECK(to_lines(m.drawing).size() <= std::string("0,0,21,0\n").size());
  CHECK(m.drawing.sources[m.drawing.segment_source[0]].line == 37);
  hold_promises(m, engine);
}

TEST_CASE("a ring that merging closes is a triangle in the end") {
  const std::string ring = "50 50 54 50  54 50 55 53  55 53 52 56  52 56 49 53  49 53 50 50.0005";
  const SegmentSet input = segments(squares(6) + ring);
  const Engine engine = merging(0.001);
  REQUIRE(outcome_of(input, engine).kind == "face invented");
  const Minimised m = minimised(input, engine);
  CHECK(m.outcome.kind == "face invented");
  CHECK(m.drawing.segments.size() == 3);
  hold_promises(m, engine);
}

TEST_CASE("what an engine throws is an outcome, and three that cross are three") {
  std::string text = squares(4);
  for (const char* star : {"0 50 10 60  0 60 10 50.5  1 51 2 70  5 48.5 5 62", "7 7 30 41"}) {
    text += std::string(star) + ' ';
  }
  const SegmentSet input = segments(text);
  const Minimised m = minimised(input, throwing_on_triples());
  CHECK(m.outcome.outcome_class == OutcomeClass::Loud);
  CHECK(m.outcome.kind == "exception: TripleError");
  CHECK(m.check.comparison.findings[m.outcome.finding - 1].message.starts_with("TripleError: "));
  CHECK(m.drawing.segments.size() == 3);
  CHECK(m.is_one_minimal);
}

TEST_CASE("order, direction and repetition of the segments change nothing") {
  const SegmentSet input = segments(squares(5) + rectangle(0, 0, 40, 30) + "3 7 9 9.125");
  const Engine engine = without_long_ones(20);
  const Minimised first = minimised(input, engine);
  REQUIRE(first.outcome.outcome_class == OutcomeClass::Topology);
  std::mt19937 random(1);
  for (int i = 0; i < 5; ++i) {
    SegmentSet other = input;
    other.segments = reversed(shuffled(input.segments, random));
    other.segments = joined(other.segments, input.segments);
    other.segment_source.resize(other.segments.size(), SourceId(0));
    CHECK(to_lines(minimised(other, engine).drawing) == to_lines(first.drawing));
  }
}

TEST_CASE("a refusal of the engine is passed on, with the whole drawing") {
  const Engine engine = faulty([](const std::vector<SegmentD>& lines) {
    if (lines.size() > 2) throw Error(ErrorCode::BadInput, "too many");
  });
  CHECK_THROWS_WITH(minimised(segments("0 0 1 0  0 1 1 1  0 2 1 2"), engine),
                    Catch::Contains("too many"));
  CHECK_THROWS_WITH(minimised(segments("0 0 1 0"), engine, {{"radius", 0.5}}),
                    Catch::Contains("no such parameter"));
}

TEST_CASE("a failure is of its kind by what is said, not by the numbers in it") {
  const auto kind = [](const std::string& message) {
    const Engine engine =
        faulty([message](const std::vector<SegmentD>&) { throw std::runtime_error(message); });
    return minimised(segments("0 0 1 0"), engine).outcome.kind;
  };
  CHECK(kind("no node at -1.5e-7 (17) in ring2: 3") == "exception: no node at # (#) in ring2");
  CHECK(kind("1 of 2. 5") == "exception: # of #. #");
  CHECK(kind("") == "exception: ");
}

TEST_CASE("it ends early with what there is, or without anything where it is cancelled") {
  const SegmentSet input = segments(squares(30) + "0 0 40 0");
  const Engine engine = without_long_ones(20);
  MinimiseOptions options;
  options.max_runs = 3;
  const Minimised few = minimised(input, engine, {}, options);
  CHECK_FALSE(few.is_one_minimal);
  CHECK_FALSE(few.has_simple_numbers);
  CHECK(is_same(outcome_of(few.drawing, engine), few.outcome));
  options = {};
  options.enough = [] { return true; };
  CHECK(minimised(input, engine, {}, options).drawing.segments.size() == input.segments.size());
  options = {};
  options.progress = [](std::size_t runs, std::size_t) { return runs < 2; };
  CHECK_THROWS_WITH(minimised(input, engine, {}, options), Catch::Contains("cancelled"));
}

TEST_CASE("what the file's own digits leave open is not the engine's") {
  // Printed doubles that miss each other by their last digit.
  const std::string rows = "0,0,0.30000000000000004,1\n0.3,1,5.1234567890123456,3\n";
  const SegmentSet input = evaluate(read_lines(rows, "printed.lines"));
  const Minimised m = minimised(input, merging(1e-9));
  CHECK(m.outcome.outcome_class == OutcomeClass::Right);
}

TEST_CASE("divergences of float LAR in drawings of a hundred segments and more fit on a screen") {
  const Engine engine = lar::engine();
  std::size_t wrong = 0;
  for (const std::string& family : inputs::families()) {
    if (inputs::cost(family) != inputs::Cost::Cheap) continue;
    SegmentSet drawing;
    const SourceId source = drawing.add_source({});
    for (unsigned seed = 1; drawing.segments.size() < 100; ++seed) {
      const Rational shift = 1000 * static_cast<int>(seed);
      for (const Segment& s : inputs::of_family(family, seed).segments) {
        drawing.add({{s.a.x + shift, s.a.y}, {s.b.x + shift, s.b.y}}, source);
      }
    }
    CAPTURE(family);
    const Minimised m = minimised(drawing, engine, {{"radius", 0.001}});
    if (m.outcome.outcome_class == OutcomeClass::Right) continue;
    ++wrong;
    CHECK(m.drawing.segments.size() <= 12);
    hold_promises(m, engine);
  }
  CHECK(wrong >= 5);
}
