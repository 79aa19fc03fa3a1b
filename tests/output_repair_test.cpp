#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "plumbline/output.hpp"
#include "plumbline/pipeline.hpp"
#include "plumbline/read.hpp"

using namespace plumbline;

namespace {

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

/// The text with one blank in place of several.
std::string close_up(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c != ' ' || !result.ends_with(' ')) result += c;
  }
  return result;
}

SegmentSet plan() {
  return evaluate(read_lines("0,0,10.03,0\n10,0.02,10,8\n10,8,0,8\n0,8,0,0\n", "a/plan.lines"));
}

/// The corner of the plan closed by hand, and an opening; one thing refused.
Repair repaired(const SegmentSet& input) {
  Repair repair;
  repair.output = input;
  repair.output.segments = {
      {{0, 0}, {10, 0}}, {{10, 0}, {10, 8}}, {{10, 8}, {0, 8}}, {{0, 8}, {0, 0}}};
  for (std::size_t s = 0; s < 4; ++s)
    repair.origins.push_back(std::vector<SegmentId>{SegmentId(s)});
  Source source;
  source.layer = kVirtualLayer;
  repair.output.add({{5, 0}, {5, 8}}, repair.output.add_source(source));
  repair.origins.push_back(std::vector<SegmentId>{});
  const Point far{parse_decimal("10.03"), 0}, low{10, parse_decimal("0.02")};
  const std::vector<SegmentId> first{SegmentId(0)}, second{SegmentId(1)};
  repair.edits = {{EditKind::Grow,
                   low,
                   parse_decimal("0.0004"),
                   {{low, {10, 8}, second}},
                   {{{10, 0}, {10, 8}, second}}},
                  {EditKind::Trim,
                   {10, 0},
                   parse_decimal("0.0009"),
                   {{{0, 0}, far, first}},
                   {{{0, 0}, {10, 0}, first}}},
                  {EditKind::Door, {5, 4}, 64, {}, {{{5, 0}, {5, 8}, {}}}}};
  repair.refused = {{EditKind::Weld, {1, 1}, Rational(1, 9), "two\nlines want it", first}};
  const FaceId outside = kUnbounded, one(1), two(2);
  repair.faces = {{FaceFate::Closed, outside, one, 0, 80, {1, 1}, {0}},
                  {FaceFate::Split, one, one, 80, 40, {1, 1}, {2}},
                  {FaceFate::Split, one, two, 80, 40, {6, 1}, {2}}};
  repair.tolerances.grow = repair.tolerances.trim = parse_decimal("0.05");
  repair.tolerances.doors = Range{parse_decimal("0.6"), 9};
  repair.reasons = {"grow 0.05: nothing lies between 0.03 and 1"};
  return repair;
}

}  // namespace

TEST_CASE("a repair in one line: edits by kind with the largest size, rooms, refusals") {
  const SegmentSet input = plan();
  Repair repair = repaired(input);
  CHECK(repair_line(repair) ==
        "3 edits: 1 end grown by 0.02, 1 door of 8 closed, 1 dangle of 0.03 trimmed; 1 room "
        "closed, 1 split; 1 refused");
  repair.edits.push_back(repair.edits[1]);
  CHECK(holds(repair_line(repair), "2 dangles of up to 0.03 trimmed"));
  CHECK(repair_line(Repair{}) == "no edits");
}

TEST_CASE("a repair as a table: what does most comes first, with element and rooms") {
  const SegmentSet input = plan();
  const std::string text = to_text(repaired(input), input);
  CHECK(holds(text,
              "tolerances: weld off, grow 0.05, trim 0.05, sliver off, snap off, simplify "
              "off, doors 0.6..9\n  grow 0.05: nothing lies between 0.03 and 1\n"));
  CHECK(holds(close_up(text),
              "edit what how far where rooms element\n"
              " 3 door 8 (5, 4) split 40 + 40 a new line\n"
              " 1 grow 0.02 (10, 0.02) closed 80 plan.lines:2 row\n"
              " 2 trim 0.03 (10, 0) plan.lines:1 row\n"));
  CHECK(holds(close_up(text),
              "refused: two\xef\xbf\xbdlines want it\n weld 0.333333 (1, 1) plan.lines:1 row\n"));
  CHECK(holds(to_text(repaired(input), input, 1), "... and 2 more"));
}

