#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "contenders.hpp"

namespace plumbline::bench {

/// What a case shows.
enum class Kind { Workload, Text, Command, Hostile };

/// A contender that does not take part, and why.
struct Absent {
  std::string contender, reason;
};

/// An input and who is measured on it.
struct Case {
  Kind kind = Kind::Workload;
  std::string id;     ///< for command lines
  std::string title;  ///< for tables
  std::function<SegmentSet()> make;
  std::vector<std::string> contenders;     ///< the ids of those that take part
  std::vector<Absent> absent;              ///< of those that tables have a column for
  std::optional<Cells> cells;              ///< the exact ones, where they are known
  std::optional<std::uint64_t> crossings;  ///< pairs that cross, where they are known
  unsigned limit_seconds = 180;            ///< for one run
};

/// All cases; the small ones if quick; those that need drawings only with a directory.
std::vector<Case> cases(bool quick, const std::filesystem::path& drawings);

}  // namespace plumbline::bench
