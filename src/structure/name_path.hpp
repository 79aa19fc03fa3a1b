#pragma once

#include <string>
#include <vector>

namespace plumbline {

/// The names of the Structs from the outermost to the current one, joined by '/'. Empty names are
/// left out. Longer paths than kMaxPathText end in "/...", so that deep nesting of named Structs
/// costs no quadratic memory.
class NamePath {
 public:
  void push(const std::string& name);
  void pop();
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::vector<std::size_t> lengths_;  ///< of text_ before each push
  bool full_ = false;                 ///< whether text_ ends in "/..."
};

}  // namespace plumbline
