#pragma once

#include <span>
#include <string>
#include <string_view>

#include "plumbline/complex.hpp"
#include "plumbline/detail/new_file.hpp"
#include "plumbline/round.hpp"

namespace plumbline {

struct LarModel;
struct Structure;

/// The complex as JSON: vertices (exact text and nearest double), edges with their sources, faces
/// with cycles of signed edges, area, depth, interior point; components; rejected items; ledger;
/// signature. Documented in docs/json.md.
std::string to_json(const ExactComplex& complex, const SegmentSet& input);

/// The same with numbers that are proven to be those of the same complex: of `complex` itself where
/// the rounding keeps its incidences, else of the snap rounded complex, and what has changed.
std::string to_json(const ExactComplex& complex, const SegmentSet& input, const Grid& grid,
                    const Rounding& rounding);

/// The structure as JSON that `read_struct_json` reads back: definitions in order, references by
/// name, rotations as the exact matrices that they became. Throws: Error BadInput for a reference
/// to no Struct. Documented in docs/json.md.
std::string to_json(const Structure& structure);

/// The model as JSON: V and CV, V, FV and EV, or V and cells. Decimals are numbers, other
/// coordinates strings "p/q". Documented in docs/json.md.
std::string to_json(const LarModel& model);

/// The complex as an SVG picture, in the drawing's own coordinates: faces filled by nesting depth,
/// edges, antennas dashed; y negated where it runs upwards. **Rounded** to nearest doubles.
std::string to_svg(const ExactComplex& complex, bool y_up = false);

/// The segments as an SVG picture of lines, in the same way.
std::string to_svg(const SegmentSet& input);

/// The segments as rows "x1,y1,x2,y2", which `read` takes as a .lines file; the shortest decimals
/// that round to the coordinates.
std::string to_lines(std::span<const SegmentD> segments);

/// The segments in their order as rows "x1,y1,x2,y2" and the isolated points as rows "x,y", with
/// `exact_text`s. **Exact**. `read` takes it as a .lines file (it lists the points as rejected),
/// plumbline-verify as the input of a certificate.
std::string to_lines(const SegmentSet& input);

/// The edges in their order as such rows, with whole decimal expansions: what they say is the
/// complex itself, but for its isolated vertices and sources. **Exact**. Requires: coordinates are
/// decimals, as those of a Rounding are; throws Error BadInput.
std::string to_lines(const ExactComplex& complex);

}  // namespace plumbline
