#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline {

/// The items that a reader refuses, or has a note on. The first kListed are listed one by one, of
/// the others each reason once with how many they are: a file of nothing but errors takes no more
/// memory than a drawing.
class Rejections {
 public:
  static constexpr std::size_t kListed = 10'000;

  void add(const Source& source, const std::string& reason, const std::string& text,
           bool harmless = false);
  std::vector<Rejected> finish() &&;

 private:
  static constexpr std::size_t kReasons = 1'000;
  /// Items beyond those that are listed one by one.
  struct Unlisted {
    Source first;
    std::uint64_t count = 0;
    bool harmless = true;
  };

  std::vector<Rejected> listed_;
  std::map<std::string, Unlisted> unlisted_;  ///< by reason
};

}  // namespace plumbline
