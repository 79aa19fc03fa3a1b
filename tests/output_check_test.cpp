#include "plumbline/output.hpp"

#include <rapidjson/document.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <pugixml.hpp>
#include <set>

#include "output/svg/labels.hpp"
#include "output/text/escape.hpp"
#include "plumbline/error.hpp"
#include "support/checks.hpp"

using namespace plumbline;

namespace {

// A name that no text format may take as it is: markup, a quote, a newline, a byte that is no
// UTF-8.
const std::string kEvilName = "<a&\"b\"\n\xFF>.svg";

pugi::xml_document parsed_svg(const std::string& svg) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(svg.data(), svg.size());
  INFO(result.description() << " at byte " << result.offset);
  REQUIRE(result);
  return document;
}

std::multiset<std::string> texts(const pugi::xml_document& svg) {
  std::multiset<std::string> result;
  for (const auto& node : svg.select_nodes("//text")) result.insert(node.node().text().get());
  return result;
}

std::vector<FindingPlace> square_of_places(std::size_t side, double distance) {
  std::vector<FindingPlace> places;
  for (std::size_t i = 0; i < side * side; ++i) {
    places.push_back({{100 + distance * static_cast<double>(i % side),
                       100 + distance * static_cast<double>(i / side)},
                      i + 1});
  }
  return places;
}

}  // namespace

TEST_CASE("the text begins with the verdict and tells counts, exactness and each group") {
  CHECK(to_text(Example().checked()) ==
        R"(disagree: 3 findings in 1 group

                    as authored  over doubles   float LAR
vertices                      4             4           3
edges                         4             4           3
faces                         2             2           2
matched one to one: 3 vertices, 3 edges, 1 faces
radius 0.0625, tolerance 0.125, largest displacement 0
input: 4 segments, 0 points; 0 rejected
exactness: every coordinate is exactly what the file says

   1. 1 face reshaped (by 0.02 of area)
      1 vertex merged, 1 edge merged; at (4, 0)
      text:1:1 text
)");
}

TEST_CASE("the text lists the findings of as many groups as asked for") {
  const std::string text = to_text(Example().checked(), 1);
  CHECK(text.find("      finding 3: face reshaped at (1, 2.005): a face has other edges on its "
                  "outer boundary, because of finding 2\n        text:2:1 text\n") !=
        std::string::npos);
  CHECK(to_text(Example().checked(), 0)
            .find("\n1 more groups (--list 1 prints more, with findings; --report page.html)\n") !=
        std::string::npos);
}

TEST_CASE("an agreement is said in the first line, and there is no list") {
  const std::string text = to_text(Agreement{segments("0 0 1 0  1 0 0 1")}.checked());
  CHECK(text.substr(0, 6) == "agree\n");
  CHECK(text.substr(text.size() - 10) == "file says\n");
}

TEST_CASE("rejected items and replaced numbers are counted in the text") {
  SegmentSet input = segments("0 0 1 0");
  input.rejected = {{{0, 7, 2, "circle", "c", ""}, "curves are not understood", "<circle"}};
  input.ledger = {
      {{}, "rotate(30)", "1e-15 rad"}, {{}, "rotate(31)", "1e-15 rad"}, {{}, "skewX(3)", "1e-9"}};
  const std::string text = to_text(Agreement{input}.checked());
  CHECK(text.find("; 1 rejected: curves are not understood (1)\n") != std::string::npos);
  CHECK(text.find("exactness: 3 numbers were replaced, by at most 1e-15 rad (2), 1e-9 (1)\n") !=
        std::string::npos);
}

