#pragma once

#include <string>

#include "cli/commands.hpp"
#include "plumbline/plumbline.hpp"

namespace plumbline::cli {

/// A drawing with its exact arrangement, which has passed all its checks.
struct Drawing {
  Structure structure;
  SegmentSet input;
  ExactComplex complex;
};

/// Reads, arranges and validates. Throws: Error; code Internal, with the first violation, if the
/// exact arrangement fails a check or the engines differ.
Drawing load(const DrawingArguments& arguments);

}  // namespace plumbline::cli
