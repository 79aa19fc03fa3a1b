#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "read/svg/index.hpp"

namespace plumbline {

/// Something that a document says and the reader does not apply.
struct SvgUnapplied {
  pugi::xml_node element;
  std::string what, text;
};

/// What of the document is not applied, each kind once: a transform or placement of the root, style
/// sheets that place or hide something, clip-paths and masks.
std::vector<SvgUnapplied> unapplied(const pugi::xml_node& root, const SvgIndex& index);

}  // namespace plumbline