TEST_CASE("the screen of a repair has at most 40 lines, however much there is") {
  const SegmentSet input = plan();
  Repair repair = repaired(input);
  for (int i = 0; i < 100; ++i) {
    repair.edits.push_back(repair.edits[0]);
    repair.refused.push_back(repair.refused[0]);
    repair.reasons.push_back(repair.reasons[0]);
  }
  const std::string text = to_text(repair, input);
  CHECK(std::count(text.begin(), text.end(), '\n') <= 38);  // and what is written
  repair.edits[0].where = {parse_decimal("123456.789"), parse_decimal("-123456.789")};
  for (int i = 0; i < 9; ++i) repair.faces.push_back(repair.faces[0]);
  std::istringstream lines(to_text(repair, input));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(' ')) CHECK(line.size() <= 110);
  }
}

TEST_CASE("the log of a repair is read back as what it changed, and undoes it") {
  const SegmentSet input = plan();
  const Repair repair = repaired(input);
  const std::string log = to_json(repair, input);
  CHECK(holds(log, R"("squared_size": {)"));
  CHECK(holds(log, R"("exact": "0.0004",)"));
  std::ofstream("plan.log.json") << log;
  const std::vector<NetChange> changes = read_repair_log("plan.log.json");
  CHECK(changes == net_changes(input, repair));
  CHECK(undo(repair.output, changes).segments.size() == input.segments.size());
}

TEST_CASE("what is no log is refused with its place") {
  const auto refusal = [](const std::string& text) {
    std::ofstream("bad.log.json") << text;
    try {
      read_repair_log("bad.log.json");
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::BadInput);
      return std::string(error.what());
    }
    return std::string("taken");
  };
  CHECK(holds(refusal("[]"), "bad.log.json:1:1: not a log of a repair"));
  CHECK(holds(refusal(R"({"format": "plumbline rooms 1"})"), "not a log of `plumbline repair`"));
  const std::string head = R"({"format": "plumbline repair 1", "files": ["a"], "changes": )";
  CHECK(refusal(head + "[]}") == "taken");
  CHECK(holds(refusal(head + "[{}]}"), "no member \"before\""));
  CHECK(holds(
      refusal(head + R"([{"before": [], "after": [{"from": ["0", "1/0"], "to": ["0", "1"]}]}]})"),
      "1/0"));
  CHECK(holds(refusal(head + R"([{"before": [], "after": [{"from": ["0"], "to": ["0", "1"]}]}]})"),
              "not a point"));
  CHECK(holds(
      refusal(
          head +
          R"([{"before": [{"from": ["0", "0"], "to": ["0", "1"], "element": {"file": 7, "line": 1}}], "after": []}]})"),
      "no file has this number"));
}

TEST_CASE("edits as points for GIS, refused ones on layers of their own") {
  const SegmentSet input = plan();
  const FeatureLayer layer = edit_layer(repaired(input), input);
  REQUIRE(layer.features.size() == 4);
  CHECK(layer.features[0].layer == "grow");
  CHECK(layer.features[2].layer == "door");
  CHECK(layer.features[3].layer == "refused weld");
  for (const Feature& feature : layer.features)
    CHECK(feature.values.size() == layer.columns.size());
}

TEST_CASE("the repaired lines as features: sources, and which are virtual") {
  const SegmentSet input = plan();
  const FeatureLayer layer = line_layer(repaired(input).output);
  REQUIRE(layer.features.size() == 5);
  CHECK(std::get<std::string>(layer.features[0].values[2]) == "a/plan.lines:1:1 row");
  CHECK(std::get<std::int64_t>(layer.features[0].values[4]) == 0);
  CHECK(std::get<std::int64_t>(layer.features[4].values[4]) == 1);
  CHECK(layer.features[4].layer == kVirtualLayer);
}

TEST_CASE("a repaired drawing as .lines is exact") {
  SegmentSet set = plan();
  set.segments = {{{Rational(1, 3), 0}, {parse_decimal("0.1"), Rational(22, 7)}}};
  set.segment_source.resize(1);
  CHECK(evaluate(read_lines(to_lines(set), "a.lines")).segments == set.segments);
}
