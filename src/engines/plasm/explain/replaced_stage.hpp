#pragma once

#include "engines/plasm/explain/stages.hpp"
#include "plumbline/engine.hpp"
#include "plumbline/engines/plasm.hpp"

namespace plumbline::plasm {

/// The edges of the merged graph and the isolated points.
LineWork merged_work(const Trace& trace);

/// The result with one stage replaced by its exact counterpart, on the stage's own input as the run
/// has it: the exact arrangement, nothing merged but what is equal, no edge dropped, exact cells.
FloatComplex run_with_exact(const Trace& trace, Stage stage, std::size_t threads);

}  // namespace plumbline::plasm
