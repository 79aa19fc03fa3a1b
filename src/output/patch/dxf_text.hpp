#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace plumbline::patch {

/// A group of a DXF text: a line with its code, a line with its value.
struct DxfGroup {
  int code = 0;
  std::string_view value;  ///< without blanks around it
  std::size_t begin = 0;   ///< of its bytes, line ends included
  std::size_t end = 0;
};

/// A group of code 0 and what follows it up to the next one.
struct DxfRecord {
  std::string_view type;
  std::string_view section;  ///< that it stands in
  std::uint32_t line = 0;    ///< of its type
  std::size_t first_group = 0, groups = 0;
};

/// A DXF text with the place of every byte.
struct DxfText {
  std::string_view text;
  std::string_view line_end;
  std::vector<DxfGroup> groups;
  std::vector<DxfRecord> records;

  /// The groups of a record that are its own: none of applications', none of extended data.
  std::vector<DxfGroup> own_groups(const DxfRecord& record) const;
  /// The value of its first own group of this code; "" where there is none.
  std::string_view value(const DxfRecord& record, int code) const;
  std::size_t begin(const DxfRecord& record) const { return groups[record.first_group].begin; }
  std::size_t end(const DxfRecord& record) const {
    return groups[record.first_group + record.groups - 1].end;
  }
};

/// None for what is no sequence of groups.
std::optional<DxfText> dxf_text_of(std::string_view text);

}  // namespace plumbline::patch
