// The published variant against recorded outputs of the original LAR module, in its order. See
// tests/data/README.md.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "plumbline/engines/inters_show.hpp"
#include "plumbline/engines/inters_stages.hpp"
#include "plumbline/output.hpp"
#include "plumbline/pipeline.hpp"
#include "support/recorded.hpp"

using namespace plumbline;
using namespace plumbline::inters;

namespace {

rapidjson::Document trace_of(const rapidjson::Value& lines) {
  const std::string json = to_json(run(recorded_lines(lines)));
  rapidjson::Document document;
  document.Parse<rapidjson::kParseFullPrecisionFlag>(json.c_str());
  return document;
}

using Errors = std::map<std::string, std::string>;

Errors errors_of(const rapidjson::Document& trace) {
  Errors errors;
  for (const auto& member : trace["errors"].GetObject()) {
    const std::string error = member.value["error"].GetString();
    if (error != "Limit") errors[member.name.GetString()] = error;  // the original has none
  }
  for (const auto& member : trace["outputs"].GetObject()) {  // what the original caught and printed
    if (!member.value.IsObject() || !member.value.HasMember("aborted")) continue;
    if (!member.value["aborted"].GetBool()) continue;
    errors[std::string(member.name.GetString()) + ".printed"] = "ValueError";
    if (std::string(member.name.GetString()) == "largest") {
      errors["larFromLines.printed"] = "ValueError";
    }
  }
  return errors;
}

Errors expected_errors(const rapidjson::Value& recorded_case) {
  Errors errors;
  for (const auto& member : recorded_case["errors"].GetObject()) {
    errors[member.name.GetString()] = member.value.GetString();
  }
  return errors;
}

std::string letters(const std::vector<Classification>& found) {
  std::string text;
  for (const Classification c : found) {
    text += c == Classification::In ? 'i' : c == Classification::On ? 'n' : 'o';
  }
  return text;
}

}  // namespace

TEST_CASE("every stage has the recorded output of the original, in its order") {
  const rapidjson::Document cases = recorded("inters.json");
  CHECK(cases.Size() == 97);
  for (const auto& recorded_case : cases.GetArray()) {
    const rapidjson::Document trace = trace_of(recorded_case["lines"]);
    for (const auto& output : recorded_case["outputs"].GetObject()) {
      INFO(recorded_case["case"].GetString() << ": " << output.name.GetString());
      const auto found = trace["outputs"].FindMember(output.name);
      REQUIRE(found != trace["outputs"].MemberEnd());
      CHECK(is_as_recorded(found->value, output.value));
    }
    INFO(recorded_case["case"].GetString());
    CHECK(errors_of(trace) == expected_errors(recorded_case));
  }
}

TEST_CASE("every stage of large drawings has the digest of the original's output") {
  const rapidjson::Document cases = recorded("inters_digests.json");
  CHECK(cases.Size() == 24);
  for (const auto& recorded_case : cases.GetArray()) {
    const rapidjson::Document trace = trace_of(recorded_case["lines"]);
    for (const auto& output : recorded_case["outputs"].GetObject()) {
      INFO(recorded_case["case"].GetString() << ": " << output.name.GetString());
      const auto found = trace["outputs"].FindMember(output.name);
      REQUIRE(found != trace["outputs"].MemberEnd());
      CHECK(digest(found->value) == output.value.GetString());
    }
    INFO(recorded_case["case"].GetString());
    CHECK(errors_of(trace) == expected_errors(recorded_case));
  }
}

TEST_CASE("points are classified as the original classified them") {
  const rapidjson::Document cases = recorded("point_in_polygon.json");
  const Vcode vcode(kDecimals);
  for (const auto& recorded_case : cases.GetArray()) {
    INFO(recorded_case["case"].GetString());
    std::vector<PointD> vertices;
    for (const auto& p : recorded_case["V"].GetArray()) vertices.push_back(recorded_point(p));
    std::vector<VertexPair> edges;
    for (const auto& e : recorded_case["EV"].GetArray()) {
      edges.push_back({VertexId(e[0].GetUint()), VertexId(e[1].GetUint())});
    }
    if (!recorded_case.HasMember("classification")) {
      CHECK_THROWS_AS(boundary_polylines(vertices, edges, vcode), StageFailure);
      continue;
    }
    const std::vector<Polyline> polylines = boundary_polylines(vertices, edges, vcode);
    std::vector<Polyline> expected;
    for (const auto& polyline : recorded_case["polylines"].GetArray()) {
      expected.emplace_back();
      for (const auto& p : polyline.GetArray()) expected.back().push_back(recorded_point(p));
    }
    CHECK(polylines == expected);
    std::vector<Classification> found;
    for (const auto& query : recorded_case["queries"].GetArray()) {
      found.push_back(classify(polylines, recorded_point(query)));
    }
    CHECK(letters(found) == recorded_case["classification"].GetString());
  }
}