TEST_CASE("JSON holds every finding with places, cells, distance and sources") {
  rapidjson::Document json;
  json.Parse(to_json(Example().checked()).c_str());
  REQUIRE(!json.HasParseError());
  CHECK(std::string(json["format"].GetString()) == "plumbline check 3");
  CHECK(std::string(json["verdict"].GetString()) == "disagree");
  CHECK(json["float_valid"].GetBool());
  CHECK(json["exact"].GetBool());
  CHECK(json["tolerance"].GetDouble() == 0.125);
  CHECK(json["counts"]["exact"]["vertices"].GetUint() == 4);
  CHECK(json["counts"]["float"]["vertices"].GetUint() == 3);
  CHECK(json["matched"]["faces"].GetUint() == 1);
  REQUIRE(json["findings"].Size() == 3);
  const auto& finding = json["findings"][0];
  CHECK(finding["number"].GetUint() == 1);
  CHECK(std::string(finding["kind"].GetString()) == "vertex");
  CHECK(std::string(finding["disagreement"].GetString()) == "merged");
  CHECK(std::string(finding["where"]["exact"][0].GetString()) == "4");
  CHECK(finding["where"]["nearest"][0].GetDouble() == 4);
  CHECK(finding["exact_cells"][1].GetUint() == 3);
  CHECK(finding["float_cells"][0].GetUint() == 2);
  CHECK(finding["distance"].GetDouble() == Approx(0.01));
  CHECK(finding["segments"].Size() == 3);
  CHECK(json["sources"][finding["sources"][2].GetUint()]["line"].GetUint() == 3);
  CHECK(json["findings"][2]["distance"].IsNull());
}

TEST_CASE("JSON leads with groups of findings, with what became of faces") {
  rapidjson::Document json;
  json.Parse(to_json(Example().checked()).c_str());
  REQUIRE(json["groups"].Size() == 1);
  const auto& group = json["groups"][0];
  CHECK(std::string(group["message"].GetString()) ==
        "1 face reshaped (by 0.02 of area); 1 vertex merged, 1 edge merged; at (4, 0)");
  CHECK(group["findings"].Size() == 3);
  CHECK(group["lead"].GetUint() == 2);
  CHECK(group["area"].GetDouble() == Approx(0.02));
  CHECK(std::string(group["faces"][0]["change"].GetString()) == "reshaped");
  CHECK(group["faces"][0]["areas"][0].GetDouble() == Approx(8.02));
  CHECK(group["low"][0].GetDouble() == 4);
  CHECK(group["high"][1].GetDouble() == 0.01);
}

TEST_CASE("names from outside break no format") {
  Example example;
  example.input.files[0] = kEvilName;
  rapidjson::Document json;
  json.Parse<rapidjson::kParseValidateEncodingFlag>(to_json(example.checked()).c_str());
  REQUIRE(!json.HasParseError());
  CHECK(std::string(json["files"][0].GetString()) == "<a&\"b\"\n\uFFFD>.svg");
  CHECK(to_text(example.checked()).find("<a&\"b\"\uFFFD\uFFFD>.svg:1:1") != std::string::npos);
  CHECK(texts(parsed_svg(to_svg(example.checked())))
            .count("<a&\"b\"\n\uFFFD>.svg: disagree: 3 findings in 1 group") == 1);
}

TEST_CASE("text that is no UTF-8 is replaced byte by byte, valid text is kept") {
  CHECK(valid_utf8("a\u00E9\u20AC\U0001F600") == "a\u00E9\u20AC\U0001F600");
  CHECK(valid_utf8("\xC0\x80|\xED\xA0\x80|\xE2\x82") ==
        "\uFFFD\uFFFD|\uFFFD\uFFFD\uFFFD|\uFFFD\uFFFD");  // overlong, surrogate, cut off
  CHECK(line_text("a\x1B[31m\x7F\u0085") == "a\uFFFD[31m\uFFFD\uFFFD");
  CHECK(xml_text("\x01<\uFFFE") == "\uFFFD&lt;\uFFFD");
}

TEST_CASE("the picture has two titled panels, and the number of each group in both") {
  const pugi::xml_document svg = parsed_svg(to_svg(Example().checked()));
  CHECK(std::string(svg.child("svg").attribute("width").value()) == "1600");
  const std::multiset<std::string> all = texts(svg);
  CHECK(all.count("exact") == 1);
  CHECK(all.count("float LAR, radius 0.0625") == 1);
  CHECK(all.count("text: disagree: 3 findings in 1 group") == 1);
  CHECK(all.count("V 4   E 4   F 2") == 1);
  CHECK(all.count("1") == 3);  // of the group, and the depth in the legend
}

