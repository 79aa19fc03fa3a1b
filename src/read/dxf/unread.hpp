#pragma once

#include <string_view>

namespace plumbline::dxf {

/// Why entities of a type that is not read are left out.
const char* reason_not_read(std::string_view type);

}  // namespace plumbline::dxf
