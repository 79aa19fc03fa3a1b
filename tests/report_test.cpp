#include "plumbline/report.hpp"

#include <rapidjson/document.h>
#include <zlib.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <pugixml.hpp>
#include <set>

#include "plumbline/arrange.hpp"
#include "report/finding_labels.hpp"
#include "report/page_arrays.hpp"
#include "support/segments.hpp"
#include "write/escape.hpp"

using namespace plumbline;

namespace {

/// A quadrangle with a side of 1/100, and the triangle that is left when the side collapses.
struct Example {
  SegmentSet input = segments("0 0 4 0  4 0 4 0.01  4 0.01 0 4  0 4 0 0");
  ExactComplex exact_complex = arrange(input);
  FloatComplex float_complex = nearest(arrange(segments("0 0 4 0  4 0 0 4  0 4 0 0")));
  Crosscheck crosscheck = plumbline::crosscheck(exact_complex, float_complex, 0.125);

  Check checked() const {
    Check result;
    result.input = input;
    result.exact_complex = exact_complex;
    result.float_complex = float_complex;
    result.radius = 0.0625;
    result.crosscheck = crosscheck;
    result.conversion = plumbline::crosscheck(exact_complex, exact_complex, 0);
    return result;
  }
};

/// A drawing held against its own nearest doubles.
struct Agreement {
  SegmentSet input;
  ExactComplex exact_complex = arrange(input);
  FloatComplex float_complex = nearest(exact_complex);
  Crosscheck crosscheck = plumbline::crosscheck(exact_complex, float_complex, 0.125);

  Check checked() const {
    Check result;
    result.input = input;
    result.exact_complex = exact_complex;
    result.float_complex = float_complex;
    result.radius = 0.0625;
    result.crosscheck = crosscheck;
    result.conversion = plumbline::crosscheck(exact_complex, exact_complex, 0);
    return result;
  }
};

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

/// What stands between the first `begin` of the page and the next `end`.
std::string between(const std::string& page, const std::string& begin, const std::string& end) {
  const std::size_t from = page.find(begin);
  REQUIRE(from != std::string::npos);
  const std::size_t to = page.find(end, from + begin.size());
  REQUIRE(to != std::string::npos);
  return page.substr(from + begin.size(), to - from - begin.size());
}

/// What `packed` packed.
std::string unpacked(const std::string& text) {
  std::string bytes;
  std::uint32_t bits = 0;
  unsigned count = 0;
  static const std::string digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (const char c : text.substr(0, text.find('='))) {
    bits = bits << 6U | static_cast<std::uint32_t>(digits.find(c));
    if ((count += 6) < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255U);
  }
  std::string result(1 << 20, '\0');
  uLongf size = result.size();
  REQUIRE(uncompress(reinterpret_cast<Bytef*>(result.data()), &size,
                     reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) == Z_OK);
  result.resize(size);
  return result;
}

std::string page_json(const std::string& page) {
  return unpacked(between(page, "<script type=\"text/plain\" id=\"report\">", "</script>"));
}

std::multiset<std::string> texts(const pugi::xml_document& svg) {
  std::multiset<std::string> result;
  for (const auto& node : svg.select_nodes("//text")) result.insert(node.node().text().get());
  return result;
}

std::vector<FindingPlace> square_of_places(std::size_t side, double distance) {
  std::vector<FindingPlace> places;
  for (std::size_t i = 0; i < side * side; ++i)
    places.push_back({{100 + distance * static_cast<double>(i % side),
                       100 + distance * static_cast<double>(i / side)},
                      i + 1});
  return places;
}

}  // namespace

TEST_CASE("the text begins with the verdict and tells counts, exactness and each finding") {
  CHECK(report_text(Example().checked()) ==
        R"(disagree: 3 findings

                    as authored  over doubles   float LAR
vertices                      4             4           3
edges                         4             4           3
faces                         2             2           2
holes                         0             0           0
isolated vertices             0             0           0
components                    1             1           1
antennas                      0             0           0
depth                         1             1           1
(faces with the unbounded one, holes of bounded faces)
matched one to one: 3 vertices, 3 edges, 1 faces
radius 0.0625, tolerance 0.125, largest displacement 0
input: 4 segments, 0 points; 0 rejected
exactness: every coordinate is exactly what the file says

   1. vertex merged at (4, 0): two exact vertices 0.01 apart became one float vertex
      text:1:1 text
      text:2:1 text
      text:3:1 text
   2. edge merged at (4, 0): one exact edge no longer than 0.01 collapsed into one float vertex
      text:1:1 text
      text:2:1 text
   3. face reshaped at (1, 2.005): a face has other edges on its outer boundary, because of finding 2
      text:2:1 text
)");
}

