#pragma once

#include <string_view>
#include <vector>

#include "plumbline/structure.hpp"
#include "read/attribute.hpp"

namespace plumbline {

/// The map of a `transform` attribute.
struct SvgTransform {
  Affine map;
  /// The functions whose numbers had to be replaced, without source.
  std::vector<Replacement> replaced;
};

/// The product of the functions of a transform list: the rightmost is applied first. **Exact** but
/// for what `replaced` lists. Throws: Unusable for a malformed list, a function with the wrong
/// number of arguments and one that is not in SVG 1.1; Error as `rotation` does for the bound.
/// Source: SVG 1.1, 7.6.
SvgTransform parse_transform(std::string_view text, Numbers& numbers, double bound);

}  // namespace plumbline
