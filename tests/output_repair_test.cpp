#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "output/svg/repair_parts.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/output.hpp"
#include "plumbline/pipeline.hpp"
#include "plumbline/read.hpp"
#include "plumbline/repair.hpp"

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

std::size_t occurrences(const std::string& text, const std::string& of) {
  std::size_t count = 0;
  for (auto at = text.find(of); at != text.npos; at = text.find(of, at + 1)) ++count;
  return count;
}

/// A line each: "kept 0 0, 10 0".
std::string parts_text(const SegmentSet& input, const Repair& repair) {
  constexpr std::array kNames{"kept", "added", "removed", "from", "to", "virtual"};
  std::string text;
  for (const LinePart& part : line_parts(input, repair)) {
    text += kNames.at(static_cast<std::size_t>(part.fate));
    text += ' ' + to_text(part.segment) + '\n';
  }
  return text;
}

}  // namespace

TEST_CASE("parts of lines: what was kept, added, removed and is virtual") {
  const SegmentSet input = plan();
  CHECK(parts_text(input, repaired(input)) ==
        "kept 0 0, 10 0\n"
        "kept 10 0.02, 10 8\n"
        "added 10 0, 10 0.02\n"
        "kept 0 8, 10 8\n"
        "kept 0 0, 0 8\n"
        "virtual 5 0, 5 8\n"
        "removed 10 0, 10.03 0\n");
}

TEST_CASE(
    "parts of lines: a welded line is where it was and where it is; one drawn twice is kept") {
  const SegmentSet input = evaluate(
      read_lines("0,0,10,0\n10,0,0,0\n4,0.002,4,8\n0,0.001,12,0.001\n5,5,6,6\n", "a.lines"));
  Repair repair;
  repair.output = input;
  repair.output.segments = {{{0, 0}, {12, 0}}, {{4, 0}, {4, 8}}};
  repair.output.segment_source.resize(2);
  const std::vector<SegmentId> wall{SegmentId(0), SegmentId(1), SegmentId(3)}, end{SegmentId(2)};
  repair.origins.push_back(wall);
  repair.origins.push_back(end);
  const Point low{0, parse_decimal("0.001")}, far{12, parse_decimal("0.001")};
  repair.edits = {{EditKind::Weld,
                   low,
                   parse_decimal("0.000001"),
                   {{low, far, {SegmentId(3)}}},
                   {{{0, 0}, {12, 0}, {SegmentId(3)}}}}};
  CHECK(parts_text(input, repair) ==
        "kept 0 0, 10 0\n"
        "to 10 0, 12 0\n"
        "kept 4 0.002, 4 8\n"
        "added 4 0, 4 0.002\n"
        "from 0 0.001, 12 0.001\n"
        "removed 5 5, 6 6\n");
}

TEST_CASE("faces of a picture: what became of them, which part of their border is virtual") {
  const SegmentSet input = plan();
  const Repair repair = repaired(input);
  const ExactComplex after = arrange(repair.output);
  const std::vector<double> shares = virtual_shares(repair, after);
  REQUIRE(shares.size() == 3);
  CHECK(shares[0] == 0);
  CHECK(shares[1] == Approx(8.0 / 26));
  const std::vector<ShownFace> faces = shown_faces(repair, after);
  REQUIRE(faces.size() == 3);
  CHECK(faces[0].title == "closed 80, 31 % of its border virtual");
  CHECK(faces[1].title == "split 80 -> 40, 31 % of its border virtual");
  CHECK_FALSE(faces[1].is_other);
  CHECK(faces[2].is_other);
  Repair without_faces = repair;
  without_faces.faces.clear();
  const std::vector<ShownFace> others = shown_faces(without_faces, after);
  REQUIRE(others.size() == 2);
  CHECK(others[0].what == "virtual");
  CHECK(others[0].title == "40, 31 % of its border virtual");
}

