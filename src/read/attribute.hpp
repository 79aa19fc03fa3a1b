#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline {

/// Thrown inside the readers: an item of the drawing can't be used. Becomes a Rejected item.
struct Unusable {
  std::string reason;
  std::string text;       ///< the offending text
  bool harmless = false;  ///< as that of Rejected
};

class Scanner;

/// Makes the numbers of one document, and bounds the total size of the long ones: a text such as
/// "1e9999" makes a number a thousand times its own length.
class Numbers {
 public:
  /// Shortening makes a number the `short_decimal` that it lies next to.
  explicit Numbers(bool shortening = false) : shortening_(shortening) {}

  /// Throws: Unusable where `parse_number` refuses; Error Limit where the document's long numbers
  /// take more than kMaxLongWords.
  Number parse(std::string_view text);
  /// A number of the document that was read otherwise, shortened where it is to be.
  Number read(Number value) { return shortening_ ? shortened(std::move(value)) : value; }
  /// The number that starts at the scanner, which moves behind it. Throws: also Unusable with this
  /// reason where none does; the scanner then has not moved.
  Number take(Scanner& scanner, const char* reason);
  /// What shortening replaced, where it did: one entry, without a line.
  void add_to(std::vector<Replacement>& ledger) const;

 private:
  Number parse_whole(std::string_view text);
  Number shortened(Number value);

  static constexpr std::size_t kPlainWords = 4;  ///< any decimal of up to 38 digits
  static constexpr std::size_t kMaxLongWords = std::size_t{1} << 24U;  ///< 128 MiB
  bool shortening_;
  std::size_t shortened_ = 0;
  double largest_change_ = 0;
  std::size_t long_words_ = 0;
};

/// Walks over the text of an attribute by the rules that the grammars of SVG share.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  bool at_end() const { return position_ == text_.size(); }
  std::size_t position() const { return position_; }
  /// The text from an earlier position to here, and from one to the end.
  std::string_view since(std::size_t begin) const { return text_.substr(begin, position_ - begin); }
  std::string_view rest(std::size_t begin) const { return text_.substr(begin); }
  /// The next character; 0 at the end.
  char peek() const { return at_end() ? '\0' : text_[position_]; }
  void advance() { ++position_; }
  bool at_blank() const;
  void skip_blanks();
  /// Skips blanks with at most one comma among them; whether there was one.
  bool skip_separator();
  /// The longest number (sign, digits, point, exponent) that starts here; empty where none does.
  std::string_view number() const;
  bool at_number() const { return !number().empty(); }
  void advance_by(std::size_t count) { position_ += count; }

 private:
  std::string_view text_;
  std::size_t position_ = 0;
};

}  // namespace plumbline
