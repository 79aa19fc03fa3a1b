#include "plumbline/edits.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "plumbline/arrange.hpp"
#include "plumbline/error.hpp"
#include "plumbline/repair.hpp"
#include "support/repairs.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

/// A line for each face outcome: "closed 0 -> 80".
std::string outcomes(const Repair& repair) {
  std::string text;
  for (const FaceOutcome& o : repair.faces) {
    text += to_text(o.fate) + ' ' + exact_text(o.area_before) + " -> " + exact_text(o.area_after) +
            " by";
    for (const std::size_t t : o.edits) text += ' ' + to_text(repair.edits[t].kind);
    text += '\n';
  }
  return text;
}

std::string breaches(const SegmentSet& input, const Repair& repair) {
  std::string text;
  for (const Breach& breach : verify(input, repair)) {
    text += breach.message + " at " + to_text(breach.where) + '\n';
  }
  return text;
}

/// Segments and edits, for whoever has to find out what is wrong.
std::string listed(const SegmentSet& input, const Repair& repair) {
  std::string text;
  for (const Segment& segment : input.segments) text += to_text(segment) + '\n';
  for (const Edit& edit : repair.edits) {
    text += to_text(edit.kind);
    for (const std::vector<Line>* lines : {&edit.before, &edit.after}) {
      for (const Line& line : *lines) {
        text += " [" + to_text(Segment{line.a, line.b});
        for (const SegmentId s : line.segments) text += " #" + std::to_string(s);
        text += ']';
      }
      if (lines == &edit.before) text += " ->";
    }
    text += '\n';
  }
  return text;
}

std::string signature_of(const SegmentSet& set) { return signature(arrange(set)); }

SegmentSet undone(const SegmentSet& input, const Repair& repair) {
  return undo(repair.output, net_changes(input, repair));
}

}  // namespace

TEST_CASE("honest repairs keep their promises, say what became of faces, and can be undone") {
  struct Case {
    Made made;
    std::string expected;
  };
  const std::vector<Case> cases = {
      {corner(), "closed 0 -> 80 by grow\n"},
      {pieces(), "closed 0 -> 80 by bridge bridge\n"},
      {meeting_on_wall(), ""},
      {door(), "split 72 -> 36 by door\nsplit 72 -> 36 by door\n"},
      {doubled(), "changed 31.992 -> 32 by weld\nchanged 48.008 -> 48 by weld\n"},
      {dangles(), ""},
      {thin(), "joined 0.05 -> 40 by sliver\nchanged 39.95 -> 40 by sliver\n"},
      {simplified(), "changed 40.05 -> 40 by simplify\nchanged 39.95 -> 40 by simplify\n"},
  };
  for (const Case& c : cases) {
    INFO(c.made.name);
    CHECK(breaches(c.made.input, c.made.repair) == "");
    CHECK(outcomes(c.made.repair) == c.expected);
    const SegmentSet back = undone(c.made.input, c.made.repair);
    CHECK(signature_of(back) == signature_of(c.made.input));
    CHECK(back.segments.size() == c.made.input.segments.size());
  }
}

namespace {

/// Walls on a lattice, most of them a bit off; those that are to be welded are parallel, since what
/// turns onto another one may come to cross a third.
SegmentSet sloppy_plan(std::mt19937& random, bool is_parallel) {
  const auto pick = [&](int count) {
    return Rational(static_cast<int>(random() % static_cast<unsigned>(count)));
  };
  const auto off = [&] { return Rational((pick(41) - 20) / 1000); };
  SegmentSet result;
  const SourceId source = result.add_source({});
  for (int i = 0; i < 14; ++i) {
    const Rational along = pick(5), across = pick(5), length = 1 + pick(3);
    const bool is_exact = random() % 3 == 0;
    const Rational side = is_exact ? Rational(0) : off();
    Point a = {along, across + side};
    Point b = {along + length, across + (is_parallel || is_exact ? side : off())};
    if (!is_exact) a.x += off(), b.x += off();
    if (random() % 2 == 0) std::swap(a.x, a.y), std::swap(b.x, b.y);
    result.add({a, b}, source);
  }
  return result;
}

RepairOptions random_options(std::mt19937& random, bool is_welding) {
  const auto hundredths = [&] { return Rational(static_cast<int>(random() % 9), 100); };
  RepairOptions options;
  options.weld = is_welding ? Rational(1, 100) : Rational(0);
  options.grow = hundredths();
  options.trim = hundredths();
  options.sliver = hundredths() / 2;
  return options;
}

}  // namespace

