#pragma once

#include <string>

#include "repair/drawings.hpp"

namespace plumbline::repairs {

/// What became of a trial.
struct Verdict {
  std::string broken;     ///< the first promise that is broken, a few words; none: all are kept
  std::string detail;     ///< more of it
  std::size_t edits = 0;  ///< of the repair
  std::size_t refused = 0;
  std::size_t stayed = 0;    ///< welds given up for the sake of a promise
  std::size_t given_up = 0;  ///< operations given up as a whole
};

/// Repairs, and holds the result against what is promised: nothing is thrown, `verify` finds
/// nothing, a second run with the tolerances used finds nothing to do but near what was refused,
/// `undo` makes the input again, and order, direction and repetition of segments change nothing.
Verdict judged(const Trial& trial);

}  // namespace plumbline::repairs
