#pragma once

#include "plumbline/check.hpp"

namespace plumbline::check_steps {

/// The radii for which the engine gives the exact complex, but for the drawing's own drift, tried
/// as `advised` says. Requires: an answer with `with_radius`; a ladder; options.max_runs > 0.
RightRadii right_radii(const Check& check, const AdviceOptions& options);

}  // namespace plumbline::check_steps
