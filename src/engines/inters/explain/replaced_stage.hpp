#pragma once

#include <optional>

#include "engines/inters/explain/stages.hpp"
#include "engines/inters/explain/work.hpp"

namespace plumbline::inters {

/// The published result with one stage replaced by its exact counterpart, on the stage's own input
/// as the run has it: no quantisation (but twelve decimals), buckets that lose nothing, the exact
/// arrangement, no merging, no edge dropped, the exact cells. None where the run has no such input.
std::optional<FloatComplex> run_with_exact(const Trace& trace, Result result,
                                           const EdgeSources& raw_sources,
                                           const EdgeSources& lar_sources, Stage stage,
                                           std::size_t threads);

}  // namespace plumbline::inters
