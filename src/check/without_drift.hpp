#pragma once

#include <cstddef>

#include "plumbline/check.hpp"

namespace plumbline::check_steps {

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
