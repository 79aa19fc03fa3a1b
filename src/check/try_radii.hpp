#pragma once

#include <cstddef>
#include <optional>

#include "plumbline/check.hpp"

namespace plumbline::check_steps {

/// Runs the engine with smaller radii, eight of them at most for all findings together (five
/// of large drawings), and gives each cause of the engine Cause::radius_without; its advice, where
/// it has none, says so. Tried are radii just below what was joined (Cause::distance), or quantiles
/// of these; then, where findings are left, the least radius that there is, and some between. Each
/// is compared with `tolerance`, by default with its own radius. Cost: per radius a run and a
/// comparison; none without Answer::with_radius.
void try_radii(Check& check, std::optional<double> tolerance, std::size_t threads);

}  // namespace plumbline::check_steps
