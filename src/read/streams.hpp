#pragma once

#include "plumbline/read.hpp"
#include "read/byte_stream.hpp"
#include "read/geometries.hpp"

namespace plumbline {

/// The readers of read.hpp that need no more than a part of the text at a time, on any stream.
/// Where there are `geometries`, lines and polygons go there, and what is returned has no segments.
Structure read_geojson(ByteStream& bytes, Geometries* geometries = nullptr);
Structure read_wkt(ByteStream& bytes, Geometries* geometries = nullptr);
Structure read_wkb(ByteStream& bytes, Geometries* geometries = nullptr);
Structure read_csv(ByteStream& bytes, Geometries* geometries = nullptr);
Structure read_lar_json(ByteStream& bytes);
Structure read_struct_json(ByteStream& bytes, const ReadOptions& options);

}  // namespace plumbline
