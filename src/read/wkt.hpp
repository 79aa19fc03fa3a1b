#pragma once

#include "read/attribute.hpp"
#include "read/feature_table.hpp"
#include "read/streams.hpp"

namespace plumbline {

/// Adds the geometry in well-known text that begins at the stream. Throws: Error BadInput; what
/// comes before in a collection has been added then.
void read_wkt_geometry(ByteStream& bytes, FeatureTable& table, Numbers& numbers);

/// The same for well-known binary, as bytes or as hexadecimal digits.
void read_wkb_geometry(ByteStream& bytes, FeatureTable& table);
void read_hex_wkb_geometry(ByteStream& bytes, FeatureTable& table);

}  // namespace plumbline
