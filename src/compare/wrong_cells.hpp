#pragma once

#include <array>
#include <vector>

#include "plumbline/compare.hpp"

namespace plumbline::checking {

/// The cells that a cross-check finds fault with, to ask whether another one of the same exact
/// complex has a finding too.
class WrongCells {
 public:
  WrongCells(const Crosscheck& crosscheck, const ExactComplex& exact_complex);

  /// Whether there is a finding about the same: of the same kind, with a common exact cell or,
  /// for cells that only the float side has, a common segment.
  bool has(const Finding& finding) const;
  /// The first such finding; none if `has` is false.
  const Finding* same(const Finding& finding) const;

 private:
  static constexpr std::size_t kKinds = 5;

  bool is_near(const Finding& finding, const Finding& other) const;

  const Crosscheck& crosscheck_;
  /// Per kind and exact cell the finding that it is in, plus 1.
  std::array<std::vector<std::size_t>, kKinds> by_cell_;
  /// Per kind the findings that have no exact cell, by segment.
  std::array<std::vector<std::pair<SegmentId, std::size_t>>, kKinds> by_segment_;
};

}  // namespace plumbline::checking
