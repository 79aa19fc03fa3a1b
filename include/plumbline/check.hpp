#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plumbline/check/groups.hpp"
#include "plumbline/engine.hpp"
#include "plumbline/ladder.hpp"

namespace plumbline {

/// A radius that an engine was run with.
struct TriedRadius {
  double radius = 0;
  bool is_right = false;  ///< whether its answer agreed with the exact complex
  /// How many findings it has that are not the drawing's own. None: the numbers of cells already
  /// were wrong.
  std::optional<std::size_t> findings = {};
};

/// The radii for which an engine's answer is right, as far as they were tried: every tried radius
/// from `least` to `largest` gave the exact complex; the tried ones next to them, if there are any,
/// did not. Between tried radii nothing is known.
struct RightRadii {
  double least = 0, largest = 0;
  std::vector<TriedRadius> tried;  ///< ascending
  /// One of them for people: of one digit, or the middle one of those that are right.
  std::optional<double> advised = {};

  /// Whether none of them was right; `least` and `largest` mean nothing then.
  bool empty() const {
    return std::none_of(tried.begin(), tried.end(), [](const auto& t) { return t.is_right; });
  }
};

/// A drawing held against an engine's answer: three answers side by side (as authored, over the
/// doubles, the engine's) and where they disagree.
struct Check {
  SegmentSet input;
  ExactComplex exact_complex;    ///< as authored: the file's decimals and maps, exactly
  ExactComplex doubles_complex;  ///< over the doubles: every number rounded, exact from there on
  Answer answer;
  Comparison comparison;                 ///< of the answer with the exact complex
  std::vector<Cause> causes;             ///< of the findings of `comparison`, one each, or none
  std::vector<FindingGroup> groups;      ///< of its findings: what hangs together
  Comparison conversion;                 ///< of the complex over the doubles with the exact complex
  std::vector<Cause> conversion_causes;  ///< of its findings
  /// Of the exact complex, how many vertices are nearer to another one than the answer's radius;
  /// rounded distances decide. 0 where the two agree but for the drift, or there is no radius.
  std::size_t crowded_vertices = 0;
  Drift drift;  ///< of the exact complex: what the digits leave open
  // Filled in by `advised`.
  std::optional<FeatureSize> feature_size;  ///< of the exact complex
  std::optional<ToleranceLadder> ladder;    ///< of the exact complex
  std::optional<RightRadii> right_radii;    ///< of the engine that gave the answer

  /// The verdict: the answer is right. (What the doubles alone would give is no part of it.)
  bool agree() const { return comparison.agree(); }
  /// How many findings are the drawing's own: their cause is kDrawing.
  std::size_t own_findings() const;
};

/// How to check.
struct CheckOptions {
  /// Of the comparison; by default the answer's radius, else kToleranceOfAnswers times the longer
  /// side of the drawing's box, but at least 2^-46 times its largest coordinate.
  std::optional<double> tolerance;
  /// Gives the drawing with every number of the file rounded to the nearest double, its maps
  /// applied exactly (`evaluate_rounded`): tells what parsing did from what
  /// transforming did. Called where the answers differ; without it, all is parsing.
  std::function<SegmentSet()> parsed;
  std::size_t threads = 0;  ///< 0: as many as there are cores; does not change the result
  /// Told which part of the work begins: "comparing", ...
  std::function<void(const std::string&)> begins;
};
/// Double arithmetic and 15 written digits leave an error of 1e-15 of a coordinate; crossings at
/// small angles, a drawing away from the origin and sums of errors multiply it. A factor of a
/// million is left for them, while gaps that someone drew are larger.
inline constexpr double kToleranceOfAnswers = 1e-9;

/// Holds an answer against the exact complexes: that of the input, made by `arrange(input)`, and
/// that over the doubles; of one without faces vertices and edges alone. What the answer dropped is
/// added to the input's `rejected`, its title to the input's files. Causes are kParse or kTransform
/// where rounding to doubles alone makes the finding, else a stage of the engine, confirmed by
/// exact continuation; of an engine without stages the engine itself; and before all of these
/// kDrawing where the file's digits alone make it. Causes of an engine with `with_radius` say with
/// which radius the finding is not there, which was tried. Cost: that of `arrange` and two
/// `compare`, and where they disagree for each stage an arrangement and a comparison, and as many
/// runs with smaller radii, eight at most. Throws: as `arrange`, `compare`.
Check check(SegmentSet input, ExactComplex exact_complex, Answer answer,
            const CheckOptions& options = {});

/// The arrangement of the drawing without its drift: the ends of segments take the sharpest vertex
/// of their place, and segments are led through what lies beside them; else nothing moves, so that
/// what ended on a segment does so still. **Exact**. Sources are those of the input. Requires: the
/// arrangement of the input, and its drift, which has places.
ExactComplex without_drift(const SegmentSet& input, const ExactComplex& complex, const Drift& drift,
                           std::size_t threads = 0);

/// How to give advice.
struct AdviceOptions {
  LadderOptions ladder;
  std::size_t max_runs = 12;  ///< of the engine; 0: right radii are not looked for
  std::size_t threads = 0;    ///< 0: as many as there are cores; does not change the result
  /// Told before each run which part of them is done (from 0 to 1); the work ends with Error
  /// Cancelled where it returns false.
  std::function<bool(double)> progress;
};

/// The check, with advice: the smallest exact features, the tolerance ladder, and, where the answer
/// has `with_radius`, the radii for which the engine gives the exact complex (`compare`, its
/// tolerance the radius, or that of the check where it is another one, finds nothing or what is the
/// drawing's own). Tried are the least radius there is, radii a percent below and above critical
/// ones of the ladder, and, by bisection to one percent, where right ones end. Degenerate: a
/// drawing without edges has no features. Cost: that of `tolerance_ladder`, and `max_runs` of the
/// engine and, where the numbers of cells are right, `compare`. Throws: as these; Cancelled.
Check advised(Check check, const AdviceOptions& options = {});

}  // namespace plumbline
