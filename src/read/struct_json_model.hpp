#pragma once

#include "plumbline/structure.hpp"
#include "read/struct_json_values.hpp"

namespace plumbline {

/// A Model, a LarModel or a grid of cubes. The last of the files is the one that is read. Throws:
/// Error BadInput, with the place, for anything else.
Struct::Item read_model(const JsonValue& value, const std::vector<std::string>& files,
                        Numbers& numbers);

}  // namespace plumbline
