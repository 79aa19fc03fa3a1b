#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "plumbline/overlay.hpp"

namespace plumbline {

/// The overlay for a terminal: what was laid over what, the area, the largest pieces with the
/// polygons that they lie in, `listed` of them or as many as fit on a screen, and what was left
/// out.
std::string to_text(const Overlay& overlay, OverlayHow how, std::optional<std::size_t> listed = {});

/// What an expression selected of a drawing, for a terminal: area, the largest polygons, and the
/// lines that enclose nothing.
std::string to_text(const RegionPolygons& selected, const LayerRegions& of, const SegmentSet& input,
                    std::optional<std::size_t> listed = {});

/// A picture of the pieces: in the first layer alone, in the second alone, in both.
std::string to_svg(const Overlay& overlay, OverlayHow how);

/// A picture of the drawing with what was selected of it.
std::string to_svg(const SegmentSet& input, const ExactComplex& complex, const FaceSet& selected);

}  // namespace plumbline
