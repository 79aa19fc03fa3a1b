// Results of other programs: whatever a file says, it is refused, or it can be validated and held
// against a drawing. How a text begins, and words in it, tell the format.

#include "plumbline/engines/files.hpp"

#include <cstdio>
#include <cstdlib>
#include <optional>

#include "engines/files/readers.hpp"
#include "plumbline/compare.hpp"
#include "plumbline/error.hpp"

using namespace plumbline;

namespace {

/// Well-known binary, as bytes or hexadecimal, and CSV, by their first byte.
std::optional<files::Result> read_binary_or_csv(std::string_view text) {
  ByteStream bytes(text, {"fuzz", 1, 1});
  if (text.starts_with('\0') || text.starts_with('\1') || text.starts_with('0')) {
    return files::read_features(bytes, read_wkb);
  }
  if (text.starts_with('w') || text.starts_with('x') || text.starts_with('"')) {
    return files::read_features(bytes, read_csv);
  }
  return std::nullopt;
}

files::Result read(std::string_view text) {
  if (auto result = read_binary_or_csv(text)) return *std::move(result);
  const std::size_t start = text.find_first_not_of(" \r\n\t");
  if (start == std::string_view::npos) return files::read_wkt(text, "fuzz");
  if (text[start] != '{' && text[start] != '[') return files::read_wkt(text, "fuzz");
  if (text.find("\"exact\"") != std::string_view::npos) {
    return files::read_arrangement(text, "fuzz");
  }
  if (text.find("\"type\"") != std::string_view::npos) return files::read_geojson(text, "fuzz");
  return files::read_lar(text, "fuzz");
}

/// A triangle, exactly.
ExactComplex triangle() {
  ExactComplex c;
  c.vertices = {{0, 0}, {0, 8}, {8, 0}};
  c.edges = {{VertexId(0), VertexId(1)}, {VertexId(0), VertexId(2)}, {VertexId(1), VertexId(2)}};
  for (int i = 0; i < 3; ++i) c.edge_sources.push_back(std::vector<SegmentId>());
  c.cycles.push_back(std::vector{HalfedgeId(2), HalfedgeId(5), HalfedgeId(1)});
  c.cycles.push_back(std::vector{HalfedgeId(0), HalfedgeId(4), HalfedgeId(3)});
  c.face_outer = {CycleId(), CycleId(0)};
  c.face_holes.push_back(std::vector{CycleId(1)});
  c.face_holes.push_back(std::vector<CycleId>());
  for (int i = 0; i < 2; ++i) c.face_isolated_vertices.push_back(std::vector<VertexId>());
  return canonical(std::move(c));
}

[[noreturn]] void fail(const char* why) {
  std::fprintf(stderr, "broken promise: %s\n", why);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ExactComplex drawing = triangle();
  static const bool is_valid = validate(drawing).empty();
  if (!is_valid) fail("the triangle is not valid");
  try {
    const files::Result result = read({reinterpret_cast<const char*>(data), size});
    const Comparison found =
        compare(drawing, result.complex, 0.5, result.has_faces ? Compared::All : Compared::Graph);
    const bool has_violations = !validate(result.complex).empty();
    if (result.has_faces && found.float_valid == has_violations) fail("validity differs");
    if (found.agree() && found.float_counts.vertices != 3) fail("agrees with other counts");
  } catch (const Error& error) {
    if (error.code() == ErrorCode::Internal) fail(error.what());
  }
  return 0;
}
