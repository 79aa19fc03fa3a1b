#pragma once

#include <string_view>
#include <vector>

#include "plumbline/structure.hpp"
#include "read/attribute.hpp"

namespace plumbline {

/// The maps of a `transform` attribute.
struct SvgTransform {
  std::vector<Struct::Item> maps;  ///< Turns, without source, and what is between them
  /// The skews whose numbers had to be replaced, without source.
  std::vector<Replacement> replaced;
};

/// The product of the functions of a transform list: the rightmost is applied first. **Exact** but
/// for what `replaced` lists. Throws: Unusable for a malformed list, a function with the wrong
/// number of arguments and one that is not in SVG 1.1; Error as `skew_x` does for the bound.
/// Source: SVG 1.1, 7.6.
SvgTransform parse_transform(std::string_view text, Numbers& numbers, double bound);

}  // namespace plumbline