TEST_CASE("the text shows as many findings as asked for and says how many more there are") {
  const std::string text = report_text(Example().checked(), 1);
  CHECK(text.find("   1. ") != std::string::npos);
  CHECK(text.find("   2. ") == std::string::npos);
  CHECK(text.find("\n... and 2 more (see -o report.json)\n") != std::string::npos);
}

TEST_CASE("an agreement is said in the first line, and there is no list") {
  const std::string text = report_text(Agreement{segments("0 0 1 0  1 0 0 1")}.checked());
  CHECK(text.substr(0, 6) == "agree\n");
  CHECK(text.substr(text.size() - 10) == "file says\n");
}

TEST_CASE("rejected items and replaced numbers are counted in the text") {
  SegmentSet input = segments("0 0 1 0");
  input.rejected = {{{0, 7, 2, "circle", "c", ""}, "curves are not understood", "<circle"}};
  input.ledger = {
      {{}, "rotate(30)", "1e-15 rad"}, {{}, "rotate(31)", "1e-15 rad"}, {{}, "skewX(3)", "1e-9"}};
  const std::string text = report_text(Agreement{input}.checked());
  CHECK(text.find("; 1 rejected\n  rejected text:7:2 circle #c: curves are not understood\n") !=
        std::string::npos);
  CHECK(text.find("exactness: 3 numbers were replaced, by at most 1e-15 rad (2), 1e-9 (1)\n") !=
        std::string::npos);
}

TEST_CASE("JSON holds every finding with places, cells, distance and sources") {
  rapidjson::Document json;
  json.Parse(report_json(Example().checked()).c_str());
  REQUIRE(!json.HasParseError());
  CHECK(std::string(json["format"].GetString()) == "plumbline check 1");
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

TEST_CASE("names from outside break no format") {
  Example example;
  example.input.files[0] = kEvilName;
  rapidjson::Document json;
  json.Parse<rapidjson::kParseValidateEncodingFlag>(report_json(example.checked()).c_str());
  REQUIRE(!json.HasParseError());
  CHECK(std::string(json["files"][0].GetString()) == "<a&\"b\"\n\uFFFD>.svg");
  CHECK(report_text(example.checked()).find("<a&\"b\"\uFFFD\uFFFD>.svg:1:1") != std::string::npos);
  CHECK(texts(parsed_svg(report_svg(example.checked())))
            .count("<a&\"b\"\n\uFFFD>.svg: disagree: 3 findings") == 1);
}

TEST_CASE("text that is no UTF-8 is replaced byte by byte, valid text is kept") {
  CHECK(valid_utf8("a\u00E9\u20AC\U0001F600") == "a\u00E9\u20AC\U0001F600");
  CHECK(valid_utf8("\xC0\x80|\xED\xA0\x80|\xE2\x82") ==
        "\uFFFD\uFFFD|\uFFFD\uFFFD\uFFFD|\uFFFD\uFFFD");  // overlong, surrogate, cut off
  CHECK(line_text("a\x1B[31m\x7F\u0085") == "a\uFFFD[31m\uFFFD\uFFFD");
  CHECK(xml_text("\x01<\uFFFE") == "\uFFFD&lt;\uFFFD");
}

TEST_CASE("the picture has two titled panels, and a number at each place in both") {
  const pugi::xml_document svg = parsed_svg(report_svg(Example().checked()));
  CHECK(std::string(svg.child("svg").attribute("width").value()) == "1600");
  const std::multiset<std::string> all = texts(svg);
  CHECK(all.count("exact") == 1);
  CHECK(all.count("float LAR, radius 0.0625") == 1);
  CHECK(all.count("text: disagree: 3 findings") == 1);
  CHECK(all.count("V 4   E 4   F 2") == 1);
  CHECK(all.count("1, 2") == 2);
  CHECK(all.count("3") == 2);
}

TEST_CASE("holes are cut out of faces, depths have different colours, antennas are dashed") {
  const Agreement plan{segments(rectangle(0, 0, 9, 9) + rectangle(2, 2, 4, 4) + "6 6 7 7")};
  const pugi::xml_document svg = parsed_svg(report_svg(plan.checked()));
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
    const std::string svg = report_svg(drawing.checked());
    parsed_svg(svg);
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
  }
}

TEST_CASE("a picture does not depend on the scale of the drawing but for its numbers") {
  const auto marks = [](const std::string& drawing) {
    return report_svg(Agreement{segments(drawing)}.checked());
  };
  CHECK(marks("0 0 1 0  1 0 1 1  1 1 0 0") == marks("0 0 1024 0  1024 0 1024 1024  1024 1024 0 0"));
}