TEST_CASE("holes are cut out of faces, depths have different colours, antennas are dashed") {
  const Agreement plan{segments(rectangle(0, 0, 9, 9) + rectangle(2, 2, 4, 4) + "6 6 7 7")};
  const pugi::xml_document svg = parsed_svg(to_svg(plan.checked()));
  std::set<std::string> outer_paths, fills;
  for (const auto& node : svg.select_nodes("//g[@fill-rule='evenodd']/path")) {
    const std::string d = node.node().attribute("d").value();
    fills.insert(node.node().attribute("fill").value());
    outer_paths.insert(std::to_string(std::count(d.begin(), d.end(), 'Z')));
  }
  CHECK(fills.size() == 2);
  CHECK(outer_paths == std::set<std::string>{"1", "3"});  // pillar; room with pillar and antenna
  CHECK(svg.select_nodes("//path[@stroke-dasharray][@fill='none']").size() == 2);
}

TEST_CASE("drawings of nothing, of one point and of one line can be pictured") {
  for (const char* text : {"", "+ 1 1", "0 0 5 0", "0 0 0 5"}) {
    const Agreement drawing{segments(text)};
    const std::string svg = to_svg(drawing.checked());
    parsed_svg(svg);
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
  }
}

TEST_CASE("a picture does not depend on the scale of the drawing but for its numbers") {
  const auto marks = [](const std::string& drawing) {
    return to_svg(Agreement{segments(drawing)}.checked());
  };
  CHECK(marks("0 0 1 0  1 0 1 1  1 1 0 0") == marks("0 0 1024 0  1024 0 1024 1024  1024 1024 0 0"));
}

TEST_CASE("sixty findings are all numbered; of more, those whose labels overlap no other") {
  const svg::Box panel{{0, 0}, {800, 800}};
  const auto numbered = [&](const std::vector<FindingPlace>& places) {
    const std::string svg = labelled_rings(places, panel);
    const pugi::xml_document document = parsed_svg("<svg>" + svg + "</svg>");
    CHECK(document.select_nodes("//circle").size() == places.size());
    std::vector<pugi::xml_node> labels;
    for (const auto& node : document.select_nodes("//text")) labels.push_back(node.node());
    return labels.size();
  };
  CHECK(numbered(square_of_places(7, 5)) == 49);
  const std::size_t dense = numbered(square_of_places(30, 5));
  CHECK(dense > 10);
  CHECK(dense < 900);
  CHECK(numbered(square_of_places(9, 75)) == 81);
}

TEST_CASE("the layer of findings has a feature per finding, with its place and the exact one") {
  Check check = Example().checked();
  check.causes.resize(check.comparison.findings.size());
  check.causes[0] = {"prune", 1, "chain collapse", "", "a radius below 0.01", true, {}};
  check.comparison.findings[2].kind = CellKind::Complex;
  rapidjson::Document json;
  json.Parse(to_geojson({{finding_layer(check)}, check.input.crs, ""}).c_str());
  REQUIRE(!json.HasParseError());
  CHECK(std::string(json["type"].GetString()) == "FeatureCollection");
  CHECK(!json.HasMember("crs"));
  check.input.crs = "EPSG:3857";
  rapidjson::Document placed;
  placed.Parse(to_geojson({{finding_layer(check)}, check.input.crs, ""}).c_str());
  CHECK(std::string(placed["crs"]["properties"]["name"].GetString()) == "EPSG:3857");
  REQUIRE(json["features"].Size() == 3);
  const auto& feature = json["features"][0];
  CHECK(std::string(feature["type"].GetString()) == "Feature");
  CHECK(feature["id"].GetUint() == 1);
  CHECK(std::string(feature["geometry"]["type"].GetString()) == "Point");
  CHECK(feature["geometry"]["coordinates"].Size() == 2);
  CHECK(feature["geometry"]["coordinates"][0].GetDouble() == 4);
  const auto& properties = feature["properties"];
  CHECK(std::string(properties["kind"].GetString()) == "vertex");
  CHECK(std::string(properties["disagreement"].GetString()) == "merged");
  CHECK(properties["invariant"].IsNull());
  CHECK(std::string(properties["stage"].GetString()) == "prune");
  CHECK(std::string(properties["rule"].GetString()) == "chain collapse");
  CHECK(properties["distance"].GetDouble() == Approx(0.01));
  CHECK(std::string(properties["exact_x"].GetString()) == "4");
  CHECK(std::string(properties["sources"].GetString()) ==
        "text:1:1 text; text:2:1 text; text:3:1 text");
  CHECK(json["features"][1]["properties"]["stage"].IsNull());
  CHECK(json["features"][2]["geometry"].IsNull());
}
