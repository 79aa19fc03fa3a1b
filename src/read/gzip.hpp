#pragma once

#include <string>
#include <string_view>

namespace plumbline {

/// Largest text that `inflated` makes, in bytes.
inline constexpr std::size_t kMaxInflatedSize = std::size_t{1} << 28U;

/// Whether the bytes begin as those of a gzip file do.
bool is_gzip(std::string_view bytes);

/// The content of a gzip file, of all its members. Throws: Error BadInput for a malformed or cut
/// one, Limit beyond `max_size`.
std::string inflated(std::string_view bytes, const std::string& file,
                     std::size_t max_size = kMaxInflatedSize);

}  // namespace plumbline
