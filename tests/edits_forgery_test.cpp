// Repairs that are not what they say: each is refused, for its reason.

#include <catch2/catch.hpp>
#include <functional>

#include "support/repairs.hpp"

using namespace plumbline;

namespace {

/// What is changed of an honest repair. Where the log is forged, output and faces follow from it,
/// so that they do not give it away.
struct Forgery {
  std::string name;
  Made made;
  std::function<void(Repair&)> forge;
  std::string reason;
};

void replace_segment(Repair& repair, std::size_t i, const std::string& text) {
  std::vector<Segment> all = to_vector(repair.output.segments);
  all[i] = segments(text).segments[0];
  repair.output.segments = SegmentList(all);
}

void set_origins(Repair& repair, std::size_t i, const std::vector<std::size_t>& ids) {
  Lists<SegmentId> result;
  for (std::size_t k = 0; k < repair.origins.size(); ++k) {
    const auto known = repair.origins[k];
    std::vector<SegmentId> list(known.begin(), known.end());
    if (k == i) list = line("0 0 1 1", ids).segments;
    result.push_back(list);
  }
  repair.origins = result;
}

std::vector<Forgery> forged_outputs() {
  return {
      {"an end moved", corner(), [](Repair& r) { replace_segment(r, 0, "10 8 0 8.001"); },
       "that no edit put there"},
      {"a segment is missing", corner(),
       [](Repair& r) {
         r.output.segments.truncate(3);
         r.output.segment_source.pop_back();
         Lists<SegmentId> rest;
         for (std::size_t i = 0; i < 3; ++i) rest.push_back(r.origins[i]);
         r.origins = rest;
       },
       "that the output has not"},
      {"a segment that nobody drew", corner(),
       [](Repair& r) {
         r.output.segments.push_back(Segment{point("0 4"), point("10 4")});
         r.output.segment_source.push_back(r.output.segment_source[0]);
         r.origins.push_back(std::vector<SegmentId>{SegmentId(2)});
       },
       "that no edit put there"},
      {"a segment twice", corner(),
       [](Repair& r) {
         r.output.segments.push_back(r.output.segments[0]);
         r.output.segment_source.push_back(r.output.segment_source[0]);
         r.origins.push_back(std::vector<SegmentId>{SegmentId(2)});
       },
       "that no edit put there"},
      {"origins exchanged", corner(),
       [](Repair& r) {
         set_origins(r, 0, {3});
         set_origins(r, 1, {2});
         std::swap(r.output.segment_source[0], r.output.segment_source[1]);
       },
       "that no edit put there"},
      {"no origins", corner(), [](Repair& r) { set_origins(r, 0, {}); }, "a source that none"},
      {"origins beyond the input", corner(), [](Repair& r) { set_origins(r, 0, {9}); },
       "not ascending ids"},
      {"origins twice", pieces(),
       [](Repair& r) {
         set_origins(r, 0, {3, 3});
       },
       "not ascending ids"},
      {"an origin more", corner(),
       [](Repair& r) {
         set_origins(r, 0, {2, 3});
       },
       "that no edit put there"},
      {"too few origins", corner(), [](Repair& r) { r.origins = {}; }, "0 lists of origins"},
      {"the source of another segment", corner(),
       [](Repair& r) { r.output.segment_source[0] = r.output.segment_source[1]; },
       "a source that none of its origins has"},
      {"another file", corner(), [](Repair& r) { r.output.files[0] = "other"; }, "files of"},
      {"another label", corner(),
       [](Repair& r) {
         r.output.labels.push_back({SourceId(std::size_t{0}), "hall", {}, 0});
       },
       "labels of"},
      {"another layer", corner(),
       [](Repair& r) {
         r.output.layers.push_back({"wall", {}});
       },
       "layers of"},
      {"another unit", corner(),
       [](Repair& r) {
         r.output.unit = LengthUnit{"mm", {}};
       },
       "units of"},
      {"other sources", corner(), [](Repair& r) { r.output.sources = {}; }, "sources of"},
      {"an edit left out", corner(), [](Repair& r) { r.edits.pop_back(); },
       "that no edit put there"},
      {"an edit that was not made", dangles(),
       [](Repair& r) {
         r.edits.push_back(
             {EditKind::Trim, point("5 0"), decimal("0.36"), {line("5 0 5 0.6", {4, 6})}, {}});
         r.tolerances.trim = 1;
       },
       "that no edit put there"},
      {"an anchored segment", corner(), [](Repair& r) { r.anchored = {SegmentId(std::size_t{0})}; },
       "an anchored segment"},
      {"a refusal of nobody's segments", corner(),
       [](Repair& r) {
         r.refused.push_back({EditKind::Grow, {}, 1, "", {SegmentId(std::size_t{9})}});
       },
       "refused grow"},
      {"a face left out", door(), [](Repair& r) { r.faces.pop_back(); }, "does not say so"},
      {"a face too many", dangles(), [](Repair& r) { r.faces = door().repair.faces; },
       "what is not so"},
      {"another area", door(), [](Repair& r) { r.faces[0].area_after = 35; }, "does not say so"},
      {"another fate", corner(), [](Repair& r) { r.faces[0].fate = FaceFate::Changed; },
       "does not say so"},
      {"another edit's face", corner(), [](Repair& r) { r.faces[0].edits = {1}; },
       "does not say so"},
  };
}

std::vector<Forgery> forged_unions() {
  return {
      {"an edit twice", corner(), [](Repair& r) { r.edits.push_back(r.edits[1]); },
       "trim takes a line away that is not there"},
      {"edits in another order", dangles(), [](Repair& r) { std::swap(r.edits[0], r.edits[1]); },
       "dissolve is where another line is"},
      {"a line with its ends exchanged", corner(),
       [](Repair& r) { std::swap(r.edits[0].after[0].a, r.edits[0].after[0].b); }, "in no order"},
      {"a line that is not there", corner(),
       [](Repair& r) {
         r.edits[1].before[0] = line("0 0 10.03 0", {3});
         r.edits[1].after[0] = line("0 0 10 0", {3});
       },
       "trim takes a line away that is not there"},
      {"a merge that moves", doubled(), [](Repair& r) { r.edits[2].squared_size = 1; },
       "merge moves"},
      {"a merge of lines that are beside each other", doubled(),
       [](Repair& r) {
         r.edits = {{EditKind::Merge,
                     point("0 0"),
                     0,
                     {line("0 0 10 0", {0}), line("0 0.002 7 0.002", {1})},
                     {line("0 0 10 0", {0, 1})}}};
       },
       "not on one line"},
      {"a merge across a gap", pieces(),
       [](Repair& r) {
         r.edits = {{EditKind::Merge,
                     point("0 0"),
                     0,
                     {line("0 0 5 0", {0}), line("5.06 0 5.1 0", {1})},
                     {line("0 0 5.1 0", {0, 1})}}};
       },
       "do not overlap"},
      {"a merge that makes more", doubled(),
       [](Repair& r) {
         r.edits[2].after[0] = line("0 0 11 0", {0, 1});
       },
       "not their union"},
      {"a merge that forgets a segment", doubled(),
       [](Repair& r) { r.edits[2].after[0] = line("0 0 10 0", {0}); }, "lines of 2 segments"},
      {"a dissolved corner", dangles(),
       [](Repair& r) {
         r.edits[1] = {EditKind::Dissolve,
                       point("10 8"),
                       0,
                       {line("10 0 10 8", {1}), line("0 8 10 8", {2})},
                       {line("0 8 10 0", {1, 2})}};
       },
       "not on one line"},
      {"a dissolved gap", pieces(),
       [](Repair& r) {
         r.edits = {{EditKind::Dissolve,
                     point("0 0"),
                     0,
                     {line("0 0 5 0", {0}), line("5.06 0 5.1 0", {1})},
                     {line("0 0 5.1 0", {0, 1})}}};
       },
       "not end to end"},
  };
}

Edit grown(const std::string& where, const std::string& squared, const std::string& from,
           const std::string& to, std::size_t id) {
  return {EditKind::Grow, point(where), decimal(squared), {line(from, {id})}, {line(to, {id})}};
}

std::vector<Forgery> forged_additions() {
  return {
      {"a growth longer than it says", corner(),
       [](Repair& r) { r.edits[0].squared_size = decimal("0.0001"); }, "grow adds 0.02, not 0.01"},
      {"a growth beyond the tolerance", corner(),
       [](Repair& r) { r.tolerances.grow = decimal("0.01"); }, "grow goes 0.02, more than 0.01"},
      {"a growth aside", corner(),
       [](Repair& r) { r.edits[0].after[0] = line("10.001 0 10 8", {1}); }, "grow leaves its line"},
      {"a growth at both ends", corner(),
       [](Repair& r) { r.edits[0].after[0] = line("10 0 10 8.01", {1}); }, "longer at one end"},
      {"a growth in two steps", corner(),
       [](Repair& r) {
         r.edits[0] = grown("10 0.02", "0.0001", "10 0.02 10 8", "10 0.01 10 8", 1);
         r.edits.insert(r.edits.begin() + 1,
                        grown("10 0.01", "0.0001", "10 0.01 10 8", "10 0 10 8", 1));
       },
       "goes on where it ended before"},
      {"a growth that ends on nothing", corner(),
       [](Repair& r) { r.edits = {grown("10.03 0", "0.0001", "0 0 10.03 0", "0 0 10.04 0", 0)}; },
       "ends on nothing"},
      {"a growth past the first wall",
       made("skins", "10 0 10 8  10.04 0 10.04 8  0 4 9.98 4", up_to(&Tolerances::grow, "0.1"),
            {grown("9.98 4", "0.0004", "0 4 9.98 4", "0 4 10 4", 2)}),
       [](Repair& r) { r.edits = {grown("9.98 4", "0.0036", "0 4 9.98 4", "0 4 10.04 4", 2)}; },
       "goes past what it meets first"},
      {"a growth from a corner", corner(),
       [](Repair& r) { r.edits = {grown("0 8", "0.0001", "0 0 0 8", "0 0 0 8.01", 3)}; },
       "not loose"},
      {"a bridge of another gap", pieces(),
       [](Repair& r) { r.edits[0].squared_size = decimal("0.0025"); },
       "bridge adds 0.06, not 0.05"},
      {"a bridge that goes on", pieces(),
       [](Repair& r) {
         r.edits[1].after[0] = line("0 0 10.5 0", {0, 1, 2});
       },
       "does not close its gap, and that alone"},
      {"a bridge across a piece", pieces(),
       [](Repair& r) {
         r.tolerances.grow = 1;
         r.edits = {{EditKind::Bridge,
                     point("5 0"),
                     decimal("0.0225"),
                     {line("0 0 5 0", {0}), line("5.15 0 10 0", {2})},
                     {line("0 0 10 0", {0, 2})}}};
       },
       "goes past what it meets first"},
      {"a joint of a corner", corner(),
       [](Repair& r) {
         r.edits = {{EditKind::Joint,
                     point("10.03 0"),
                     decimal("0.0013"),
                     {line("0 0 10.03 0", {0}), line("10 0.02 10 8", {1})},
                     {line("0 0 10.03 0", {0}), line("10 0.02 10 8", {1}),
                      line("10 0.02 10.03 0", {0, 1})}}};
       },
       "parallel"},
      {"a joint that is a wall of its own", pieces(),
       [](Repair& r) {
         r.edits = {{EditKind::Joint,
                     point("5 0"),
                     decimal("0.0036"),
                     {line("0 0 5 0", {0}), line("5.06 0 5.1 0", {1})},
                     {line("0 0 5 0", {0}), line("5.06 0 5.1 0", {1}), line("5 0 5.06 0", {0})}}};
       },
       "stands for other segments"},
      {"a door wider than doors", door(),
       [](Repair& r) { r.tolerances.doors->most = decimal("0.8"); }, "which no door is"},
      {"a door that nobody asked for", door(), [](Repair& r) { r.tolerances.doors = std::nullopt; },
       "not asked for"},
      {"a door for a wall", door(),
       [](Repair& r) { r.edits[0].after = {line("6 2.5 6 3.4", {4})}; }, "lines of 0 segments"},
      {"a door that closes nothing", door(),
       [](Repair& r) { r.edits[0].after = {line("6.6 3.9 6.6 3", {})}; },
       "same face on both sides"},
      {"a door between walls that go on", door(),
       [](Repair& r) {
         r.edits[0] = {EditKind::Door, point("0 1"), decimal("1"), {}, {line("6 1 7 1", {})}};
       },
       "is not between ends of walls"},
      {"a virtual wall", corner(), [](Repair& r) { r.edits[0].after[0].segments = {}; },
       "has a virtual line"},
  };
}

std::vector<Forgery> forged_removals() {
  return {
      {"a wall trimmed", corner(),
       [](Repair& r) {
         r.edits.push_back({EditKind::Trim, point("0 8"), 64, {line("0 0 0 8", {3})}, {}});
         r.tolerances.trim = 8;
       },
       "takes what is not loose"},
      {"a longer reach", corner(), [](Repair& r) { r.edits[1].squared_size = decimal("0.0001"); },
       "trim reaches 0.03, not 0.01"},
      {"a reach beyond the tolerance", corner(),
       [](Repair& r) { r.tolerances.trim = decimal("0.02"); }, "trim goes 0.03, more than 0.02"},
      {"a trim that adds", corner(),
       [](Repair& r) {
         r.edits[1].after = {line("0 0 10.02 0", {0}), line("0 1 0 2", {0})};
       },
       "leaves what was not there"},
      {"a trim of nothing", corner(), [](Repair& r) { r.edits[1].after = r.edits[1].before; },
       "takes nothing away"},
      {"a trimmed free piece", door(),
       [](Repair& r) {
         r.edits = {
             {EditKind::Trim, point("6.6 3"), decimal("3.61"), {line("6.6 3 8.5 3", {6})}, {}}};
         r.tolerances.trim = 2;
       },
       "takes a whole free piece"},
      {"a trim elsewhere", dangles(),
       [](Repair& r) {
         r.edits[0].where = point("5 0");
         r.edits[0].squared_size = decimal("0.13");
       },
       "no chain from its junction"},
      {"a border that is not near", thin(),
       [](Repair& r) { r.edits[0].squared_size = decimal("0.00009"); }, "farther from what stays"},
      {"a wall given away as a sliver", thin(),
       [](Repair& r) {
         r.edits = {
             {EditKind::Sliver, point("10 4"), decimal("0.0001"), {line("10 0 10 8", {1})}, {}}};
       },
       "farther from what stays"},
      {"a sliver that makes a line longer", thin(),
       [](Repair& r) { r.edits[0].after = {line("0 4 10 4.02", {5})}; },
       "leaves what was not there"},
  };
}

std::vector<Forgery> forged_movements() {
  return {
      {"a weld beyond twice the tolerance", doubled(),
       [](Repair& r) { r.tolerances.weld = decimal("0.0009"); }, "weld goes 0.002, more than"},
      {"a weld by more than it says", doubled(),
       [](Repair& r) { r.edits[0].squared_size = decimal("0.000001"); },
       "weld moves an end by 0.002, not 0.001"},
      {"a wall welded away", doubled(),
       [](Repair& r) {
         r.edits[1].after = {};
         r.edits.pop_back();
       },
       "makes a point of a line"},
      {"a weld that leaves half a line", doubled(),
       [](Repair& r) {
         r.edits.resize(2);
         r.edits[1].after = {line("4 0 4 7", {5})};
       },
       "weld leaves an end behind by 1"},
      {"a weld that loses the middle of a line", doubled(),
       [](Repair& r) {
         r.edits.resize(2);
         r.edits[1].after = {line("4 0 4 1", {5}), line("4 7 4 8", {5})};
       },
       "weld tears a line apart"},
      {"a weld of two lines", doubled(),
       [](Repair& r) {
         r.edits.resize(2);
         r.edits[1].before.push_back(line("10 0 10 8", {2}));
         r.edits[1].after.push_back(line("10 0 10 8", {2}));
       },
       "weld moves 2 lines"},
      {"welds that add up", doubled(),
       [](Repair& r) {
         r.edits = {{EditKind::Weld,
                     point("0 0.002"),
                     decimal("0.0004"),
                     {line("0 0.002 7 0.002", {1})},
                     {line("0 0.022 7 0.022", {1})}},
                    {EditKind::Weld,
                     point("0 0.022"),
                     decimal("0.0004"),
                     {line("0 0.022 7 0.022", {1})},
                     {line("0 0.042 7 0.042", {1})}}};
       },
       "more than 0.02"},
      {"a weld that makes lines cross", made("beside", "0 0 10 0  0 0.01 10 0.01", {}, {}),
       [](Repair& r) {
         r.tolerances = up_to(&Tolerances::weld, "0.01");
         r.edits = {{EditKind::Weld,
                     point("0 0.01"),
                     decimal("0.0004"),
                     {line("0 0.01 10 0.01", {1})},
                     {line("0 -0.01 10 0.03", {1})}}};
       },
       "meets one that it did not meet"},
      {"a snap beyond the tolerance", doubled(),
       [](Repair& r) { r.edits[0].kind = EditKind::Snap; }, "snap goes 0.002, more than 0"},
      {"a corner simplified", simplified(),
       [](Repair& r) {
         r.edits = {{EditKind::Simplify,
                     point("10 8"),
                     decimal("0.0001"),
                     {line("10 0 10 8", {1}), line("0 8 10 8", {2})},
                     {line("0 8 10 0", {1, 2})}}};
       },
       "simplify leaves"},
      {"a chain simplified to another one", simplified(),
       [](Repair& r) {
         r.edits[0].after[0] = line("0 4 10 4.01", {4, 5});
       },
       "moves the chain's ends"},
      {"a growth that opens a room", thin(),
       [](Repair& r) {
         r.edits[0].kind = EditKind::Grow;
         r.tolerances.grow = 1;
       },
       "2 segments and puts lines of 0"},
  };
}

void check_refused(const Forgery& forgery) {
  INFO(forgery.name);
  CHECK(verify(forgery.made.input, forgery.made.repair).empty());
  Repair repair = forgery.made.repair;
  const std::vector<Edit> log = repair.edits;
  forgery.forge(repair);
  std::string reasons;
  for (const Breach& breach : verify(forgery.made.input, repair)) reasons += breach.message + '\n';
  INFO(reasons);
  CHECK(reasons.find(forgery.reason) != std::string::npos);
}

}  // namespace

TEST_CASE("an output that its log does not make is refused") {
  for (const Forgery& forgery : forged_outputs()) check_refused(forgery);
}

TEST_CASE("an edit that does not do what its kind says is refused, though the output follows it") {
  for (const auto& forgeries :
       {forged_unions(), forged_additions(), forged_removals(), forged_movements()}) {
    for (Forgery forgery : forgeries) {
      const SegmentSet& input = forgery.made.input;
      const auto forge = forgery.forge;
      forgery.forge = [&](Repair& repair) {
        forge(repair);
        finish(input, repair);
      };
      check_refused(forgery);
    }
  }
}
