#include <rapidjson/document.h>
#include <rapidjson/schema.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <pugixml.hpp>

#include "plumbline/arrange.hpp"
#include "plumbline/output.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

/// A room with an undershoot of 1/4, a duplicate and two dangles.
struct Example {
  SegmentSet input =
      segments(rectangle(0, 0, 10, 10) + "5 0 5 9.75  0 0 10 0  10 5 12 5  10 6 12 6");
  ExactComplex complex = arrange(input);
  Diagnosis diagnosis(std::size_t most_listed = 1000) const {
    return diagnose(input, complex, {Rational(1, 4), most_listed});
  }
};

rapidjson::Document parsed(const std::string& text) {
  rapidjson::Document document;
  document.Parse(text.c_str());
  REQUIRE(!document.HasParseError());
  return document;
}

bool fits_schema(const rapidjson::Document& document) {
  std::ifstream file(PLUMBLINE_DIAGNOSIS_SCHEMA);
  const rapidjson::Document text =
      parsed(std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()));
  const rapidjson::SchemaDocument schema(text);
  rapidjson::SchemaValidator validator(schema);
  return document.Accept(validator);
}

}  // namespace

TEST_CASE("the JSON fits its schema, which refuses what is no diagnosis") {
  const auto drawing = GENERATE(
      as<std::string>(), "", "+ 1 2  + 1 2.001", "0 0 1 0  0 0 1 0  0.5 0 2 0  1 0.001 3 0.0011",
      "0 0 1e60 1  5 0 5 1e60  0 1 1e60 1", "0 0 9 0  9 0 9 1/300  9 1/300 0 0  4 -2 4 1/299");
  for (const std::optional<Rational>& within :
       {std::optional<Rational>(), std::optional<Rational>(2)}) {
    const SegmentSet input = segments(drawing);
    rapidjson::Document json = parsed(to_json(diagnose(input, arrange(input), {within}), input));
    CHECK(fits_schema(json));
    json["counts"].RemoveMember("bridge");
    CHECK_FALSE(fits_schema(json));
  }
}

TEST_CASE("the text counts what there is, tells what matters most, then lists each kind") {
  const Example example;
  const std::string text = to_text(example.diagnosis(), example.input, 1);
  CHECK(text.substr(0, text.find('\n')) == "4 defects; near means within 0.25; 3 loose ends");
  CHECK(text.find("\n  1 duplicate, 1 undershoot, 2 dangles\n"
                  "what matters most\n"
                  "     2. at (5, 9.75): a line ends 0.25 short of another one, on the boundary of "
                  "a face of "
                  "area 50 that gaps leave open\n"
                  "        text:3:1 text; text:5:1 text\n"
                  "     1. at (5, 0): 2 equal segments of length 10\n") != std::string::npos);
  CHECK(to_text(example.diagnosis(), example.input).find("\nundershoot: 1\n") == std::string::npos);
  CHECK(text.find("\nundershoot: 1\n"
                  "     2. at (5, 9.75): a line ends 0.25 short of another one, on the boundary of "
                  "a face of "
                  "area 50 that gaps leave open\n"
                  "        text:3:1 text\n        text:5:1 text\n") != std::string::npos);
  CHECK(text.find("\ndangle: 2\n     3. at (12, 5): a line of length 2 has a loose end\n"
                  "        text:7:1 text\n      ... and 1 more\n") != std::string::npos);
  CHECK(text.find("  0                   1\n  0.25                2\n") != std::string::npos);
  CHECK(text.find("the shortest edge that is part of no defect is 1 long") != std::string::npos);
}

