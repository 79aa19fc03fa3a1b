#pragma once

#include "plumbline/tiles/files.hpp"

namespace plumbline::tiles {

/// Replaces what the folder has.
void write_manifest(const std::filesystem::path& folder, const Manifest& manifest);
bool has_manifest(const std::filesystem::path& folder);

std::filesystem::path segments_of(const std::filesystem::path& folder, std::uint64_t tile);
std::filesystem::path part_of(const std::filesystem::path& folder, std::uint64_t tile);

/// The tile of that number. Throws: Error BadInput.
std::size_t place_of(const Manifest& manifest, std::uint64_t number);

}  // namespace plumbline::tiles
