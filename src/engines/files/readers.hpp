#pragma once

#include "plumbline/engines/files.hpp"
#include "read/byte_stream.hpp"
#include "read/json_tree.hpp"
#include "read/streams.hpp"

namespace plumbline::files {

/// The readers of files.hpp on any stream. A trace of `lar` is a LAR model within another object.
Result read_lar(ByteStream& bytes);
/// A model that is part of another JSON text.
Result read_lar(const JsonValue& model, const std::string& file_name);
Result read_arrangement(ByteStream& bytes);

/// With a reader of drawings that gives lines and polygons.
Result read_features(ByteStream& bytes, FeatureReader reader);

/// Notes faces that are not in the complex, having no edge.
void note_lost_faces(Result& result, std::size_t face_count);

}  // namespace plumbline::files