TEST_CASE("the JSON has exact sizes, cells and sources") {
  const Example example;
  const rapidjson::Document json = parsed(to_json(example.diagnosis(), example.input));
  CHECK(std::string(json["format"].GetString()) == "plumbline diagnosis 1");
  CHECK(std::string(json["within"]["exact"].GetString()) == "0.25");
  CHECK(json["counts"].MemberCount() == kDefectKinds);
  CHECK(json["counts"]["undershoot"].GetUint() == 1);
  CHECK(json["counts"]["near-miss"].GetUint() == 0);
  REQUIRE(json["defects"].Size() == 4);
  const auto& defect = json["defects"][1];
  CHECK(std::string(defect["kind"].GetString()) == "undershoot");
  CHECK(std::string(defect["where"]["exact"][1].GetString()) == "9.75");
  CHECK(std::string(defect["squared_size"]["exact"].GetString()) == "0.0625");
  CHECK(defect["proposed_tolerance"].GetDouble() == 0.25);
  CHECK(defect["area"].IsNull());
  CHECK(defect["face"].IsNull());
  const Point& tip = example.complex.vertices.at(defect["vertices"][0].GetUint());
  CHECK(to_text(tip) == "5 9.75");
  REQUIRE(defect["sources"].Size() == 2);
  CHECK(json["sources"][defect["sources"][1].GetUint()]["line"].GetUint() == 5);
  CHECK(json["defects"][2]["proposed_tolerance"].IsNull());
}

TEST_CASE("the picture has a panel for each kind, with what was left out") {
  const Example example;
  pugi::xml_document svg;
  REQUIRE(svg.load_string(to_svg(example.diagnosis(1), example.input, example.complex).c_str()));
  std::string titles;
  for (const pugi::xml_node& panel : svg.child("svg").children("g")) {
    titles += std::string(panel.child("text").text().get()) + "; ";
  }
  CHECK(titles == "duplicate: 1; undershoot: 1; dangle: 2, of which 1 are marked; ");
  const SegmentSet nothing;
  const ExactComplex empty = arrange(nothing);
  CHECK(svg.load_string(to_svg(diagnose(nothing, empty), nothing, empty).c_str()));
}

TEST_CASE("places have the drawing's own digits, or as many as the search distance asks for") {
  const SegmentSet input = segments(
      "377421.47 5705568.59 377431.47 5705568.59  377421.47000000003 5705568.6 377421.5 5705590"
      "  377440 5705590 377445 5705590  377443 5705591 377447 5705588");
  const auto text = [&](const char* within) {
    const Rational distance = parse_decimal(within);
    return to_text(diagnose(input, arrange(input), {distance}), input, 20);
  };
  CHECK(text("0.02").find("at (377421.47, 5705568.595): two lines end") != std::string::npos);
  CHECK(text("0.001").find("at (377447, 5705588)") != std::string::npos);
  CHECK(text("0").find("at (377421.47, 5705568.59): a line") != std::string::npos);
}

TEST_CASE("a layer of points has the defects with their ranks, then openings") {
  SegmentSet input = segments(rectangle(0, 0, 12, 6) + "6 0 6 2.5  6 3.4 6 6  0 3 5.9 3");
  input.crs = "EPSG:3857";
  const Diagnosis diagnosis = diagnose(input, arrange(input), {Rational(1, 5)});
  const rapidjson::Document json =
      parsed(to_geojson({{defect_layer(diagnosis, input)}, input.crs, ""}));
  CHECK(std::string(json["crs"]["properties"]["name"].GetString()) == "EPSG:3857");
  REQUIRE(json["features"].Size() == diagnosis.defects.size() + 1);
  const auto& opening = json["features"][json["features"].Size() - 1];
  CHECK(std::string(opening["properties"]["kind"].GetString()) == "opening");
  CHECK(opening["properties"]["rank"].IsNull());
  CHECK(opening["geometry"]["coordinates"][1].GetDouble() == 2.95);
  for (rapidjson::SizeType i = 0; i < diagnosis.defects.size(); ++i) {
    const auto& feature = json["features"][i];
    CHECK(feature["id"].GetUint() == i + 1);
    CHECK(feature["properties"]["rank"].GetUint() > 0);
    CHECK(feature["properties"]["exact_x"].GetString() == exact_text(diagnosis.defects[i].where.x));
  }
}

TEST_CASE("a screen of forty lines is enough, however much there is") {
  std::string drawing = rectangle(0, 0, 1000, 1000);
  for (int i = 1; i < 300; ++i) {
    const std::string x = std::to_string(3 * i) + ' ', y = std::to_string(900 + i % 7);
    drawing += x + "0 " + x + "999.5  " + x + "0 " + x + y + "  ";
  }
  const SegmentSet input = segments(drawing);
  const std::string text = to_text(diagnose(input, arrange(input)), input);
  CHECK(std::count(text.begin(), text.end(), '\n') <= 28);
}
