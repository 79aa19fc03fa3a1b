#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "read/dxf/names.hpp"
#include "read/dxf/shapes.hpp"

namespace plumbline::dxf {

/// What a style of multilines draws besides their lines, as bits: the DXF reference's flags of an
/// MLINESTYLE.
constexpr std::int64_t kJoints = 2;
constexpr std::int64_t kStartLine = 16, kStartInnerArcs = 32, kStartArc = 64;
constexpr std::int64_t kEndLine = 256, kEndInnerArcs = 512, kEndArc = 1024;

/// The styles of multilines in a DXF text, which stand behind what they are used for: looked for
/// when the first is asked for.
class MlineStyles {
 public:
  /// Requires: all three outlive the styles.
  MlineStyles(std::string_view text, const std::string& file, const Names& names)
      : text_(text), file_(file), names_(names) {}

  /// The flags of the style of this name; 0 where there is none. Throws: as RecordReader.
  std::int64_t flags(std::string_view name);

 private:
  std::string_view text_;
  const std::string& file_;
  const Names& names_;
  std::optional<std::map<std::string, std::int64_t>> flags_;  ///< by the key of the name
};

/// An MLINE: its lines, with their breaks, where the parameters at its vertices have them; and what
/// its style adds at vertices and ends, round caps as half circles. **Exact**. Throws: Unusable for
/// lines without parameters.
DrawnEntity draw_mline(const Entity& entity, std::int64_t style, Pen& pen);

}  // namespace plumbline::dxf