TEST_CASE("SVG text is read as the original read it") {
  const rapidjson::Document cases = recorded("svg2lines.json");
  CHECK(cases.Size() == 16);
  const Vcode vcode(kDecimals);
  for (const auto& recorded_case : cases.GetArray()) {
    INFO(recorded_case["case"].GetString());
    const std::string svg = recorded_case["svg"].GetString();
    if (!recorded_case["errors"].IsNull()) {
      try {
        svg_to_lines(svg, true, vcode);
        FAIL("no failure");
      } catch (const StageFailure& failed) {
        CHECK(failed.failure().error == recorded_case["errors"]["error"].GetString());
      }
      continue;
    }
    CHECK(svg_to_lines(svg, true, vcode) == recorded_lines(recorded_case["lines"]));
    CHECK(svg_to_lines(svg, false, vcode) == recorded_lines(recorded_case["diagonals"]));
  }
}

TEST_CASE("the document's facade has three cells of 40 vertices and 40 edges, as printed") {
  // Section 2.11 of the document.
  const std::vector<std::vector<std::size_t>> printed{
      {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13,
       16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 27, 28, 29, 30},
      {32, 33, 37, 39},
      {34, 35, 36, 38, 26, 15, 14, 31}};
  const rapidjson::Document cases = recorded("inters.json");
  for (const auto& recorded_case : cases.GetArray()) {
    if (recorded_case["case"].GetString() != std::string("svg-inters-facade")) continue;
    const Trace trace = run(recorded_lines(recorded_case["lines"]));
    REQUIRE(trace.two_complex);
    const inters::Model& model = *trace.two_complex;
    CHECK(model.vertices.size() == 40);
    CHECK(model.vertices[0] == PointD{0.7808, 0.6751});
    CHECK(model.vertices[39] == PointD{0.3789, 0.7059});
    CHECK(model.edges.size() == 40);
    REQUIRE(model.faces.size() == 3);
    const std::set<std::size_t> first(model.faces[0].begin(), model.faces[0].end());
    CHECK(first == std::set<std::size_t>(printed[0].begin(), printed[0].end()));
    for (const std::size_t f : {1U, 2U}) {  // in the printed order, which is a set's
      CHECK(std::vector<std::size_t>(model.faces[f].begin(), model.faces[f].end()) == printed[f]);
    }
    const auto boundary = [&](std::vector<std::size_t> chain) {
      return boundary_chain(model, chain).size();
    };
    // The three faces have no edge in common.
    CHECK(boundary({0}) == 28);
    CHECK(boundary({1}) == 4);
    CHECK(boundary({2}) == 8);
    CHECK(boundary({0, 1}) == 32);
    CHECK(boundary({0, 0}) == 0);
  }
}

TEST_CASE("edges follow each other around vertices as the document prints") {
  // Section 2.5, the matrix of test07. A column's rows are the edge's ends, so that its entries say
  // which neighbour comes after which; rows 4 and 6 are not legible.
  const std::map<std::size_t, std::vector<std::size_t>> printed{
      {0, {1, 6, 11}}, {1, {0, 2, 3}},   {2, {1, 11}}, {3, {1, 7, 4, 6}},
      {5, {6, 12}},    {7, {3, 8, 9}},   {8, {7}},     {9, {7, 4}},
      {10, {4}},       {11, {0, 12, 2}}, {12, {11, 5}}};
  std::vector<SegmentD> lines{{{0, 0}, {6, 0}},   {{0, 4}, {10, 4}}, {{0, 0}, {0, 4}},
                              {{3, 0}, {3, 4}},   {{6, 0}, {6, 8}},  {{3, 2}, {6, 2}},
                              {{10, 0}, {10, 8}}, {{0, 8}, {10, 8}}};
  const inters::Model lar = run(lines).lar;
  const auto far_end = [&](EdgeId e, VertexId v) {
    return std::size_t(lar.edges[e][0] == v ? lar.edges[e][1] : lar.edges[e][0]);
  };
  std::size_t compared = 0;
  for (const NextEdge& entry : ordered_vertex_edges(edge_slope_ordering(lar))) {
    const auto row = printed.find(entry.vertex);
    if (row == printed.end()) continue;
    const std::vector<std::size_t>& around = row->second;
    const auto at = std::find(around.begin(), around.end(), far_end(entry.edge, entry.vertex));
    REQUIRE(at != around.end());
    const std::size_t next = at + 1 == around.end() ? around.front() : *(at + 1);
    CHECK(far_end(entry.next, entry.vertex) == next);
    ++compared;
  }
  CHECK(compared == 26);
}

TEST_CASE(
    "random segments are determined by their seed, lie from 0 up and are no longer than scaled") {
  const std::vector<SegmentD> lines = random_lines(500, 0.1, 7);
  CHECK(lines == random_lines(500, 0.1, 7));
  CHECK(lines != random_lines(500, 0.1, 8));
  CHECK(random_lines(0, 0.1, 7).empty());
  CHECK_THROWS_AS(random_lines(1, std::numeric_limits<double>::infinity(), 7), Error);
  double least_x = 1, least_y = 1, longest = 0;
  for (const auto& [a, b] : lines) {
    least_x = std::min({least_x, a.x, b.x});
    least_y = std::min({least_y, a.y, b.y});
    longest = std::max(longest, std::hypot(a.x - b.x, a.y - b.y));
  }
  CHECK(least_x == 0);
  CHECK(least_y == 0);
  CHECK(longest < 0.1 * std::sqrt(2.0) + 2e-4);  // and the quantum
  CHECK(longest > 0.1);
}
