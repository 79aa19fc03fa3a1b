#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "plumbline/error.hpp"

namespace plumbline {

/// An XML text as UTF-8 without byte order mark, from the encoding that its first bytes tell: the
/// mark, the pattern of "<" in UTF-16, or the XML declaration; UTF-8 else. Throws: Error BadInput
/// for an unknown encoding, a byte sequence that is none of its characters, and a control character
/// that XML forbids.
std::string to_utf8(std::string_view bytes, const std::string& file);

/// The bytes, in the encoding that iconv knows by this name, as UTF-8; nothing where they are not
/// valid in it or it is unknown.
std::optional<std::string> utf8_from(std::string_view bytes, const std::string& encoding);

/// Line and column (in bytes) of an offset into a text.
Place place_in(std::string_view text, std::size_t offset, const std::string& file);

}  // namespace plumbline
