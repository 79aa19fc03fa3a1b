// Delta debugging: Zeller and Hildebrandt, "Simplifying and isolating failure-inducing input",
// IEEE Transactions on Software Engineering 28 (2002), the algorithm ddmin.

#include <algorithm>

#include "minimise/steps.hpp"

namespace plumbline::minimise_steps {
namespace {

/// Part i of n, or all but that.
Lines part(const Lines& lines, std::size_t i, std::size_t n, bool is_left_out) {
  const std::size_t first = i * lines.size() / n, end = (i + 1) * lines.size() / n;
  Lines result;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if ((first <= k && k < end) != is_left_out) result.push_back(lines[k]);
  }
  return result;
}

}  // namespace

Lines fewest(Lines lines, Trials& trials) {
  for (std::size_t n = 2; lines.size() >= 2 && !trials.have_ended();) {
    n = std::min(n, lines.size());
    const auto reduce = [&](bool to_complement) {
      for (std::size_t i = 0; i < n; ++i) {
        Lines smaller = part(lines, i, n, to_complement);
        if (smaller.empty() || !trials.show(smaller)) continue;
        lines = std::move(smaller);
        return true;
      }
      return false;
    };
    if (reduce(false)) {
      n = 2;
    } else if (n > 2 && reduce(true)) {
      n = std::max<std::size_t>(n - 1, 2);
    } else if (n < lines.size()) {
      n = 2 * n;
    } else {
      break;
    }
  }
  return lines;
}

}  // namespace plumbline::minimise_steps
