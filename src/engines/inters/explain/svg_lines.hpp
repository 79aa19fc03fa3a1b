#pragma once

#include <string_view>
#include <vector>

#include "plumbline/engine.hpp"

namespace plumbline::inters {

/// What the published svg2lines does not read, or misreads, of an SVG text that gave the input: a
/// finding about the complex per rule (S1 to S7 of docs/divergences.md), with the segments that it
/// concerns, at stage Parse. Requires: `input` was read from this text, so that its sources have
/// the text's lines. Order: by rule. Cost: O(text + segments).
std::vector<Explained> svg_to_lines_findings(std::string_view svg, const SegmentSet& input);

}  // namespace plumbline::inters
