// A text of lines, each a word and values; numbers are exact.

#include "tiles/manifest.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "plumbline/detail/new_file.hpp"
#include "plumbline/error.hpp"

namespace plumbline::tiles {
namespace {

constexpr const char* kTitle = "plumbline tiles 1";

std::string text_of(const Number& number) { return exact_text(number.rational()); }
std::string text_of(const std::optional<Number>& cut) { return cut ? text_of(*cut) : "-"; }

[[noreturn]] void fail(const std::filesystem::path& folder, const std::string& line) {
  throw Error(ErrorCode::BadFile, "not the manifest of tiles",
              {(folder / "manifest").string(), 0, 0}, line);
}

std::optional<Number> cut_of(const std::string& text) {
  if (text == "-") return {};
  return parse_number(text);
}

Tile tile_of(std::istringstream& words) {
  Tile tile;
  std::string left, right;
  words >> tile.number >> left >> right >> tile.segments >> tile.hash.low >> tile.hash.high;
  tile.strip = {cut_of(left), cut_of(right)};
  return tile;
}

}  // namespace

std::filesystem::path segments_of(const std::filesystem::path& folder, std::uint64_t tile) {
  return folder / fmt::format("{}.segments", tile);
}
std::filesystem::path part_of(const std::filesystem::path& folder, std::uint64_t tile) {
  return folder / fmt::format("{}.part", tile);
}

bool has_manifest(const std::filesystem::path& folder) {
  std::error_code ignored;
  return std::filesystem::exists(folder / "manifest", ignored);
}

void write_manifest(const std::filesystem::path& folder, const Manifest& manifest) {
  const Bounds& b = manifest.bounds;
  std::string text = fmt::format(
      "{}\ndrawing {}\nrejected {} {}\nsegments {}\ndigits {}\nnext {}\n", kTitle, manifest.drawing,
      manifest.rejected, manifest.lost, manifest.segments, manifest.digits, manifest.next);
  text += fmt::format("bounds {} {} {} {}\n", text_of(b.left), text_of(b.bottom), text_of(b.right),
                      text_of(b.top));
  for (const Tile& tile : manifest.tiles) {
    text += fmt::format("tile {} {} {} {} {} {}\n", tile.number, text_of(tile.strip.left),
                        text_of(tile.strip.right), tile.segments, tile.hash.low, tile.hash.high);
  }
  write_file(folder / "manifest", text + "end\n");
}

Manifest read_manifest(const std::filesystem::path& folder) {
  std::ifstream file(folder / "manifest");
  std::string line;
  if (!std::getline(file, line) || line != kTitle) fail(folder, line);
  Manifest result;
  bool has_ended = false;
  while (!has_ended && std::getline(file, line)) {
    std::istringstream words(line);
    std::string word, left, bottom, right, top;
    words >> word;
    if (word == "drawing") {
      std::getline(words >> std::ws, result.drawing);
    } else if (word == "rejected") {
      words >> result.rejected >> result.lost;
    } else if (word == "segments") {
      words >> result.segments;
    } else if (word == "digits") {
      words >> result.digits;
    } else if (word == "next") {
      words >> result.next;
    } else if (word == "bounds") {
      words >> left >> bottom >> right >> top;
      result.bounds = {parse_number(left), parse_number(bottom), parse_number(right),
                       parse_number(top)};
    } else if (word == "tile") {
      result.tiles.push_back(tile_of(words));
    } else {
      has_ended = word == "end";
      if (!has_ended) fail(folder, line);
    }
    if (!words) fail(folder, line);
  }
  if (!has_ended || result.tiles.empty()) fail(folder, line);
  return result;
}

std::size_t place_of(const Manifest& manifest, std::uint64_t number) {
  for (std::size_t i = 0; i < manifest.tiles.size(); ++i) {
    if (manifest.tiles[i].number == number) return i;
  }
  throw Error(ErrorCode::BadInput, "there is no such tile", {}, std::to_string(number));
}

}  // namespace plumbline::tiles
