#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "certificates/text.hpp"

namespace plumbline::certificates {

using Line = std::vector<std::string>;

/// The fields of a certificate's lines.
class Fields {
 public:
  explicit Fields(const std::string& text) {
    for (const std::string& line : lines_of(text)) {
      lines.emplace_back();
      for (std::size_t begin = 0, end = 0; end != line.npos; begin = end + 1) {
        end = line.find(' ', begin);
        lines.back().push_back(line.substr(begin, end - begin));
      }
    }
  }

  std::string text() const {
    std::string result;
    for (const Line& line : lines) {
      for (std::size_t i = 0; i < line.size(); ++i) result += (i > 0 ? " " : "") + line[i];
      result += "\n";
    }
    return result;
  }

  /// The head of a section, or the end.
  std::size_t head(const char* section) const {
    const auto is_head = [&](const Line& line) { return line.size() == 2 && line[0] == section; };
    return static_cast<std::size_t>(std::find_if(lines.begin(), lines.end(), is_head) -
                                    lines.begin());
  }
  std::size_t count(const char* section) const {
    const std::size_t at = head(section);
    return at < lines.size() ? std::stoul(lines[at][1]) : 0;
  }
  Line& item(const char* section, std::size_t i) { return lines[head(section) + 1 + i]; }

  /// Puts other lines into a section.
  void replace(const char* section, const std::vector<Line>& items) {
    const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(head(section) + 1);
    const auto after = lines.erase(begin, begin + static_cast<std::ptrdiff_t>(count(section)));
    (after - 1)->back() = std::to_string(items.size());
    lines.insert(after, items.begin(), items.end());
  }

  std::vector<Line> lines;
};

}  // namespace plumbline::certificates
