// The published variant against recorded outputs of the original LAR module, in its order. See
// tests/data/README.md.

#include <catch2/catch.hpp>
#include <map>

#include "lar/published/stages.hpp"
#include "plumbline/write.hpp"
#include "support/recorded.hpp"

using namespace plumbline;
using namespace plumbline::lar::published;

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
    errors[member.name.GetString()] = member.value["error"].GetString();
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
        CHECK(failed.failure.error == recorded_case["errors"]["error"].GetString());
      }
      continue;
    }
    CHECK(svg_to_lines(svg, true, vcode) == recorded_lines(recorded_case["lines"]));
    CHECK(svg_to_lines(svg, false, vcode) == recorded_lines(recorded_case["diagonals"]));
  }
}