TEST_CASE("sixty findings are all numbered; of more, those whose labels overlap no other") {
  const picture::Box panel{{0, 0}, {800, 800}};
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
  check.crosscheck.findings[0].cause =
      Cause{Stage::Prune, 1, "chain collapse", "", "a radius below 0.01", true, {}};
  check.crosscheck.findings[2].kind = CellKind::Complex;
  rapidjson::Document json;
  json.Parse(report_geojson(check).c_str());
  REQUIRE(!json.HasParseError());
  CHECK(std::string(json["type"].GetString()) == "FeatureCollection");
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

TEST_CASE("base64 is as in RFC 4648, section 10") {
  CHECK(base64("").empty());
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xFB\xFF") == "+/8=");
}

TEST_CASE("the page holds the JSON report's findings and counts, and names its arrays") {
  const Check check = Example().checked();
  rapidjson::Document page, report;
  page.Parse(page_json(report_html(check)).c_str());
  report.Parse(report_json(check).c_str());
  REQUIRE(!page.HasParseError());
  CHECK(page["findings"] == report["findings"]);
  CHECK(page["counts"] == report["counts"]);
  CHECK(page["files"] == report["files"]);
  CHECK(!page.HasMember("segments"));
  std::map<std::string, unsigned> counts;
  for (const auto& array : page["page"]["arrays"].GetArray())
    counts[array["name"].GetString()] = array["count"].GetUint();
  CHECK(counts.at("authored.x") == 4);
  CHECK(counts.at("authored.tail") == 4);
  CHECK(counts.at("authored.cycles") == 8);
  CHECK(counts.at("float.x") == 3);
  CHECK(counts.at("float.area") == 2);
  CHECK(counts.at("segment_source") == 4);
  CHECK(std::string(page["page"]["exact_areas"][1].GetString()) == "8.02");
}

TEST_CASE("a complex with the incidences of the one as authored is not stored twice") {
  rapidjson::Document page;
  page.Parse(
      page_json(report_html(Agreement{segments("0 0 1 0  1 0 0 1  0 1 0 0")}.checked())).c_str());
  const auto& same = page["page"]["same_incidences"];
  CHECK(std::string(same[same.Size() - 1].GetString()) == "float");
  for (const auto& array : page["page"]["arrays"].GetArray())
    CHECK(std::string(array["name"].GetString()) != "float.tail");
}

TEST_CASE("names from outside are no markup and no script in the page") {
  Example example;
  const std::string evil = "</script><script>alert(1)</script><!--<script>]]>&\"'\xFF";
  example.input.files[0] = evil;
  example.input.sources = {};
  for (std::uint32_t line = 1; line <= 4; ++line)
    example.input.sources.push_back({0, line, 1, evil, evil, evil});
  example.input.rejected = {{{0, 7, 2, evil, evil, evil}, evil, evil}};
  example.input.ledger = {{{0, 7, 2, evil, evil, evil}, evil, evil}};
  Check check = example.checked();
  check.result = evil;
  check.crosscheck.findings[0].message = evil;
  check.crosscheck.findings[0].cause = Cause{Stage::Prune, 1, evil, evil, evil, true, {}};
  const std::string page = report_html(check), plain = report_html(Example().checked());
  const auto occurrences = [](const std::string& text, const std::string& word) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
      ++count;
    return count;
  };
  for (const char* word : {"<script", "</script", "<!--", "alert(1)</"}) {
    INFO(word);
    CHECK(occurrences(page, word) == occurrences(plain, word));
  }
  rapidjson::Document json;
  json.Parse<rapidjson::kParseValidateEncodingFlag>(page_json(page).c_str());
  REQUIRE(!json.HasParseError());
  const std::string kept = evil.substr(0, evil.size() - 1) + "\uFFFD";
  CHECK(json["files"][0].GetString() == kept);
  CHECK(json["page"]["kinds"][0]["element"].GetString() == kept);
  CHECK(json["findings"][0]["message"].GetString() == kept);
}

TEST_CASE("the page loads nothing: its policy forbids it, and nothing asks for it") {
  const std::string page = report_html(Example().checked());
  CHECK(page.find("default-src 'none'") != std::string::npos);
  for (const char* word : {" src=", "href=", "@import", "url(", "fetch(", "XMLHttpRequest",
                           "WebSocket", "import(", "sendBeacon"}) {
    INFO(word);
    CHECK(page.find(word) == std::string::npos);
  }
  for (std::size_t at = page.find("://"); at != std::string::npos; at = page.find("://", at + 1)) {
    const std::string address = page.substr(at, 30);
    INFO(address);
    const bool is_name = address.find("://www.w3.org/") == 0;    // of an XML namespace
    const bool is_notice = address.find("://github.com/") == 0;  // in licence notices
    CHECK((is_name || is_notice));
  }
}

TEST_CASE("drawings of nothing and of one point have a page") {
  for (const char* text : {"", "+ 1 1", "0 0 5 0"}) {
    rapidjson::Document json;
    json.Parse(page_json(report_html(Agreement{segments(text)}.checked())).c_str());
    CHECK(!json.HasParseError());
  }
}
