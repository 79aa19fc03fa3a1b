#pragma once

#include <string>
#include <vector>

#include "cases.hpp"

namespace plumbline::bench {

/// One run in a process of its own.
struct Measure {
  std::string failure;  ///< empty when it ended well
  Cells cells;
  std::size_t segments = 0;
  double seconds = 0;
  /// Peak of the resident memory during the run above what was resident before, in bytes.
  double peak = 0;
};

/// Runs this program again with the arguments, which must make it call `measure_here`; what it
/// printed, or how it failed.
Measure measure_in_fresh_process(const std::vector<std::string>& arguments);

/// Runs one contender once, within the case's time and this machine's memory, and prints a line for
/// `measure_in_fresh_process`. Ended by SIGALRM beyond the time.
void measure_here(const Case& input, const Contender& contender);

}  // namespace plumbline::bench
