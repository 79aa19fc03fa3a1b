#include <fstream>
#include <iterator>

#include "cases/foreign/foreign.hpp"
#include "plumbline/read.hpp"

namespace plumbline::foreign {

std::vector<Case> read_file(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  const auto ends = [&](const char* ending) { return name.ends_with(ending); };
  if (ends(".geojson") || ends(".wkt") || ends(".wkb")) {
    return {{"", evaluate(read(file)), {}, {}, {}}};
  }
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) {
    throw Error(ErrorCode::BadFile, "cannot be read", {file.string(), 0, 0});
  }
  if (ends(".xml")) return jts_xml(text);
  if (ends(".cdt.txt")) return cdt(text);
  if (ends(".txt")) return clipper2(text);
  if (ends(".dat")) return poly2tri(text);
  if (ends(".json")) return ioverlay(text);
  throw Error(ErrorCode::BadInput, "a format that nothing here reads");
}

}  // namespace plumbline::foreign
