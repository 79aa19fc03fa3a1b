#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include "plumbline/minimise.hpp"

/// The steps of `minimised`, in their order. Each returns a drawing that shows the outcome, the
/// given one where it finds no smaller or simpler one.
namespace plumbline::minimise_steps {

/// A segment on trial: ax, ay, bx, by.
struct Line {
  std::array<double, 4> numbers{};
  double rounding = 0;     ///< as in SegmentSet; 0 once a number is changed
  std::size_t origin = 0;  ///< which segment of the input it was

  friend bool operator==(const Line& a, const Line& b) { return a.numbers == b.numbers; }
};
using Lines = std::vector<Line>;

/// The segments of the input in doubles, those without length left out.
Lines lines_of(const SegmentSet& input);
/// The drawing; `input` tells sources and the like.
SegmentSet drawing_of(const Lines& lines, const SegmentSet& input);

/// Runs of the engine, counted, each drawing once.
class Trials {
 public:
  Trials(const SegmentSet& input, const Engine& engine, const Parameters& parameters,
         const MinimiseOptions& options);

  /// The drawing checked, by causes of the engine as a whole or of its stages. Throws: as
  /// `minimised`.
  Check checked(const Lines& lines, bool by_stages);
  /// Whether the shortest decimals of the numbers, taken as exact, show what is sought.
  bool show_in_decimals(const Lines& lines);
  /// What all later drawings are to show.
  void seek(const Outcome& outcome, bool is_representable);
  /// Whether the drawing shows that; if it can be held by doubles, all later ones must be, too.
  /// False once the runs have ended.
  bool show(const Lines& lines);

  const Outcome& sought() const { return sought_; }
  std::size_t runs() const { return runs_; }
  /// Whether a run was wanted that there was not.
  bool have_ended() const { return have_ended_; }

 private:
  struct Verdict {
    bool is_same = false;
    bool is_representable = false;
  };
  Check checked(SegmentSet drawing, bool by_stages);
  Answer answered(const SegmentSet& drawing);
  Verdict verdict(const Lines& lines);

  const SegmentSet& input_;
  const Engine& engine_;
  const Parameters& parameters_;
  const MinimiseOptions& options_;
  Outcome sought_;
  bool must_be_representable_ = false;
  std::size_t runs_ = 0;
  bool have_ended_ = false;
  std::unordered_map<std::string, Verdict> known_;
};

/// In an order, and each in a direction, that do not depend on those of the input.
Lines in_own_order(const Lines& lines, Trials& trials);
/// The segments that a finding of the sought kind names, or those nearest to it.
Lines near_a_finding(const Lines& lines, Trials& trials);
/// Without any segment that can be left out.
Lines fewest(Lines lines, Trials& trials);
/// With simpler numbers, all moved, scaled or rounded together.
Lines simpler_together(Lines lines, Trials& trials);
/// With simpler numbers one by one.
Lines simpler_one_by_one(Lines lines, Trials& trials);

/// What makes a number simple: few characters; of equally many a small absolute value; 1 before -1.
struct Simplicity {
  std::size_t characters = 0;
  double size = 0;

  friend auto operator<=>(const Simplicity&, const Simplicity&) = default;
};
Simplicity simplicity(double number);
/// That of all numbers together.
Simplicity simplicity(const Lines& lines);
/// The number with so many significant decimal digits. **Rounded**.
double with_digits(double number, int digits);

}  // namespace plumbline::minimise_steps
