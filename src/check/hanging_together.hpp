#pragma once

#include <cstddef>
#include <vector>

#include "plumbline/compare.hpp"
#include "plumbline/engine.hpp"

namespace plumbline::check_steps {

/// The indices of the findings of each group, ascending; the groups by their first one. What hangs
/// together is said at `group_findings`.
std::vector<std::vector<std::size_t>> hanging_together(const Comparison& comparison,
                                                       const std::vector<Cause>& causes,
                                                       const ExactComplex& exact_complex,
                                                       const FloatComplex& answer);

}  // namespace plumbline::check_steps
