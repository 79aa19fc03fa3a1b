#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "plumbline/geometry.hpp"

namespace plumbline::features {

/// UTF-8 as DXF before 2007 says it: what is not ASCII as "\U+XXXX", on one line.
std::string dxf_text(std::string_view utf8);

/// Names of layers, as DXF R2000 allows them: of other characters than letters, digits and most
/// signs each is a "_", and names that differ in cases alone get a number.
class LayerNames {
 public:
  const std::string& legal(const std::string& name);

 private:
  std::map<std::string, std::string> legal_;
  std::set<std::string> taken_;  ///< in lower case
};

/// Groups of a DXF file, a code and a value each, and handles for its records.
class Groups {
 public:
  void text(int code, std::string_view value);
  void integer(int code, std::int64_t value);
  void real(int code, double value);
  /// Groups `code`, `code` + 10 and, with a z of 0, `code` + 20.
  void point(int code, const PointD& p);
  void flat_point(int code, const PointD& p);
  /// Group 5 with a handle of its own, which it returns.
  std::string handle();
  std::string next_handle() const;
  void reserve(std::size_t bytes) { text_.reserve(bytes); }
  void append(const std::string& groups) { text_ += groups; }
  std::string take() { return std::move(text_); }

 private:
  void code(int code);

  std::string text_;
  std::uint64_t handles_ = kFirstHandle;
  static constexpr std::uint64_t kFirstHandle = 0x100;  // those below are for tables
};

}  // namespace plumbline::features
