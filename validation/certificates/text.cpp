#include "certificates/text.hpp"

#include <gmpxx.h>
#include <xxhash.h>

#include <algorithm>
#include <sstream>

namespace plumbline::certificates {
namespace {

/// The number in base 16, or the text itself if it is no number.
std::string in_base_16(const std::string& text) {
  mpq_class value;
  const bool is_number = !text.empty() && text.find_first_not_of("-/0123456789") == text.npos &&
                         value.set_str(text, 10) == 0;
  return is_number ? value.get_str(16) : text;
}

/// "+2" as "4", "-2" as "5".
std::string halfedge_number(const std::string& text) {
  mpz_class edge;
  if (text.size() < 2 || edge.set_str(text.substr(1), 10) != 0) return text;
  return mpz_class(2 * edge + (text[0] == '-' ? 1 : 0)).get_str();
}

/// What the signature says of a line in a section.
std::string signed_line(const std::string& section, const std::string& line) {
  std::istringstream fields(line);
  std::string a, b;
  if (section == "vertices" && fields >> a >> b) {
    return "v " + in_base_16(a) + " " + in_base_16(b) + "\n";
  }
  if (section == "edges" && fields >> a >> b) return "e " + a + " " + b + "\n";
  std::string text;
  if (section == "cycles") {
    text = "c";
    while (fields >> a) text += " " + halfedge_number(a);
    return text + "\n";
  }
  if (section != "faces") return text;
  std::string list;
  while (fields >> a && a != "inside") {
    if (a == "outer" && fields >> b && b != "-") text += "o " + b + "\n";
    if (a == "holes" || a == "isolated") {
      if (!list.empty()) text += "\n";
      text += list = a.substr(0, 1);
    } else if (!list.empty()) {
      text += " " + a;
    }
  }
  return text + "\n";
}

}  // namespace

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string with_signature(std::string_view text) {
  static const std::vector<std::string> kSections = {"vertices", "edges", "cycles", "faces",
                                                     "components"};
  std::vector<std::string> lines = lines_of(text);
  std::string signed_text = "plumbline complex 1\n";
  std::string section;
  for (std::size_t i = 2; i < lines.size(); ++i) {
    const std::string word = lines[i].substr(0, lines[i].find(' '));
    const bool is_head = std::find(kSections.begin(), kSections.end(), word) != kSections.end();
    if (is_head) section = word;
    if (!is_head) signed_text += signed_line(section, lines[i]);
  }
  XXH128_canonical_t bytes;
  XXH128_canonicalFromHash(&bytes, XXH3_128bits(signed_text.data(), signed_text.size()));
  std::string digits;
  for (const unsigned char byte : bytes.digest) {
    digits += "0123456789abcdef"[byte >> 4];
    digits += "0123456789abcdef"[byte & 15];
  }
  if (lines.size() > 1) lines[1] = "signature " + digits;
  return joined(lines);
}

}  // namespace plumbline::certificates
