#pragma once

#include "plumbline/read.hpp"
#include "read/byte_stream.hpp"
#include "read/geometries.hpp"

namespace plumbline {

inline FeatureOptions feature_options(const ReadOptions& options) {
  return {nullptr,        options.max_segments,   options.shortest_decimals,
          options.layers, options.without_layers, options.layer_property};
}

/// The readers of read.hpp that need no more than a part of the text at a time, on any stream.
/// Throws: also Error Limit beyond the options' segments.
Structure read_geojson(ByteStream& bytes, const FeatureOptions& options = {});
Structure read_wkt(ByteStream& bytes, const FeatureOptions& options = {});
Structure read_wkb(ByteStream& bytes, const FeatureOptions& options = {});
Structure read_csv(ByteStream& bytes, const FeatureOptions& options = {});
Structure read_lar_json(ByteStream& bytes, const FeatureOptions& options = {});
/// A bare list of segments; other lists are LAR models (`is_line_list`).
Structure read_line_list(ByteStream& bytes, const FeatureOptions& options = {});
Structure read_struct_json(ByteStream& bytes, const ReadOptions& options);

/// One of them that gives lines and polygons.
using FeatureReader = Structure (*)(ByteStream&, const FeatureOptions&);

}  // namespace plumbline
