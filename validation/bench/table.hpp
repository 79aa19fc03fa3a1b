#pragma once

#include <map>
#include <string>
#include <vector>

#include "cases.hpp"
#include "fresh_process.hpp"

namespace plumbline::bench {

/// All that was measured of a case, per contender id.
struct Row {
  Case input;
  std::size_t segments = 0;
  std::map<std::string, Measure> measures;  ///< one run each, in a process of its own
  std::map<std::string, double> seconds;    ///< medians, all in one process
};

/// Markdown: times and ratios against the aims, time and memory per item, reading, hostile inputs.
std::string tables(const std::vector<Row>& rows);

}  // namespace plumbline::bench
