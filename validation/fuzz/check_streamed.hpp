#pragma once

#include <cstddef>
#include <cstdint>

#include "read/streams.hpp"

namespace plumbline {

/// `check_reader` for a reader that also takes a stream. Aborts also if it reads the bytes
/// otherwise where they come in blocks of a few bytes than as one text.
void check_streamed(Structure (*read)(ByteStream&, const FeatureOptions&),
                    Structure (*read_text)(std::string_view, const std::string&,
                                           const ReadOptions&),
                    const std::uint8_t* data, std::size_t size);

}  // namespace plumbline
