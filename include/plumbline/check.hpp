#pragma once

#include <functional>
#include <optional>
#include <string>

#include "plumbline/compare.hpp"
#include "plumbline/engines/files.hpp"
#include "plumbline/engines/inters.hpp"
#include "plumbline/ladder.hpp"
#include "plumbline/structure.hpp"

namespace plumbline {

/// A drawing held against a float result: three answers side by side (as authored, over the
/// doubles, within a tolerance) and where they disagree.
struct Check {
  SegmentSet input;
  ExactComplex exact_complex;    ///< as authored: the file's decimals and maps, exactly
  ExactComplex doubles_complex;  ///< over the doubles: every number rounded, exact from there on
  FloatComplex float_complex;    ///< the float result
  std::string result;            ///< its name: "repaired", "published", or the file it came from
  std::optional<double> radius;  ///< of the float pipeline; none for a result from a file
  Crosscheck crosscheck;         ///< of the float result with the exact complex
  Crosscheck conversion;         ///< of the complex over the doubles with the exact complex
  // Filled in by `advised`.
  std::optional<FeatureSize> feature_size;  ///< of the exact complex
  std::optional<ToleranceLadder> ladder;    ///< of the exact complex
  std::optional<RightRadii> right_radii;

  /// The verdict: the float result is right. (What the doubles alone would give is no part of it.)
  bool agree() const { return crosscheck.agree(); }
};

/// Which run of the published pipeline to check.
struct PublishedCheck {
  int decimals = lar::published::kDecimals;
  PublishedResult result = PublishedResult::LarFromLines;
  /// What the pipeline is given for the input's segments, in their order; by default their nearest
  /// doubles. For maps done in floats, as that to the unit square.
  std::optional<std::vector<SegmentD>> lines;
  /// The SVG text that the input was read from: then what the published svg2lines would misread is
  /// found, too.
  std::optional<std::string> svg = std::nullopt;
};

/// How to check.
struct CheckOptions {
  std::optional<double> radius;     ///< of the float pipeline; by default its own
  std::optional<double> tolerance;  ///< of the comparison; by default the radius
  /// Gives the drawing with every number of the file rounded to the nearest double, its maps
  /// applied exactly (`evaluate(rounded(structure))`): tells what parsing did from what
  /// transforming did. Called where the answers differ; without it, all is parsing.
  std::function<SegmentSet()> parsed;
  std::size_t threads = 0;  ///< 0: as many as there are cores; does not change the result
  std::optional<PublishedCheck> published;  ///< check the published pipeline, not the repaired one
};

/// Runs the float LAR pipeline on the drawing and holds it against the exact complexes: that of the
/// input, made by `arrange(input)`, and that over the doubles. Cost: that of the three, and of
/// `crosscheck`. Throws: as `arrange`, `lar::arrange`, `crosscheck`.
Check check(SegmentSet input, ExactComplex exact_complex, const CheckOptions& options = {});

/// Holds a result that another program made of the drawing against the exact complexes, in the same
/// way; of one without faces vertices and edges alone. Its `rejected` items are added to those of
/// the input, its file to the input's files. Default tolerance: kForeignTolerance times the longer
/// side of the drawing's box, but at least lar::kLeastRelativeRadius times its largest coordinate.
/// Causes are Parse or Transform where rounding to doubles alone makes the finding, else Foreign.
/// Throws: as `crosscheck`.
Check check_against(SegmentSet input, ExactComplex exact_complex, ForeignResult foreign,
                    const CheckOptions& options = {});
/// Double arithmetic and 15 written digits leave an error of 1e-15 of a coordinate; crossings at
/// small angles, a drawing away from the origin and sums of errors multiply it. A factor of a
/// million is left for them, while gaps that someone drew are larger.
inline constexpr double kForeignTolerance = 1e-9;

/// How to give advice.
struct AdviceOptions {
  LadderOptions ladder;
  std::size_t max_runs = 12;  ///< of the float pipeline; 0: right radii are not looked for
  std::size_t threads = 0;    ///< 0: as many as there are cores; does not change the result
  /// Told before each run which part of them is done (from 0 to 1); the work ends with Error
  /// Cancelled where it returns false.
  std::function<bool(double)> progress;
};

/// The check, with advice: the smallest exact features, the tolerance ladder, and, where the result
/// is that of our float pipeline, the radii for which `lar::arrange` gives the exact complex
/// (`crosscheck` agrees, its tolerance the radius). Tried are the least radius there is, radii a
/// percent below and above critical ones of the ladder, and, by bisection to one percent, where
/// right ones end. Degenerate: a drawing without edges has no features. Cost: that of
/// `tolerance_ladder`, and `max_runs` of `lar::arrange` and, where the numbers of cells are right,
/// `crosscheck`. Throws: as these; Cancelled.
Check advised(Check check, const AdviceOptions& options = {});

}  // namespace plumbline
