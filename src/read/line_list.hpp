#pragma once

#include "read/byte_stream.hpp"

namespace plumbline {

/// Whether a JSON text is a bare list of segments, [[[x1, y1], [x2, y2]], ...], and no LAR model
/// [V, EV] or [V, FV, EV]. Reads no further than it takes to tell. Throws: Error BadInput for what
/// is both: two segments whose second one has the indices of edges between the ends of the first.
bool is_line_list(ByteStream& bytes);

}  // namespace plumbline
