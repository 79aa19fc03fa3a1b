#pragma once

#include <string_view>

namespace plumbline::dxf {

/// Why entities of a type are left out, and whether they have no lines of a drawing.
struct Unread {
  std::string_view type;
  const char* reason;
  bool harmless;
};

/// Of a type that is not read; what is not known may have lines.
Unread unread(std::string_view type);

}  // namespace plumbline::dxf
