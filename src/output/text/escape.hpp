#pragma once

#include <string>
#include <string_view>

namespace plumbline {

/// The text as character data or attribute value of XML 1.0: & < > " ' as entities; invalid UTF-8
/// and the characters that XML forbids (control characters among them) as U+FFFD.
std::string xml_text(std::string_view text);

}  // namespace plumbline
