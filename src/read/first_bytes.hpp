#pragma once

#include <string_view>

namespace plumbline {

/// The format, of kFormats, that the beginning of a text certainly is; "" where it could be several
/// or none.
std::string_view format_by_first_bytes(std::string_view bytes);

}  // namespace plumbline
