#pragma once

#include <string>

#include "plumbline/plumbline.hpp"

namespace plumbline::cli {

/// A drawing with its exact arrangement, which has passed all its checks.
struct Drawing {
  SegmentSet input;
  ExactComplex complex;
};

/// Reads, arranges and validates. Throws: Error; code Internal, with the first violation, if the
/// exact arrangement fails a check.
Drawing load(const std::string& file);

}  // namespace plumbline::cli
