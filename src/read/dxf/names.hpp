#pragma once

#include <string>
#include <string_view>

namespace plumbline::dxf {

/// Makes UTF-8 of the names in a DXF text, whatever its bytes.
class Names {
 public:
  /// By the values of $ACADVER and $DWGCODEPAGE: UTF-8 from AC1021 on, the code page before, which
  /// is Windows' 1252 where none is given.
  void set_encoding(std::string_view version, std::string_view code_page);

  /// The text in UTF-8, on one line. `\U+XXXX` is the character with that number. Bytes that are
  /// not valid in the encoding are taken as Latin-1.
  std::string utf8(std::string_view bytes) const;
  /// The same for comparison: symbol names differ by more than the case of ASCII letters.
  std::string key(std::string_view bytes) const;

 private:
  std::string encoding_ = "CP1252";
};

/// The beginning of a text with everything that is not printable ASCII as '?'.
std::string in_ascii(std::string_view text);

}  // namespace plumbline::dxf
