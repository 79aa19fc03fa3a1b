#pragma once

#include <string>
#include <string_view>
#include <vector>

/// The texts of certificates (docs/certificate.md), for tests that damage them.
namespace plumbline::certificates {

/// Its lines, without their line breaks.
std::vector<std::string> lines_of(std::string_view text);
std::string joined(const std::vector<std::string>& lines);

/// The same text with the signature of what it says, so that a damaged certificate is not betrayed
/// by it. Lines that are no part of a certificate are passed over.
std::string with_signature(std::string_view text);

}  // namespace plumbline::certificates
