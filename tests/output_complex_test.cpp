#include "plumbline/output.hpp"

#include <rapidjson/document.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <pugixml.hpp>

#include "plumbline/arrange.hpp"
#include "plumbline/detail/new_file.hpp"
#include "plumbline/engines/inters.hpp"
#include "plumbline/error.hpp"
#include "plumbline/pipeline.hpp"
#include "plumbline/read.hpp"
#include "plumbline/structure.hpp"
#include "support/segments.hpp"

using namespace plumbline;
namespace fs = std::filesystem;

namespace {

/// An empty directory that goes away with its content.
class Directory {
 public:
  Directory() {
    std::string name = (fs::temp_directory_path() / "plumbline.XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path = name;
  }
  Directory(const Directory&) = delete;
  Directory& operator=(const Directory&) = delete;
  ~Directory() { fs::remove_all(path); }

  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), {}));
  }
  fs::path path;
};

std::string content(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

rapidjson::Document json(const std::string& text) {
  rapidjson::Document document;
  document.Parse(text.c_str());
  REQUIRE_FALSE(document.HasParseError());
  return document;
}

}  // namespace

TEST_CASE("compact JSON is arrays of vertices, edges with their segments, and faces") {
  const SegmentSet input = segments("0 0 1 0  1 0 0 1/3  0 1/3 0 0  0 0 1 0  + 5 5");
  const ExactComplex complex = arrange(input);
  CHECK(to_compact_json(complex, input) ==
        R"({"format":"plumbline compact arrangement 1",)"
        R"("signature":")" +
            signature(complex) +
            R"(","exact":true,)"
            R"("vertices":[["0","0"],["0","1/3"],["1","0"],["5","5"]],)"
            R"("edges":[[0,1,2],[0,2,0,3],[1,2,1]],)"
            R"("faces":[[null,[1,3,-2]],[[-1,2,-3]]],"isolated_vertices":[[0,3]],)"
            R"("files":["text"],"rejected":[],"remarks":[],"ledger":[]})"
            "\n");
}

TEST_CASE("JSON holds exact coordinates as text and their nearest doubles as numbers") {
  const SegmentSet input = segments("0 0 0.1 1/3");
  const auto document = json(to_json(arrange(input), input));
  const auto& head = document["vertices"][1];
  CHECK(std::string(head["exact"][0].GetString()) == "0.1");
  CHECK(std::string(head["exact"][1].GetString()) == "1/3");
  CHECK(head["nearest"][1].GetDouble() == 1.0 / 3);
  CHECK(document["exact"].GetBool());
}

TEST_CASE("in JSON, the cycles of signed edges close and name their face's parent") {
  const SegmentSet input =
      segments(rectangle(0, 0, 9, 9) + rectangle(1, 1, 4, 4) + "9 9 10 10  + 5 5");
  const auto document = json(to_json(arrange(input), input));
  const auto& edges = document["edges"];
  const auto& faces = document["faces"];
  REQUIRE(faces.Size() == 3);
  CHECK(faces[0]["outer"].IsNull());
  for (const auto& face : faces.GetArray()) {
    if (face["outer"].IsNull()) continue;
    const auto& cycle = face["outer"];
    const auto origin = [&](int k) {
      return edges[std::abs(k) - 1][k > 0 ? "tail" : "head"].GetUint();
    };
    const auto target = [&](int k) {
      return edges[std::abs(k) - 1][k > 0 ? "head" : "tail"].GetUint();
    };
    for (rapidjson::SizeType i = 0; i < cycle.Size(); ++i) {
      CHECK(target(cycle[i].GetInt()) == origin(cycle[(i + 1) % cycle.Size()].GetInt()));
    }
  }
  CHECK(std::string(faces[1]["area"].GetString()) == "72");
  CHECK(faces[1]["holes"].Size() == 1);
  CHECK(faces[1]["isolated_vertices"].Size() == 1);
  CHECK(faces[2]["parent"].GetUint() == 1);
  CHECK(faces[2]["depth"].GetUint() == 2);
}

TEST_CASE("JSON lists sources, rejected items and the ledger, whatever bytes their texts hold") {
  SegmentSet input;
  const SourceId source = input.add_source({0, 1, 1, "text", "a\"b\n\xff", ""});
  input.add({{0, 0}, {1, 0}}, source);
  input.add({{0, 0}, {0, 0}}, source);
  input.ledger.push_back({input.sources[0], "rotate(30)", "1e-15 rad"});
  const auto document = json(to_json(arrange(input), input));
  CHECK(std::string(document["sources"][0]["id"].GetString()) == "a\"b\n\xef\xbf\xbd");
  CHECK(document["rejected"].Size() == 1);
  CHECK(std::string(document["ledger"][0]["what"].GetString()) == "rotate(30)");
  CHECK_FALSE(document["exact"].GetBool());
}

TEST_CASE("the SVG picture is well-formed and fills each bounded face once") {
  const SegmentSet input = segments(rectangle(0, 0, 9, 9) + rectangle(1, 1, 4, 4) + "9 9 10 10");
  pugi::xml_document document;
  REQUIRE(document.load_string(to_svg(arrange(input)).c_str()));
  const auto filled = document.select_nodes("//path[contains(@fill-rule, 'evenodd')]").size() +
                      document.select_nodes("//*[contains(@fill-rule, 'evenodd')]/path").size();
  CHECK(filled == 2);
  CHECK(to_svg(arrange(segments(""))).find("<svg") == 0);
}