TEST_CASE("a picture of a repair: lines by fate, faces, rings with numbers, a list, crosses") {
  const SegmentSet input = plan();
  const Repair repair = repaired(input);
  const std::string svg = to_svg(repair, input, arrange(input), arrange(repair.output));
  CHECK(holds(svg, ">plan.lines: repair<"));
  CHECK(holds(svg, ">3 edits: 1 end grown by 0.02"));
  for (const char* words : {"as it was", "added", "removed", "virtual", "face closed (1)",
                            "part of a split face (2)", "refused (1)", "closed 80"}) {
    CHECK(holds(svg, std::string(">") + words + "<"));
  }
  CHECK_FALSE(holds(svg, ">moved"));
  CHECK(holds(svg, "<title>split 80 -&gt; 40, 31 % of its border virtual</title>"));
  CHECK(occurrences(svg, "<circle") == 3);
  CHECK(holds(svg, ">3</text>"));
}

TEST_CASE("a picture of very many edits has dots instead of rings, and no overlong list") {
  const SegmentSet input = plan();
  Repair repair = repaired(input);
  for (int i = 0; i < 3000; ++i) {
    repair.edits.push_back(repair.edits[1]);
    repair.edits.back().where = {Rational(i % 60, 6), Rational(i / 60, 7)};
  }
  const std::string svg = to_svg(repair, input, arrange(input), arrange(repair.output));
  CHECK(occurrences(svg, "r=\"2.2\"") > 2900);
  CHECK(holds(svg, "more edits<"));
  CHECK(occurrences(svg, ">trim<") < 60);
}

TEST_CASE("a page of a repair: names are text, without scripts the list is there") {
  SegmentSet input = plan();
  input.files[0] = "a/</script><img src=x onerror=alert(1)>.lines";
  const Repair repair = repaired(input);
  const std::string page = to_html(repair, input, arrange(input), arrange(repair.output));
  CHECK_FALSE(holds(page, "<img"));
  CHECK(holds(page, "script&gt;&lt;img src=x onerror=alert(1)&gt;.lines: repair</title>"));
  CHECK(holds(page, "<noscript><pre>\n3 edits: 1 end grown by 0.02"));
  CHECK(holds(page, "id=\"edits-panel\""));
  CHECK(occurrences(page, "</script>") == 3);
}

TEST_CASE("pictures and pages of nothing") {
  const SegmentSet nothing;
  const ExactComplex empty = arrange(nothing);
  CHECK(holds(to_svg(Repair{}, nothing, empty, empty), ">no edits<"));
  CHECK(holds(to_html(Repair{}, nothing, empty, empty), "no edits"));
}

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
  const RepairLog read = read_repair_log("plan.log.json");
  CHECK(read.changes == net_changes(input, repair));
  CHECK(undo(repair.output, read).segments.size() == input.segments.size());
  CHECK_THROWS_AS(undo(input, read), Error);  // not the drawing that was made
  RepairLog forged = read;
  forged.changes.front().before.front().segment.a.x += 1;
  CHECK_THROWS_AS(undo(repair.output, forged), Error);
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
  const std::string head =
      R"({"format": "plumbline repair 1", "files": ["a"], "input_signature": "", )"
      R"("output_signature": "", "changes": )";
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

TEST_CASE("the log of a repair has long names as they are") {
  const std::string name = "a name that is longer than a text in place";
  SegmentSet input;
  for (const Segment& s : {Segment{{0, 0}, {2, 0}}, Segment{{1, 0}, {3, 0}}}) {
    Source source;
    source.element = name + " of an element";
    source.id = name + " of an id";
    source.path = name + " of a path";
    source.layer = name;
    input.add(s, input.add_source(source));
  }
  const std::string log = to_json(repair(input), input);
  std::size_t count = 0;
  for (std::size_t i = log.find(name); i != log.npos; i = log.find(name, i + 1)) ++count;
  CHECK(count == 16);  // four of each of two segments, in the edit and in the change
  CHECK(holds(log, "\"layer\": \"" + name + '"'));
}
