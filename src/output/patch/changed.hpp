#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline::patch {

/// An element of the file whose segments changed: what stands in one place, however often it is
/// drawn.
struct Changed {
  Source source;
  std::size_t drawn = 0;         ///< how often
  std::vector<SegmentId> lines;  ///< of the output, that are now its
};

struct Changes {
  std::vector<Changed> elements;  ///< by line and column
  std::vector<SegmentId> added;   ///< of the output, of no element of the file

  bool empty() const { return elements.empty() && added.empty(); }
};

/// Compares what each element has in input and output, as sets of segments.
Changes changes_of(const SegmentSet& input, const SegmentSet& output,
                   const std::vector<bool>& also);

/// A text between two bytes that others take the place of.
struct Replacement {
  std::size_t begin, end;
  std::string text;
};
/// The text with all of them. Requires: they do not overlap.
std::string replaced(std::string_view text, std::vector<Replacement> replacements);

/// The exact decimal, or else the shortest one of the nearest double.
std::string coordinate(const Number& number);

}  // namespace plumbline::patch
