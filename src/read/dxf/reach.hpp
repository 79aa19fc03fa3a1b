#pragma once

#include <string>
#include <vector>

#include "read/dxf/space.hpp"

namespace plumbline::dxf {

/// Per space of the drawing: whether inserts lead to it from the model space. No recursion. Throws:
/// Error BadInput for a block within itself, naming the path and the line of the INSERT.
std::vector<bool> reached_spaces(const Drawing& drawing, const std::string& file_name);

}  // namespace plumbline::dxf
