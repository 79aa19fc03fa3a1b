#pragma once

#include "output/svg/panel.hpp"
#include "plumbline/check.hpp"

namespace plumbline::svg {

/// The cells of one side that the findings speak of. A face that is only reshaped is not filled:
/// the edges that reshape it are marked.
Marks marks_of(const Comparison& comparison, const Incidences& complex,
               std::vector<std::size_t> Finding::*cells);

}  // namespace plumbline::svg
