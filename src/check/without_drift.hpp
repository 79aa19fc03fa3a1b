#pragma once

#include <cstddef>

#include "plumbline/check.hpp"

namespace plumbline::check_steps {

/// The arrangement of the drawing without its drift: the ends of segments take the sharpest vertex
/// of their place, and segments are led through what lies beside them; else nothing moves, so that
/// what ended on a segment does so still. **Exact**. Sources are those of the input.
ExactComplex without_drift(const SegmentSet& input, const ExactComplex& complex, const Drift& drift,
                           std::size_t threads);

/// How many vertices go where each place of the drift becomes one.
std::size_t vertices_in_drift(const Drift& drift);

/// How many findings of this comparison are not the file's own, as `take_from_drawing` finds out.
/// Requires: `without` is `without_drift` of the exact complex.
std::size_t findings_beside_drift(const Comparison& comparison, const ExactComplex& exact_complex,
                                  const ExactComplex& without, const Drift& drift);

/// Gives findings that are the file's own the cause kDrawing: the drawing without its drift,
/// arranged exactly, has findings about all of their cells, too, or they follow from such findings;
/// nothing is moved further than the drift. Cost: none without drift or findings, else an
/// arrangement and a comparison.
void take_from_drawing(Check& check, std::size_t threads);

}  // namespace plumbline::check_steps
