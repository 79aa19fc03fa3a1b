#include "plumbline/read.hpp"

#include <zlib.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <random>
#include <sstream>

#include "plumbline/error.hpp"
#include "read/gzip.hpp"
#include "read/streams.hpp"
#include "support/listing.hpp"

using plumbline::evaluate;
using plumbline::read;
using plumbline::read_lines;

namespace fs = std::filesystem;

namespace {

/// A folder that is removed with all that is in it.
class Scratch {
 public:
  Scratch() : folder_(fs::temp_directory_path() / ("plumbline-read-" + unique())) {
    fs::create_directories(folder_);
  }
  ~Scratch() { fs::remove_all(folder_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  fs::path file(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }
  const fs::path& folder() const { return folder_; }

 private:
  static std::string unique() { return std::to_string(Catch::rngSeed()) + "-" + name_of_process(); }
  static std::string name_of_process() { return fs::read_symlink("/proc/self").string(); }

  fs::path folder_;
};

plumbline::Error error_of(const fs::path& file) {
  try {
    read(file);
  } catch (const plumbline::Error& error) {
    return error;
  }
  throw std::logic_error("accepted: " + file.string());
}

/// As gzip writes it.
std::string gzipped(const std::string& text) {
  std::string packed(compressBound(text.size()) + 32, '\0');
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

}  // namespace

TEST_CASE("rows of numbers are segments, whatever the line ends and blanks") {
  CHECK(listing(read_lines("0,0,1,0.1\r\n\r\n  1e1 ,\t.5,-3 , 1/3  \n   \n5,5,6,6", "a.lines")) ==
        "0 0, 1 0.1 | a.lines:1:1 row\n"
        "10 0.5, -3 1/3 | a.lines:3:3 row\n"
        "5 5, 6 6 | a.lines:5:1 row\n");
  CHECK(listing(read_lines("\xEF\xBB\xBF"
                           "1,2,3,4\n",
                           "a.lines")) == "1 2, 3 4 | a.lines:1:1 row\n");
  CHECK(listing(read_lines("", "a.lines")).empty());
}

TEST_CASE("a row that is not a segment is rejected with its line, the others are kept") {
  CHECK(listing(read_lines("# walls\n1,2,3\n1,2,3,4\n1,2,3,4,5\n1,,3,4\n1,2,3,x\n1 2 3 4\n"
                           "1,2,1.0,2\n\x01,\xff,\t0,0\n1,2,3,1e77777\n1,2,3,4,\n",
                           "a.lines")) ==
        "1 2, 3 4 | a.lines:3:1 row\n"
        "rejected:\n"
        "a.lines:1:1 row: not a number: # walls\n"
        "a.lines:2:1 row: row of 3 values, not 4: 1,2,3\n"
        "a.lines:4:1 row: row of 5 values, not 4: 1,2,3,4,5\n"
        "a.lines:5:1 row: not a number: 1,,3,4\n"
        "a.lines:6:1 row: not a number: 1,2,3,x\n"
        "a.lines:7:1 row: not a number: 1 2 3 4\n"
        "a.lines:9:1 row: not a number: ?,?, 0,0\n"
        "a.lines:10:1 row: decimal exponent beyond 10000: 1,2,3,1e77777\n"
        "a.lines:11:1 row: row of 5 values, not 4: 1,2,3,4,\n"
        "a.lines:8:1 row: zero-length segment: 1 2, 1 2\n");
}

TEST_CASE("a row with blanks between its numbers is read as the one without") {
  std::mt19937 random(8);
  const std::string letters = "0123456789.-+e/x,";
  std::size_t accepted = 0;
  for (int i = 0; i < 10'000; ++i) {
    std::string row;
    const std::size_t fields = random() % 8 == 0 ? random() % 6 : 4;
    for (std::size_t field = 0; field < fields; ++field) {
      if (field > 0) row += ',';
      const std::size_t length = random() % 40 == 0 ? random() % 25 : 1 + random() % 6;
      for (std::size_t k = 0; k < length; ++k) row += letters[random() % (k == 0 ? 13 : 11)];
    }
    if (random() % 4 == 0 && !row.empty()) row[random() % row.size()] = letters[random() % 17];
    std::string spaced;
    for (const char c : row) spaced += c == ',' ? " , " : std::string(1, c);
    const auto set = evaluate(read_lines(row, "a.lines"));
    const auto expected = evaluate(read_lines(spaced, "a.lines"));
    CAPTURE(row);
    REQUIRE(set.segments == expected.segments);
    REQUIRE(set.sources.size() == expected.sources.size());
    REQUIRE(set.rejected.size() == expected.rejected.size());
    for (std::size_t k = 0; k < set.rejected.size(); ++k) {
      REQUIRE(set.rejected[k].reason == expected.rejected[k].reason);
    }
    accepted += set.segments.size();
  }
  CHECK(accepted > 1'000);
  CHECK(accepted < 9'000);
}

TEST_CASE("a file is read by its ending, in either case") {
  const Scratch scratch;
  CHECK(evaluate(read(scratch.file("a.SVG", "<svg><line x2='1'/></svg>"))).segments.size() == 1);
  CHECK(evaluate(read(scratch.file("a.Lines", "0,0,1,1"))).segments.size() == 1);
  for (const auto& [name, content] :
       {std::pair("a.CSV", "0,0,1,1\n"), std::pair("a.wkt", "LINESTRING (0 0, 1 1)"),
        std::pair("a.wkb", "000000000200000000"),
        std::pair("a.GeoJSON", R"({"type": "MultiPoint", "coordinates": []})")}) {
    CHECK_NOTHROW(evaluate(read(scratch.file(name, content))));
  }
  const auto error = error_of(scratch.file("a.dwg", ""));
  CHECK(error.code() == plumbline::ErrorCode::BadInput);
  CHECK(error.message().starts_with("unknown file name ending; known are .svg .svgz .dxf .lines "));
  CHECK(error.offending_text() == ".dwg");
  plumbline::ReadOptions options;
  options.format = "lines";
  CHECK(segments_of(evaluate(read(scratch.file("a.dwg", "0,0,1,1"), options))) == "0 0, 1 1\n");
  options.format = "dwg";
  CHECK_THROWS_AS(read(scratch.file("a.lines", "0,0,1,1"), options), plumbline::Error);
}

TEST_CASE("a file without ending is read by its first bytes") {
  const Scratch scratch;
  const std::string row = "0 0, 1 1\n";
  for (const std::string content :
       {"\n<?xml version='1.0'?><svg><line x2='1' y2='1'/></svg>",
        "\xEF\xBB\xBF<svg><line x2='1' y2='1'/></svg>", "0,0,1,1\n", "x1,y1,x2,y2\n0,0,1,1\n",
        "name;wkt\na;LINESTRING (0 0, 1 1)\n", "# a comment\nSRID=3;LineString(0 0, 1 1)",
        "[[[0,0],[1,1]]]", R"({"type": "LineString", "coordinates": [[0, 0], [1, 1]]})",
        "  0\nSECTION\n  2\nENTITIES\n  0\nLINE\n 10\n0\n 20\n0\n 11\n1\n 21\n1\n  0\nENDSEC\n  "
        "0\nEOF\n",
        "0102000000020000000000000000000000000000000000000000000000000"
        "0F03F000000000000F03F\n"}) {
    CAPTURE(content);
    CHECK(segments_of(evaluate(read(scratch.file("drawing", content)))) == row);
  }
  CHECK(segments_of(evaluate(
            read(scratch.file("drawing", gzipped("<svg><line x2='1' y2='1'/></svg>"))))) == row);
  for (const std::string content : {"text\n", "1,2,3\n", "POINTS\n", "0x\n"}) {
    CAPTURE(content);
    CHECK(error_of(scratch.file("drawing", content)).message().find("tell no format") !=
          std::string::npos);
  }
}

TEST_CASE("formats are read up to the number of segments that is allowed, and no further") {
  const Scratch scratch;
  plumbline::ReadOptions options;
  for (const auto& [name, content] :
       {std::pair("a.wkt", "LINESTRING (0 0, 1 1, 2 0, 3 0)"),
        std::pair("a.csv", "0,0,1,1\n1,1,2,0\n2,0,3,0\n"),
        std::pair("a.geojson",
                  R"({"type": "LineString", "coordinates": [[0, 0], [1, 1], [2, 0], [3, 0]]})"),
        std::pair("a.json",
                  R"({"V": [[0, 0], [1, 1], [2, 0]], "EV": [[0, 1], [1, 2], [2, 0]]})")}) {
    const fs::path file = scratch.file(name, content);
    options.max_segments = 3;
    CHECK(evaluate(read(file, options)).segments.size() == 3);
    options.max_segments = 2;
    CHECK_THROWS_WITH(read(file, options), "more than 2 segments");
  }
  // Curves, too: a circle has at least 4 chords.
  const fs::path circle = scratch.file("a.svg", "<svg><circle r='1'/></svg>");
  CHECK_THROWS_WITH(read(circle, options), Catch::Contains("too many chords"));
}

TEST_CASE("a file without a size is read to its end, and one that fails is an error") {
  if (!fs::exists("/proc/self/mem")) return;  // not Linux
  const Scratch scratch;
  fs::create_symlink("/proc/self/status", scratch.folder() / "a.lines");
  CHECK(evaluate(read(scratch.folder() / "a.lines")).rejected.size() > 10);
  fs::create_symlink("/proc/self/mem", scratch.folder() / "b.lines");
  CHECK(error_of(scratch.folder() / "b.lines").message() == "cannot be read");
}

TEST_CASE("a JSON file is read by what its members tell, wherever they stand") {
  const Scratch scratch;
  const auto segments = [&](const std::string& content) {
    return segments_of(evaluate(read(scratch.file("a.json", content))));
  };
  const std::string line = "[[1, 2], [3, 4]]";
  CHECK(segments(R"({"coordinates": )" + line + R"(, "type": "LineString"})") == "1 2, 3 4\n");
  CHECK(segments(R"({"bbox": [1, {"V": 2}], "type": "LineString", "coordinates": )" + line + "}") ==
        "1 2, 3 4\n");
  CHECK(segments(R"({"EV": [[1, 0]], "V": )" + line + "}") == "3 4, 1 2\n");
  CHECK(segments(R"({"format": "LAR", "lines": [)" + line + "]}") == "1 2, 3 4\n");
  CHECK(segments("[" + line + ", [[0, 1]]]") == "1 2, 3 4\n");
  const auto message = [&](const std::string& content) {
    return std::string(error_of(scratch.file("b.json", content)).message());
  };
  CHECK(message(R"({"name": {"type": "Feature"}})").starts_with("JSON of no known format"));
  CHECK(message(R"({"version": 1, "stories": []})") ==
        "JSON of a format that is not read: floorspace.js");
  CHECK(message(R"({"type": "Topology", "arcs": []})") ==
        "JSON of a format that is not read: TopoJSON");
  CHECK(message("").starts_with("not JSON"));
}

TEST_CASE("a file is read as its text is, wherever its blocks end") {
  std::string rows = "id;geom\n";
  for (int i = 0; i < 20'000; ++i) {
    rows += std::to_string(i) + ";\"LINESTRING (" + std::to_string(i) + " 0.125,\n1 2)\"\n";
  }
  const Scratch scratch;
  const fs::path file = scratch.file("a.csv", rows);
  CHECK(read(file) == plumbline::read_csv(rows, file.string()));
  for (const std::size_t block_size : {1, 2, 7, 64}) {
    const std::string text = "\xEF\xBB\xBF" + rows.substr(0, 1'000 + block_size) + "0 0)\"";
    plumbline::ByteStream bytes(std::make_unique<std::istringstream>(text), "a", block_size);
    CHECK(plumbline::read_csv(bytes) == plumbline::read_csv(text, "a"));
  }
}

TEST_CASE("a file that can't be read is refused, saying why") {
  const Scratch scratch;
  const auto missing = error_of(scratch.folder() / "missing.svg");
  CHECK(missing.code() == plumbline::ErrorCode::BadFile);
  CHECK(missing.message() == "no such file");
  CHECK(missing.place().file == (scratch.folder() / "missing.svg").string());
  CHECK(error_of(scratch.folder()).message() == "is a directory");
  CHECK(error_of("/dev/zero").message() == "is not a regular file");
  const fs::path below_a_file = scratch.file("a.svg", "<svg/>") / "b.svg";
  CHECK(error_of(below_a_file).code() == plumbline::ErrorCode::BadFile);
}

TEST_CASE("a compressed SVG file is read, a damaged one refused, and one that grows too much") {
  const Scratch scratch;
  std::string packed = gzipped("<svg><line x2='1'/></svg>");
  CHECK(segments_of(evaluate(read(scratch.file("a.svgz", packed)))) == "0 0, 1 0\n");
  CHECK(segments_of(evaluate(read(scratch.file("plain.svgz", "<svg><line x2='2'/></svg>")))) ==
        "0 0, 2 0\n");
  const std::string halves = gzipped("<svg><line ") + gzipped("x2='3'/></svg>");
  CHECK(segments_of(evaluate(read(scratch.file("halves.svgz", halves)))) == "0 0, 3 0\n");
  const auto cut = error_of(scratch.file("cut.svgz", packed.substr(0, packed.size() - 9)));
  CHECK(cut.message() == "malformed gzip: ends too early");
  CHECK(cut.place().file == (scratch.folder() / "cut.svgz").string());
  packed[packed.size() - 5] = static_cast<char>(packed[packed.size() - 5] + 1);
  CHECK(error_of(scratch.file("sum.svgz", packed)).message() ==
        "malformed gzip: incorrect data check");
  CHECK(error_of(scratch.file("more.svgz", halves + "more")).code() ==
        plumbline::ErrorCode::BadInput);
  try {
    plumbline::inflated(gzipped(std::string(100'001, ' ')), "a.svgz", 100'000);
    FAIL("no error");
  } catch (const plumbline::Error& error) {
    CHECK(error.code() == plumbline::ErrorCode::Limit);
  }
}

TEST_CASE("a file beyond the size limit is refused without being read") {
  const Scratch scratch;
  const fs::path sparse = scratch.file("sparse.svg", "");
  fs::resize_file(sparse, plumbline::kMaxFileSize + 1);
  CHECK(error_of(sparse).code() == plumbline::ErrorCode::Limit);
}

TEST_CASE("the example drawings are read whole") {
  // Counts of the data's own index, made by another program (examples/data/README.md).
  const auto [name, segments, rejected] = GENERATE(table<std::string, std::size_t, std::string>({
      {"hospital-emergency.svg", 639, ""},
      {"hospital-ward.svg", 760, ""},
      {"dwelling.svg", 9, ""},
      {"office-plan.svg", 177, "image: element image is not understood yet"},
      {"building.svg", 652, ""},
  }));
  const auto set = evaluate(read(fs::path(PLUMBLINE_EXAMPLES) / name));
  CHECK(set.segments.size() == segments);
  CHECK(set.ledger.empty());
  std::string refused;
  for (const auto& item : set.rejected) refused += item.source.element + ": " + item.reason;
  CHECK(refused == rejected);
}
