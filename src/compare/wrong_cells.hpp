#pragma once

#include <array>
#include <optional>
#include <vector>

#include "plumbline/compare.hpp"

namespace plumbline::compare_steps {

/// `compare` for those who ask only which cells are in findings: there are no distances and
/// areas, no messages but of cells that lack a counterpart, and places only of vertices that do;
/// where an invalid complex overlaps or leaves gaps is not looked for (findings that have other
/// invariants than Area are all there). Findings of holes and of faces without exact cells can be
/// wrong, unless the correspondence of faces is asked for, which costs more than all the rest.
Comparison compare_cells(const ExactComplex& exact_complex, const ExactComplex& other_complex,
                         double tolerance, bool with_correspondence);
Comparison compare_cells(const ExactComplex& exact_complex, const FloatComplex& float_complex,
                         double tolerance, bool with_correspondence);
/// Whether `WrongCells` needs the correspondence of faces to find the same as this finding.
bool takes_correspondence(const Finding& finding);

/// The cells that a comparison finds fault with, to ask whether another one of the same exact
/// complex has a finding too.
class WrongCells {
 public:
  WrongCells(const Comparison& comparison, const ExactComplex& exact_complex);

  /// Whether there is a finding about the same: of the same kind, with a common exact cell or,
  /// for cells that only the float side has, a common segment.
  bool has(const Finding& finding) const;
  /// The index of the first such finding; none if `has` is false.
  std::optional<std::size_t> same(const Finding& finding) const;
  /// How much of it there is: 0 if `has` is false; the most of its exact cells that one finding of
  /// its kind is about; `whole` if one has the same disagreement and exact cells and as many
  /// others. Requires, of faces and holes: the comparison is one with their correspondence. Of
  /// cells that only the float side has: 0 or `whole`.
  std::size_t extent(const Finding& finding) const;
  static std::size_t whole(const Finding& finding) { return finding.exact_cells.size() + 1; }

 private:
  static constexpr std::size_t kKinds = 5;

  bool is_near(const Finding& finding, const Finding& other) const;
  std::optional<std::size_t> same_place(const Finding& finding) const;

  const Comparison& comparison_;
  /// Per kind and exact cell the first finding that it is in, plus 1.
  std::array<std::vector<std::size_t>, kKinds> by_cell_;
  /// Per kind the exact cells that are in findings, with each finding, ascending.
  std::array<std::vector<std::pair<std::size_t, std::size_t>>, kKinds> in_findings_;
  /// Per kind the findings that have no exact cell, by segment.
  std::array<std::vector<std::pair<SegmentId, std::size_t>>, kKinds> by_segment_;
};

}  // namespace plumbline::compare_steps
