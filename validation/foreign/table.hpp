#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cases/foreign/foreign.hpp"

namespace plumbline::foreign {

/// What was found on the cases of one file.
struct Row {
  std::string file;
  std::string error;  ///< why nothing was read, if so
  std::size_t cases = 0, segments = 0, points = 0, rejected = 0;
  std::size_t vertices = 0, edges = 0, faces = 0, components = 0;
  std::size_t engines_differ = 0, invariants_broken = 0, refused = 0, relations_broken = 0;
  std::size_t claims = 0;
  std::vector<std::string> contradicted;  ///< claims that do not hold
  /// Claims of an area that hold, since their corners were rounded, and are off by a hundredth.
  std::vector<std::string> differ_by_rounding;
  std::map<std::string, std::size_t> rejected_by_reason;
  std::map<std::string, std::size_t> unexamined;  ///< operations, by name

  bool is_right() const {
    return engines_differ + invariants_broken + refused + relations_broken == 0;
  }
};

/// Both engines, the invariants, the checker, all relations and the claims on every case of a file.
Row examined(const std::filesystem::path& file, const std::string& name);

/// The rows as markdown, with a summary, the reasons for rejection, and every claim that does not
/// hold.
std::string table(const std::vector<Row>& rows);

}  // namespace plumbline::foreign
