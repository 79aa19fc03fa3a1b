#pragma once

#include <string>

#include "read/byte_stream.hpp"

namespace plumbline {

/// Formats that are written as JSON; the last two are results of this program.
enum class JsonKind { GeoJson, Lar, Struct, Arrangement, LarTrace };

/// The format of a JSON text by the first member of its outermost object that tells. Throws: Error
/// BadInput for a text that is none of them, with the name of the format where it is known.
JsonKind json_kind(ByteStream& bytes);

}  // namespace plumbline
