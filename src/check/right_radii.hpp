#pragma once

#include "plumbline/check.hpp"

namespace plumbline::check_steps {

/// The radii for which the engine gives the exact complex, tried as `advised` says. Requires: the
/// ladder of this complex, the complex of this input; options.max_runs > 0.
RightRadii right_radii(const WithRadius& engine, const SegmentSet& input,
                       const ExactComplex& exact_complex, const ToleranceLadder& ladder,
                       const AdviceOptions& options);

}  // namespace plumbline::check_steps
