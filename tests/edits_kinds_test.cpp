// Edits that do not do what their kind says: each is refused, for its reason.

#include "support/forgeries.hpp"

using namespace plumbline;

namespace {

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

std::vector<Forgery> forged_growths() {
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
  };
}

std::vector<Forgery> forged_closings() {
  return {
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
      {"a bridge across two walls",
       made("two walls", "0 0 4 0  4.02 0 8 0  4.01 -1 4.01 1  4.015 -1 4.015 1",
            up_to(&Tolerances::grow, "0.1"), {}),
       [](Repair& r) { r.edits = meeting_on_wall().repair.edits; },
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

std::vector<Forgery> forged_welds() {
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
  };
}

std::vector<Forgery> forged_movements() {
  return {
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

}  // namespace

TEST_CASE("an edit that does not do what its kind says is refused, though the output follows it") {
  for (const auto& forgeries : {forged_unions(), forged_growths(), forged_closings(),
                                forged_removals(), forged_welds(), forged_movements()}) {
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