TEST_CASE("repairs that the operations make are honest") {
  std::mt19937 random(11);
  std::vector<std::size_t> made(kEditKinds);
  for (int round = 0; round < 300; ++round) {
    const bool is_welding = round % 2 == 0;
    const SegmentSet input = sloppy_plan(random, is_welding);
    Repair repaired = repair(input, random_options(random, is_welding));
    if (repaired.faces.empty()) {
      repaired.faces = face_outcomes(arrange(input), repaired, arrange(repaired.output));
    }
    for (const Edit& edit : repaired.edits) ++made[static_cast<std::size_t>(edit.kind)];
    INFO(round << '\n' << listed(input, repaired));
    CHECK(breaches(input, repaired) == "");
    CHECK(signature_of(undone(input, repaired)) == signature_of(input));
  }
  for (const EditKind kind : {EditKind::Merge, EditKind::Dissolve, EditKind::Grow, EditKind::Bridge,
                              EditKind::Trim, EditKind::Sliver, EditKind::Weld}) {
    INFO(to_text(kind));
    CHECK(made[static_cast<std::size_t>(kind)] > 0);
  }
}

TEST_CASE("doors that the operations find are between two faces") {
  const std::string box = "0 0 12 0  12 0 12 6  12 6 0 6  0 6 0 0  ";
  RepairOptions options;
  options.doors = Range{decimal("0.6"), decimal("1.2")};
  for (const std::string walls : {"6 0 6 2.5  6 3.4 6 6  6.6 3 8.5 3  9 0 9 1.5  9 4.5 9 6",
                                  "5.9 0 6.1 0  6.1 0 6.1 2.5  6.1 2.5 5.9 2.5  5.9 2.5 5.9 0  "
                                  "5.9 3.4 6.1 3.4  6.1 3.4 6.1 6  6.1 6 5.9 6  5.9 6 5.9 3.4"}) {
    const SegmentSet input = segments(box + walls);
    Repair repaired = repair(input, options);
    if (repaired.faces.empty()) {
      repaired.faces = face_outcomes(arrange(input), repaired, arrange(repaired.output));
    }
    CHECK(std::ranges::count(repaired.edits, EditKind::Door, &Edit::kind) == 1);
    CHECK(breaches(input, repaired) == "");
    CHECK(signature_of(undone(input, repaired)) == signature_of(input));
  }
}

TEST_CASE("a repair is undone in a file whose coordinates were rounded, with all sources") {
  const Made thirds = made("thirds", "0 0 1/3 0  1/3 0 1 0  0 0 0 1/3  0 1 1 1  0 1 1 1", {},
                           {{EditKind::Dissolve,
                             point("1/3 0"),
                             0,
                             {line("0 0 1/3 0", {0}), line("1/3 0 1 0", {1})},
                             {line("0 0 1 0", {0, 1})}},
                            {EditKind::Merge,
                             point("0 1"),
                             0,
                             {line("0 1 1 1", {3}), line("0 1 1 1", {4})},
                             {line("0 1 1 1", {3, 4})}}});
  CHECK(breaches(thirds.input, thirds.repair) == "");
  const std::vector<NetChange> changes = net_changes(thirds.input, thirds.repair);
  REQUIRE(changes.size() == 2);
  CHECK(changes[0].before.size() == 2);
  CHECK(changes[0].after.size() == 1);

  SegmentSet rounded = thirds.repair.output;
  rounded.files = {"rounded"};
  rounded.segments = changed(rounded.segments, [](Segment& s) {
    s = {exact(nearest(s.b)), exact(nearest(s.a))};
  });
  const SegmentSet back = undo(rounded, changes);
  REQUIRE(back.segments.size() == 5);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t s = i < 2 ? i : i + 1;  // the third is unchanged, and the first now
    CHECK(back.segments[i + 1] == thirds.input.segments[s]);
    const Source source = back.sources[back.segment_source[i + 1]];
    CHECK(source.line == s + 1);
    CHECK(back.files[source.file] == "text");
  }
}

TEST_CASE("a drawing that is not the repaired one can't be undone") {
  const Made plan = corner();
  const std::vector<NetChange> changes = net_changes(plan.input, plan.repair);
  SegmentSet less = plan.repair.output, more = plan.repair.output;
  less.segments = changed(less.segments, [](Segment& s) {
    if (s == Segment{point("10 8"), point("10 0")}) s.a.y += 1;
  });
  CHECK_THROWS_WITH(undo(less, changes),
                    Catch::Contains("0 times instead of 1") && Catch::Contains("10 8, 10 0"));
  more.segments.push_back(Segment{point("10 0"), point("10 8")});
  more.segment_source.push_back(more.segment_source[0]);
  CHECK_THROWS_WITH(undo(more, changes), Catch::Contains("2 times instead of 1"));
  CHECK_THROWS_AS(undo(SegmentSet(), changes), Error);
}
