// Workloads by their names, and what is known of them.

#include <cmath>
#include <cstdlib>

#include "inputs/workloads.hpp"
#include "plumbline/error.hpp"

namespace plumbline::inputs {
namespace {

std::uint64_t size_of(const std::string& name) {
  const std::size_t underscore = name.find('_');
  const char* digits = underscore == std::string::npos ? "" : name.c_str() + underscore + 1;
  char* end = nullptr;
  const double size = std::strtod(digits, &end);
  if (end == digits || *end != '\0' || !(size >= 1 && size <= 1e8) || size != std::floor(size)) {
    throw Error(ErrorCode::BadInput, "not the name of a workload", {}, name);
  }
  return static_cast<std::uint64_t>(size);
}

}  // namespace

SegmentSet workload(const std::string& name, const std::filesystem::path& directory) {
  const std::uint64_t size = size_of(name);
  const std::string family = name.substr(0, name.find('_'));
  if (family == "R1") return random_segments(size);
  if (family == "R5") return random_lines(size);
  if (family == "G") return grid(size);
  if (family == "Gr") return turned_grid(size);
  if (family == "D") return lattice_segments(size);
  if (family == "S") return stars(size);
  if (family == "S1") return pencil(size);
  if (family == "F") return double_segments(size);
  if (family == "T") return turned_rooms(size);
  if (family == "Q") return rational_copies(size);
  if (family == "I") return tiny_pieces(size);
  if (family == "L") return streets(size);
  if (family == "W") return double_walls(size);
  if (family == "P") return tiles(hospital(directory), size, 100, 130);
  throw Error(ErrorCode::BadInput, "not the name of a workload", {}, name);
}

const std::vector<Known>& known() {
  static const std::vector<Known> all{
      {"R1_1e3", 1000, 3138, 3276, 382, 1138},
      {"R1_1e4", 10000, 30299, 30598, 2876, 10299},
      {"R1_1e5", 100000, 300928, 301856, 27785, 100928},
      {"R1_1e6", 1000000, 3002187, 3004384, 272513, 1002189},
      {"R5_5e3", 5000, 31066, 47132, 16184, 21066},
      {"R5_1e5", 100000, 985421, 1670842, 686025, 785421},
      {"G_300", 600, 91200, 180600, 89402, 90000},
      {"G_1000", 2000, 1004000, 2002000, 998002, 1000000},
      {"Gr_300", 600, 91200, 180600, 89402, 90000},
      {"Gr_1000", 2000, 1004000, 2002000, 998002, 1000000},
      {"D_1e4", 10000, 34965, 72018, 37062, 71721},
      {"D_1e5", 100000, 355562, 748230, 392735, 772058},
      {"D_1e6", 1000000, 3567096, 7537667, 3971098, 7821368},
      {"S_1e4", 10000, 20266, 20342, 137, 495155},
      {"S_1e5", 100000, 203205, 204464, 1810, 4951944},
      {"S1_1e3", 1000, 2001, 2000, 1, 499500},
      {"T_100", 40000, 10201, 20200, 10001, 0},
      {"P_1", 7439, 1162, 1499, 414, 4620},
      {"P_10", 74390, 11620, 14990, 4131, 46200},
      {"P_100", 743900, 116200, 149900, 41301, 462000},
  };
  return all;
}

const Known* known(const std::string& name) {
  for (const Known& k : known()) {
    if (name == k.name) return &k;
  }
  return nullptr;
}

}  // namespace plumbline::inputs
