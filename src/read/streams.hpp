#pragma once

#include "plumbline/read.hpp"
#include "read/byte_stream.hpp"
#include "read/geometries.hpp"

namespace plumbline {

/// The readers of read.hpp that need no more than a part of the text at a time, on any stream.
Structure read_geojson(ByteStream& bytes);
Structure read_wkt(ByteStream& bytes);
Structure read_wkb(ByteStream& bytes);
Structure read_csv(ByteStream& bytes);
Structure read_lar_json(ByteStream& bytes);
Structure read_struct_json(ByteStream& bytes, const ReadOptions& options);

/// The same; where there are `geometries`, lines and polygons go there, and what is returned has no
/// segments.
Structure read_geojson(ByteStream& bytes, Geometries* geometries);
Structure read_wkt(ByteStream& bytes, Geometries* geometries);
Structure read_wkb(ByteStream& bytes, Geometries* geometries);
Structure read_csv(ByteStream& bytes, Geometries* geometries);

}  // namespace plumbline
