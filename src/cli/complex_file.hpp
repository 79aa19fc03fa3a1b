#pragma once

#include <string>
#include <string_view>

#include "cli/commands.hpp"
#include "cli/load.hpp"

namespace plumbline::cli {

/// Whether a complex in this format is rounded, and proven, without --safe, too.
bool is_always_rounded(std::string_view format);

/// What `arrange` writes.
struct ComplexFile {
  std::string content;
  std::string line;  ///< for the terminal: what rounding did; "" for what is not rounded
};
/// The drawing in this format: as it is, or rounded and proven to be a valid complex. Requires: one
/// of complex_formats(). Throws: Error.
ComplexFile complex_file(std::string_view format, const ArrangeArguments& arguments,
                         const Drawing& drawing);

/// Requires: one of feature_formats(), or of finding_formats().
std::string feature_file(std::string_view format, const Features& features);

}  // namespace plumbline::cli
