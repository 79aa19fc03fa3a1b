// Of a tile's segments its part, and of all parts the whole.

#include <fstream>
#include <sstream>
#include <utility>

#include "plumbline/detail/new_file.hpp"
#include "plumbline/error.hpp"
#include "tiles/manifest.hpp"
#include "tiles/part_file.hpp"
#include "tiles/segment_file.hpp"

namespace plumbline::tiles {
namespace {

std::optional<StripPart> read_part(const std::filesystem::path& folder, const Tile& tile) {
  std::ifstream file(part_of(folder, tile.number), std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return from_bytes(std::move(bytes).str(), tile.hash);
}

}  // namespace

bool has_part(const std::filesystem::path& folder, const Tile& tile) {
  return read_part(folder, tile).has_value();
}

void arrange_tile(const std::filesystem::path& folder, std::uint64_t number) {
  const Manifest manifest = read_manifest(folder);
  const Tile& tile = manifest.tiles[place_of(manifest, number)];
  if (read_part(folder, tile)) return;
  SegmentSet segments;
  std::vector<std::uint64_t> numbers;
  SegmentReader reader(segments_of(folder, number));
  while (std::optional<NumberedSegment> next = reader.next()) {
    auto& [ax, ay, bx, by] = next->at;
    segments.segments.push_back({std::move(ax), std::move(ay)}, {std::move(bx), std::move(by)});
    numbers.push_back(next->number);
  }
  if (reader.hash() != tile.hash) {
    throw Error(ErrorCode::BadFile, "it has other segments than the manifest says",
                {segments_of(folder, number).string(), 0, 0});
  }
  const StripPart part = strip_part(std::move(segments), numbers, tile.strip, manifest.bounds);
  write_file(part_of(folder, number), to_bytes(part, tile.hash));
}

Totals merged(const std::filesystem::path& folder) {
  const Manifest manifest = read_manifest(folder);
  std::vector<StripPart> parts;
  for (const Tile& tile : manifest.tiles) {
    std::optional<StripPart> part = read_part(folder, tile);
    if (!part) {
      throw Error(ErrorCode::BadFile, "the part of a tile is missing, or of other segments",
                  {part_of(folder, tile.number).string(), 0, 0});
    }
    parts.push_back(*std::move(part));
  }
  return merged(parts);
}

}  // namespace plumbline::tiles
