#pragma once

#include <map>
#include <string>
#include <vector>

#include "contenders.hpp"

namespace plumbline::bench {

struct Timed {
  const Contender* contender;
  Job job;
  int repetitions;
};

/// Sets Google Benchmark up, with the repetitions of all contenders in random order.
void initialize_timing();

/// Median of the wall clock seconds of one run, per contender id. Results are destroyed outside the
/// time taken. Progress goes to stderr.
std::map<std::string, double> median_seconds(const std::string& title,
                                             const std::vector<Timed>& timed);

}  // namespace plumbline::bench