TEST_CASE("a file is written whole, replacing what was there, leaving nothing else") {
  const Directory directory;
  write_file(directory.path / "a.json", "one");
  write_file(directory.path / "a.json", "two");
  CHECK(content(directory.path / "a.json") == "two");
  CHECK(directory.files() == 1);
}

TEST_CASE("a link stays a link") {
  const Directory directory;
  write_file(directory.path / "target", "one");
  fs::create_symlink("target", directory.path / "link");
  write_file(directory.path / "link", "two");
  CHECK(fs::is_symlink(directory.path / "link"));
  CHECK(content(directory.path / "target") == "two");
}

TEST_CASE("a new file has a temporary of its own until it is committed or given up") {
  const Directory directory;
  const fs::path file = directory.path / "a.json";
  write_file(file, "old");
  {
    NewFile first(file), second(file);
    CHECK(first.temporary() != second.temporary());
    first.write("fir");
    second.write("second");
    first.write("st");
    CHECK(content(file) == "old");
    second.commit();
    CHECK(content(file) == "second");
    first.commit();
    CHECK(content(file) == "first");
    NewFile given_up(file);
    given_up.write("third");
    CHECK(directory.files() == 2);
  }
  CHECK(content(file) == "first");
  CHECK(directory.files() == 1);
}

TEST_CASE("a link to nothing leads to the file that it names, and a loop of links nowhere") {
  const Directory directory;
  fs::create_symlink("target", directory.path / "link");
  write_file(directory.path / "link", "one");
  CHECK(fs::is_symlink(directory.path / "link"));
  CHECK(content(directory.path / "target") == "one");
  fs::create_symlink("loop", directory.path / "loop");
  CHECK_THROWS_AS(write_file(directory.path / "loop", "one"), Error);
  CHECK(directory.files() == 3);
}

TEST_CASE("what is replaced keeps its permissions") {
  const Directory directory;
  write_file(directory.path / "a", "one");
  fs::permissions(directory.path / "a", fs::perms(0640));
  write_file(directory.path / "a", "two");
  CHECK(fs::status(directory.path / "a").permissions() == fs::perms(0640));
}

TEST_CASE("a file that cannot be written is an error, and nothing is left") {
  const Directory directory;
  CHECK_THROWS_AS(write_file(directory.path, "text"), Error);
  CHECK_THROWS_AS(write_file(directory.path / "none" / "a.json", "text"), Error);
  CHECK(directory.files() == 0);
  if (fs::exists("/dev/full")) {
    CHECK_THROWS_AS(write_file("/dev/full", "text"), Error);
    CHECK(fs::is_character_file("/dev/full"));
  }
}

TEST_CASE("a picture of a drawing whose y runs upwards is turned, that of its segments too") {
  plumbline::SegmentSet input;
  input.add_file("a.dxf");
  const auto source = input.add_source({});
  input.add(plumbline::PointD{0, 0}, plumbline::PointD{800, 600}, source);
  CHECK_THAT(to_svg(input), Catch::Contains("M0 0L800 600"));
  const auto complex = plumbline::arrange(input);
  CHECK_THAT(to_svg(complex), Catch::Contains("M0 0L800 600"));
  input.y_up = true;
  CHECK_THAT(to_svg(input), Catch::Contains("M0 0L800 -600"));
  CHECK_THAT(to_svg(complex, input.y_up), Catch::Contains("M0 0L800 -600"));
}

TEST_CASE("pictures of any place and size are read back as the same doubles, without the legend") {
  const auto ends = [](const plumbline::SegmentSet& set) {
    std::vector<std::pair<plumbline::PointD, plumbline::PointD>> result;
    for (const plumbline::Segment& s : set.segments) {
      const plumbline::PointD a = nearest(s.a), b = nearest(s.b);
      result.emplace_back(std::min(a, b), std::max(a, b));
    }
    std::sort(result.begin(), result.end());
    return result;
  };
  const auto read_back = [](const std::string& svg) {
    return evaluate(plumbline::read_svg(svg, "a.svg"));
  };
  for (const double size : {1e-9, 0.003, 0.7, 900.0, 3e7}) {
    for (const double place : {0.0, 8.950123, 377421.47000000003, -5705568.59}) {
      plumbline::SegmentSet input;
      const auto source = input.add_source({});
      const plumbline::PointD low{place, 46.1 - place}, high{place + size, 46.1 - place + size / 3};
      if (low.x == high.x || low.y == high.y) continue;
      input.add(low, {high.x, low.y}, source);
      input.add({high.x, low.y}, high, source);
      input.add(high, low, source);
      CHECK(ends(read_back(to_svg(input))) == ends(input));
      const plumbline::SegmentSet again = read_back(to_svg(plumbline::arrange(input)));
      CHECK(again.labels.empty());
      CHECK(again.segments.size() == 6);  // the face and its edges
    }
  }
}

TEST_CASE("random segments as rows are read back as the same doubles") {
  const std::vector<SegmentD> lines = random_lines(100, 0.1, 3);
  const fs::path file = fs::temp_directory_path() / "plumbline_output_test.lines";
  write_file(file, to_lines(lines));
  CHECK(inters::lines(evaluate(read(file))) == lines);
  fs::remove(file);
  CHECK(to_lines(std::span<const SegmentD>()).empty());
}
