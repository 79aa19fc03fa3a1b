#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "plumbline/read.hpp"
#include "plumbline/tiles.hpp"

/// Drawings larger than memory: each stage makes files of files, and what is done stays done. A
/// folder holds `manifest`, which says what the tiles are, and of each tile `N.segments` and
/// `N.part`. A file is whole or not there.
namespace plumbline::tiles {

struct Tile {
  std::uint64_t number = 0;  ///< of its files
  Strip strip;
  std::uint64_t segments = 0;  ///< that meet it
  CellHash hash;               ///< of them all
};

struct Manifest {
  std::string drawing;  ///< the file, its size, when it was written, how it is read
  std::uint64_t rejected = 0,
                lost = 0;  ///< items of the drawing; of these, what looks like geometry
  Bounds bounds;
  std::uint64_t segments = 0;  ///< of the drawing
  int digits = 0;              ///< most decimals of a sample of coordinates
  std::uint64_t next = 0;      ///< number of the next tile that is made
  std::vector<Tile> tiles;     ///< from left to right
};

Manifest read_manifest(const std::filesystem::path& folder);

/// Told now and then how many segments were read.
using Told = std::function<void(std::uint64_t)>;

/// Reads the drawing, a `.lines` file in pieces of some megabytes, twice: once to choose cuts from
/// a sample of its ends so that tiles have about as many, once to write each segment, unclipped, to
/// every tile that it meets. Does nothing where the folder has a manifest of the same drawing.
/// Returns what was rejected. Throws: as `read`; Error BadFile, BadInput for a drawing without
/// segments, and where the folder's manifest is of another one.
std::vector<Rejected> scatter(const std::filesystem::path& drawing, const ReadOptions& options,
                              std::size_t tiles, const std::filesystem::path& folder,
                              const Told& told = {});

/// Arranges a tile and writes its part, unless there is one of the same segments. Throws:
/// CutThroughVertex; as `strip_part`; Error BadFile.
void arrange_tile(const std::filesystem::path& folder, std::uint64_t number);

/// Whether there is a part of the segments that the tile has.
bool has_part(const std::filesystem::path& folder, const Tile& tile);

/// Makes two tiles of one, cut where half of its segments begin. Returns false where all begin in
/// one place.
bool split(const std::filesystem::path& folder, std::uint64_t number);
/// Moves the cut on that side of a tile a little.
void move_cut(const std::filesystem::path& folder, std::uint64_t number, Side side);

/// What all tiles are together. Throws: Error BadFile where a part is missing, or is not of the
/// segments that the manifest says; as `merged`.
Totals merged(const std::filesystem::path& folder);

}  // namespace plumbline::tiles
