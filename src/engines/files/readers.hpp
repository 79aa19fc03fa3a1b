#pragma once

#include "plumbline/engines/files.hpp"
#include "read/byte_stream.hpp"
#include "read/streams.hpp"

namespace plumbline {

/// The readers of result.hpp on any stream. A trace of `lar` is a LAR model within another object.
ForeignResult read_lar_result(ByteStream& bytes);
ForeignResult read_arrangement(ByteStream& bytes);

/// A reader of drawings that gives lines and polygons.
using FeatureReader = Structure (*)(ByteStream&, const FeatureOptions&);
ForeignResult read_features(ByteStream& bytes, FeatureReader reader);

/// Notes faces that are not in the complex, having no edge.
void note_lost_faces(ForeignResult& result, std::size_t face_count);

}  // namespace plumbline
