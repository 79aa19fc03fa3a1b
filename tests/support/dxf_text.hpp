#pragma once

#include <algorithm>
#include <string>

namespace plumbline {

/// DXF text from its codes and values, each separated from the next by one blank.
inline std::string dxf_lines(std::string codes_and_values) {
  std::replace(codes_and_values.begin(), codes_and_values.end(), ' ', '\n');
  return codes_and_values + "\n";
}

/// A drawing with these entities in its model space.
inline std::string dxf_with(const std::string& entities, const std::string& sections_before = {}) {
  return (sections_before.empty() ? "" : dxf_lines(sections_before)) +
         dxf_lines("0 SECTION 2 ENTITIES " + entities + " 0 ENDSEC 0 EOF");
}

}  // namespace plumbline
