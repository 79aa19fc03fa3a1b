#include <catch2/catch.hpp>

#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "support/listing.hpp"

using plumbline::evaluate;
using plumbline::listing;
using plumbline::read_lar_json;
using plumbline::segments_of;

namespace {

std::string listed(const std::string& text) { return listing(read_lar_json(text, "a.json")); }
std::string segments(const std::string& text) {
  return segments_of(evaluate(read_lar_json(text, "a")));
}

std::string error_of(const std::string& text) {
  try {
    read_lar_json(text, "a");
  } catch (const plumbline::Error& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("EV are pairs of indices into V, wherever V stands") {
  const std::string drawn = "0 0, 0.1 1 | a.json:1:9 EV\n2 2, 0 0 | a.json:2:1 EV\n";
  CHECK(
      listed(
          "{\"EV\": [[0, 1],\n[2, 0]], \"V\": [[0, 0], [0.1, 1], [2, 2]], \"FV\": [[0, 1, 2]]}") ==
      drawn);
  CHECK(
      listed("{\"EV\": [[1, 2],\n[3, 1]], \"V\": [[0, 0], [0.1, 1], [2, 2]], \"index_base\": 1}") ==
      drawn);
}

TEST_CASE("LAR's pairs and triples of lists are models") {
  const std::string v = "[[[0, 0], [4, 0], [4, 4], [0, 4]], ";
  CHECK(segments(v + "[[0, 1], [2, 3]]]") == "0 0, 4 0\n4 4, 0 4\n");
  CHECK(segments(v + "[[0, 1, 2, 3]], [[0, 1]]]") == "0 0, 4 0\n");
  CHECK(segments(v + "[[0, 1, 2]]]") == "0 0, 4 0\n0 0, 4 4\n4 0, 4 4\n");
  CHECK(segments(v + "[[0, 3], [0, 1, 2]]]") == "0 0, 0 4\n0 0, 4 0\n0 0, 4 4\n4 0, 4 4\n");
}

TEST_CASE("lines are pairs of points") {
  CHECK(listed("{\"lines\": [[[0, 0.5], [1e1, 2]],\n [[3, 3], [4, 4]]]}") ==
        "0 0.5, 10 2 | a.json:1:12 line\n3 3, 4 4 | a.json:2:2 line\n");
}

TEST_CASE("faces without edges are a LAR model, which draws what `edges` finds") {
  const std::string v =
      R"({"V": [[0, 0], [4, 0], [0, 4], [4, 4], [1, 1]], "index_base": 1, "FV": )";
  // LAR's cuboids list their corners row by row, which is no cycle but has one hull.
  CHECK(listed(v + "[[1, 2, 3, 4]]}") ==
        "0 0, 4 0 | a.json:1:73 FV\n0 0, 0 4 | a.json:1:73 FV\n4 0, 4 4 | a.json:1:73 FV\n"
        "0 4, 4 4 | a.json:1:73 FV\nrejected:\na.json V: isolated points are not drawn: 1 point\n");
  const auto structure = read_lar_json(v + "[[2, 3, 5]]}", "a.json");
  const auto& model = std::get<plumbline::LarModel>(structure.structs[0].body[0]);
  CHECK(model.vertex_count() == 5);
  CHECK(std::vector(model.cells[0][0].begin(), model.cells[0][0].end()) ==
        std::vector<std::uint32_t>{1, 2, 4});
}

TEST_CASE("a bare list of segments is read, however many they are") {
  const std::string a = "[[0,0],[1,0]]", b = "[[1,0],[1,1]]", c = "[[1,1],[0,0.5]]";
  CHECK(listed("[" + a + "]") == "0 0, 1 0 | a.json:1:2 line\n");
  CHECK(listed("[" + a + "," + b + "]") ==
        "0 0, 1 0 | a.json:1:2 line\n1 0, 1 1 | a.json:1:16 line\n");
  CHECK(listed("[" + a + "," + b + "," + c + "]") ==
        "0 0, 1 0 | a.json:1:2 line\n1 0, 1 1 | a.json:1:16 line\n1 1, 0 0.5 | a.json:1:30 line\n");
  CHECK(listed("[[[0,0],[1,0]],[[1,0],[0,1]],[[0,1],[1,0]]]").starts_with("0 0, 1 0 | a.json:1:2"));
  CHECK(listed("[" + a + "," + a + "," + b + "," + c + "," + a + "]").find("rejected") ==
        std::string::npos);
  CHECK(error_of("[" + a + "," + b + "," + c + "," + a + ",[[1,2]]]").find("two points") !=
        std::string::npos);
}

TEST_CASE("a list that is segments and a model alike is refused with both readings") {
  const std::string error = error_of("[[[0,0],[1,1]],[[0,1],[1,0]]]");
  CHECK(error.find("two ways") != std::string::npos);
  CHECK(error.find(R"({"lines": [...]})") != std::string::npos);
  CHECK(error.find("(V, EV)") != std::string::npos);
  // A model still.
  CHECK(listed("[[[0,0],[5,0],[0,5]],[[0,1],[1,2]]]").find("EV") != std::string::npos);
  CHECK(listed("[[[0,0],[5,0]],[[0,1]]]") == "0 0, 5 0 | a.json:1:17 EV\n");
}

TEST_CASE("what is not drawn is listed") {
  CHECK(listed(R"({"V": [[0, 0, 7], [1, 1, 8], [2, 2, 9]], "EV": [[0, 1]], "KV": [[0, 1, 2]]})") ==
        "0 0, 1 1 | a.json:1:49 EV\nrejected:\n"
        "a.json:1:64 KV: this member of a LAR model is not understood\n"
        "a.json V: isolated points are not drawn: 1 point\nremarks:\n"
        "a.json:1:16 V: coordinates beyond x and y are not used: 3 elements from here on\n");
  CHECK(listed(R"({"V": [], "EV": []})").empty());
}

TEST_CASE("cells of the plane are faces: what eval writes is read") {
  const std::string cells = R"("V": [[0, 0], [1, 0], [0, 1]], "CV": [[0, 1, 2]]})";
  std::string faces = cells;
  faces.replace(faces.find("CV"), 2, "FV");
  CHECK(listed("{" + cells) == listed("{" + faces));
  CHECK(listed("{" + cells).find("0 0, 1 0") != std::string::npos);
}

TEST_CASE("an index without vertex is refused with its place") {
  const std::string v = "{\"V\": [[0, 0], [1, 1]],\n";
  const std::string none = " (a member index_base of 0 or 1 says from where): ";
  CHECK(error_of(v + "\"EV\": [[0, 1],\n [1, 2]]}") ==
        "a:3:2: not LAR: no such vertex: 2 are counted from 0" + none + "\"2\"");
  CHECK(error_of(v + "\"EV\": [[0, 1]], \"index_base\": 1}") ==
        "a:2:8: not LAR: no such vertex: 2 are counted from 1" + none + "\"0\"");
  CHECK(error_of(v + "\"FV\": [[0, 1, 99]]}").starts_with("a:2:8: not LAR: no such vertex"));
  CHECK(error_of(v + "\"EV\": [[0, -1]]}").find("not an index: \"-1\"") != std::string::npos);
  CHECK(error_of(v + "\"EV\": [[0, 1.0]]}").find("not an index: \"1.0\"") != std::string::npos);
  CHECK(error_of(v + "\"EV\": [[0, 4294967296]]}").find("not an index") != std::string::npos);
  CHECK(error_of(v + "\"EV\": [[0, 1, 0]]}") == "a:2:8: not LAR: edge of 3 vertices");
}

TEST_CASE("what is no LAR model is refused") {
  CHECK(error_of("{}").find("neither V nor lines") != std::string::npos);
  CHECK(error_of("7").find("neither an object nor an array") != std::string::npos);
  CHECK(error_of("[7]").find("a number in place of a list") != std::string::npos);
  CHECK(error_of(R"({"V": 7})").find("not a list") != std::string::npos);
  CHECK(error_of(R"({"V": {}})").find("an object in place of a list") != std::string::npos);
  CHECK(error_of(R"({"V": [[1]]})").find("point of 1 coordinates") != std::string::npos);
  CHECK(error_of(R"({"V": [[1, 2, 3, 4]]})").find("point of 4 coordinates") != std::string::npos);
  CHECK(error_of(R"({"V": [[1, "2"]]})").find("not a number: \"2\"") != std::string::npos);
  CHECK(error_of(R"({"V": [[1, [2]]]})").find("nested too deep") != std::string::npos);
  CHECK(error_of(R"({"V": [[1, 1e99999]]})").find("too big") != std::string::npos);
  CHECK(error_of(R"({"V": [], "V": []})").find("member V is there twice") != std::string::npos);
  CHECK(error_of(R"({"lines": [[[0, 0]]]})").find("line that has not two points") !=
        std::string::npos);
  CHECK(error_of(R"({"lines": [[0, 0, 1, 1]]})").find("a number in place of a list") !=
        std::string::npos);
  CHECK(error_of(R"({"V": [], "index_base": 2})").find("index_base is neither 0 nor 1") !=
        std::string::npos);
  CHECK(error_of("[[], [], [], []]").find("more than three lists") != std::string::npos);
  CHECK(error_of("{\"V\": [[0, 0]").find("not JSON") != std::string::npos);
}
