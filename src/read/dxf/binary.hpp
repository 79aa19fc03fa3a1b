#pragma once

#include <string>
#include <string_view>

namespace plumbline::dxf {

/// Whether the bytes are a binary DXF, by their first 22.
bool is_binary(std::string_view bytes);

/// The text form of a binary DXF: a line with the code and a line with the value for each group,
/// doubles as the decimals or fractions that they exactly are. Codes are of one byte (up to R12) or
/// two. Degenerate: a double that is not finite becomes "inf" or "nan"; a line break inside a text
/// becomes a blank; bytes after the group 0 EOF are left out. Requires: is_binary(bytes). Throws:
/// Error BadInput, with the byte where it happens, for a group whose value has no known type and
/// for one cut off by the end of the file; Limit for a text of more than kMaxFileSize.
std::string text_of_binary(std::string_view bytes, const std::string& file);

}  // namespace plumbline::dxf
