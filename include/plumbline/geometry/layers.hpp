#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline {

/// Whether a text is what a pattern stands for: `*` for any characters, `?` for one, letters of
/// ASCII in either case.
bool matches_pattern(std::string_view text, std::string_view pattern);

/// The name of a layer without what binding a drawing into another one put before it: "A-WALL" of
/// "plan-1$0$A-WALL" and of "plan|A-WALL".
std::string_view own_layer_name(std::string_view layer);
/// Whether a pattern stands for the layer's name, or for its own name.
bool is_layer(std::string_view layer, std::string_view pattern);

/// Per source whether it lies on a layer of these names, patterns allowed. Throws: as `on_layers`.
std::vector<bool> sources_on_layers(const SegmentSet& set,
                                    const std::vector<std::string>& patterns);
/// The drawing with those segments alone that lie on layers of these names, patterns allowed; its
/// labels stay. Throws: Error BadInput for a pattern that no layer has, with the first of those
/// that there are.
SegmentSet on_layers(SegmentSet set, const std::vector<std::string>& patterns);

}  // namespace plumbline
