#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline {

/// Whether a text is what a pattern stands for: `*` for any characters, `?` for one, letters of
/// ASCII in either case.
bool matches_pattern(std::string_view text, std::string_view pattern);

/// The drawing with those segments alone that lie on layers of these names, patterns allowed; its
/// labels stay. Throws: Error BadInput for a pattern that no layer has, with the first of those
/// that there are.
SegmentSet on_layers(SegmentSet set, const std::vector<std::string>& patterns);

}  // namespace plumbline
