#pragma once

#include <functional>
#include <string>

#include "plumbline/geometry.hpp"

namespace plumbline::campaign {

using Fails = std::function<bool(const SegmentSet&)>;

/// An input that still fails, of which no segment or point can be left out (delta debugging: Zeller
/// and Hildebrandt, "Simplifying and isolating failure-inducing input", 2002) and whose coordinates
/// have few digits: none can be replaced, everywhere it occurs, by one of the simpler numbers that
/// are tried. Requires: the input fails.
SegmentSet minimised(const SegmentSet& input, const Fails& fails);

/// The input that the rows of a .lines file are, "ax,ay,bx,by" per segment and "x,y" per point.
/// Throws: Error BadInput.
SegmentSet from_rows(const std::string& text);

}  // namespace plumbline::campaign
