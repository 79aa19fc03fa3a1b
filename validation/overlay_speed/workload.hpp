#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

/// What workloads.py wrote: two sets of rings on a grid of integers, what is asked of them, and
/// whether each set is a valid multipolygon.
namespace workload {

using Ring = std::vector<std::array<std::int64_t, 2>>;

struct Workload {
  std::string operation, rule, validity;
  std::array<std::vector<Ring>, 2> sets;
};

inline Workload read(const char* file) {
  std::ifstream in(file);
  std::string line;
  Workload result;
  std::getline(in, line);
  std::istringstream(line) >> result.operation >> result.rule >> result.validity;
  while (std::getline(in, line)) {
    std::istringstream numbers(line.substr(1));
    Ring ring;
    for (std::int64_t x = 0, y = 0; numbers >> x >> y;) ring.push_back({x, y});
    result.sets[line[0] == 'A' ? 0 : 1].push_back(std::move(ring));
  }
  if (result.sets[0].empty() || result.sets[1].empty()) {
    std::cerr << "no workload: " << file << '\n';
    std::exit(2);
  }
  return result;
}

/// Peak of the resident memory in MiB, of this process alone: what getrusage says holds its
/// parent's.
inline double peak_mib() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word == "VmHWM:" && status >> word) return std::stod(word) / 1024;
  }
  return 0;
}

/// Measures one call between what it is given and what it gives.
class Measure {
 public:
  Measure() : before_(peak_mib()), start_(std::chrono::steady_clock::now()) {}
  /// Prints milliseconds, MiB above what was there, polygons and twice their area.
  void end() {
    ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_)
              .count(),
    peak_ = peak_mib() - before_;
  }
  void print(std::size_t polygons, double area) const {
    std::cout.precision(17);
    std::cout << ms_ << ' ' << peak_ << ' ' << polygons << ' ' << area << '\n';
  }

 private:
  double before_ = 0, ms_ = 0, peak_ = 0;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace workload
