#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "plumbline/read.hpp"

namespace plumbline {

/// Calls a reader with the bytes and evaluates its result. Aborts, saying why, if the reader throws
/// anything but an Error with a place or breaks a promise: every text UTF-8 on one line, every
/// rejected item with a reason and in a file that there is.
void check_reader(Structure (*read)(std::string_view, const std::string&, const ReadOptions&),
                  const std::uint8_t* data, std::size_t size);

}  // namespace plumbline
