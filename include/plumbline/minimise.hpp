#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "plumbline/check.hpp"

/// A wrong answer of an engine, brought down to the fewest segments and the simplest numbers that
/// still show it.
namespace plumbline {

/// What an answer is as a whole, by the gravest of what is wrong. In the order of gravity.
enum class OutcomeClass {
  Loud,      ///< the engine itself says that it has no result
  Invalid,   ///< the answer by itself is no complex
  Topology,  ///< it is one, but another one
  Moved,     ///< the same cells, but elsewhere or with other boundaries
  Right,     ///< nothing is wrong but what is the drawing's own
};
std::string to_text(OutcomeClass outcome_class);  ///< "loud", "invalid", ...

struct Outcome {
  OutcomeClass outcome_class = OutcomeClass::Right;
  /// Of Loud what the engine says, up to where details begin, numbers as #; of Invalid the broken
  /// invariant; else "face lost", "edge extra", ...; "" where it is right.
  std::string kind;
  std::size_t finding = 0;  ///< the number of the gravest finding, the first of its kind; 0: none

  /// Whether the same is wrong.
  friend bool is_same(const Outcome& a, const Outcome& b) {
    return a.outcome_class == b.outcome_class && a.kind == b.kind;
  }
};
/// The outcome of a check. Findings whose cause is kDrawing, kParse or kTransform do not count:
/// they are not the engine's.
Outcome outcome(const Check& check);

/// How to minimise.
struct MinimiseOptions {
  std::optional<double>
      tolerance;                  ///< of comparisons; by default that of `check`, for each drawing
  std::size_t max_runs = 20'000;  ///< of the engine; then it ends with what there is
  /// Asked before each run; it ends with what there is where this returns true.
  std::function<bool()> enough;
  std::size_t threads = 0;  ///< 0: as many as there are cores; does not change the result
  /// Told before each run how many there were and how many segments are left; the work ends with
  /// Error Cancelled where it returns false.
  std::function<bool(std::size_t runs, std::size_t segments)> progress;
};

/// A drawing that shows what is wrong with an engine.
struct Minimised {
  /// The segments that are left; their sources are those of the input. Of an engine that is right
  /// the whole input in doubles.
  SegmentSet drawing;
  std::string engine;               ///< its name
  Parameters parameters;            ///< that were given; they stayed as they were
  Outcome outcome;                  ///< the same as that of the input
  Check check;                      ///< of `drawing`, with causes
  std::size_t segments_before = 0;  ///< of the input
  std::size_t runs = 0;             ///< of the engine
  /// Whether no single segment can be left out; else the runs were not enough.
  bool is_one_minimal = false;
  /// Whether none of the simpler numbers that are tried can take the place of one.
  bool has_simple_numbers = false;
  /// Whether the exact arrangement of `drawing`, every vertex rounded to doubles, has the same
  /// incidences: then there is a right answer in doubles.
  bool is_representable = false;
  /// Whether the shortest decimals that round to its numbers, taken as exact, show the same: then
  /// a file of these does.
  bool holds_in_decimals = false;
  /// The radius that the engine chose for the input, where it chose another one for `drawing`.
  std::optional<double> radius_before = {};
};

/// The input, every number replaced by its nearest double and these taken as exact, reduced to a
/// drawing with the same outcome. It first looks near one finding for a few segments that show it;
/// then leaves out segments by delta debugging (Zeller and Hildebrandt, "Simplifying and isolating
/// failure-inducing input", 2002) until none can be left out; then moves it to the origin, and
/// replaces coordinates by ones with fewer digits; and all of this again until nothing changes. So
/// what comes out is minimised to itself, unless runs ended. Where the exact arrangement of a
/// drawing on the way can be held by doubles (`is_kept_by_simple_rounding`), that of every smaller
/// one can, too. An exception of the engine is an outcome, `Loud`. Isolated points are left out.
/// Order: where the outcome does not depend on the order and direction of the segments, nor does
/// the result. Cost: for each run an arrangement and a comparison; some hundred to some thousand
/// runs. Throws: Error BadInput or BadFile as the engine does for the input; as `arrange`;
/// Cancelled.
Minimised minimised(const SegmentSet& input, const Engine& engine,
                    const Parameters& parameters = {}, const MinimiseOptions& options = {});

}  // namespace plumbline
