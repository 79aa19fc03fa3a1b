#include "plumbline/repair.hpp"

#include "plumbline/error.hpp"
#include "repair/tolerances.hpp"

namespace plumbline {
namespace {

using namespace repair_steps;

/// More often than any drawing needs.
constexpr std::size_t kMostRounds = 100;

/// The steps, one after the other, until a round of them finds nothing to do.
class Repairing {
 public:
  Repairing(const SegmentSet& input, const RepairOptions& options, Repair& result)
      : options_(options),
        result_(result),
        work_(input, result.anchored),
        choice_(input, result.reasons) {}

  /// What is not true of the result; nothing where all is.
  std::optional<Breach> run() {
    bool is_settled = false;
    for (std::size_t round = 0; round < kMostRounds && !is_settled; ++round) {
      const std::size_t edits = work_.edits().size();
      const LineId first_looked_at = first_not_welded_;
      run_once(round == 0);
      if (work_.edits().size() > edits) continue;
      // Carriers grow with what is welded to them: in the end all of them are looked at once more.
      is_settled = first_looked_at == kFirst || sgn(result_.tolerances.weld) == 0;
      first_not_welded_ = kFirst;
    }
    if (!is_settled) return Breach{"there is no end of edits", work_.edits().back().where, {}};
    if (sgn(result_.tolerances.grow) > 0) refuse_open_ends(work_, now_, result_.tolerances.grow);
    work_.write(result_);
    result_.faces = face_outcomes(work_.input(), before_, result_, now_.complex);
    std::vector<Breach> breaches = verify(work_.input(), before_, result_, now_.complex);
    if (breaches.empty()) return std::nullopt;
    return breaches.front();
  }

 private:
  void run_once(bool is_first) {
    const std::size_t first_edit = work_.edits().size();
    work_.forget_refusals();
    look_anew();
    Tolerances& tolerances = result_.tolerances;
    merge_lines();
    if (is_first) tolerances.weld = options_.weld ? *options_.weld : choice_.weld(work_, now_);
    if (sgn(tolerances.weld) > 0) weld_lines(tolerances.weld);
    if (sgn(tolerances.snap) > 0) snap(work_, now_, tolerances.snap);
    look_anew();
    if (is_first) tolerances.grow = options_.grow ? *options_.grow : choice_.grow(work_, now_);
    if (sgn(tolerances.grow) > 0) {
      grow(work_, now_, tolerances.grow);
      look_anew();
      join_offset_ends(work_, now_, tolerances.grow);
    }
    look_anew();
    if (is_first) tolerances.trim = options_.trim ? *options_.trim : choice_.trim(work_, now_);
    if (sgn(tolerances.trim) > 0) trim(work_, now_, tolerances.trim);
    look_anew();
    if (is_first) {
      tolerances.sliver = options_.sliver ? *options_.sliver : choice_.sliver(work_, now_);
    }
    if (sgn(tolerances.sliver) > 0) {
      repeat([&] { give_slivers(work_, now_, tolerances.sliver); });
    }
    if (tolerances.doors) close_doors(work_, *tolerances.doors, options_.walls);
    look_anew();
    if (sgn(tolerances.simplify) > 0) {
      repeat([&] { simplify(work_, now_, tolerances.simplify); });
    }
    dissolve(work_, first_edit);
  }

  /// Until it finds nothing to do, which is sure to be: each time something goes.
  template <class Step>
  void repeat(const Step& step) {
    for (std::size_t edits = static_cast<std::size_t>(-1); edits != work_.edits().size();) {
      edits = work_.edits().size();
      step();
      look_anew();
    }
  }

  void merge_lines() {
    const std::size_t edits = work_.edits().size();
    merge(work_, now_);
    if (work_.edits().size() == edits) return;
    rename_lines(now_, work_);
    looked_at_ = work_.edits().size();
  }

  /// Until nothing moves any more.
  void weld_lines(const Rational& distance) {
    for (std::size_t round = 0; round < kMostRounds; ++round) {
      const std::size_t edits = work_.edits().size(), lines = work_.count();
      weld(work_, now_, distance, first_not_welded_);
      first_not_welded_ = LineId(lines);
      if (work_.edits().size() == edits) return;
      look_anew();
      merge_lines();
    }
  }

  /// Arranges the lines if they have changed.
  void look_anew() {
    if (looked_at_ == work_.edits().size()) return;
    looked_at_ = work_.edits().size();
    now_ = arranged(work_);
    if (looked_at_ == 0) before_ = now_.complex;
  }

  static constexpr LineId kFirst{std::size_t{0}};

  const RepairOptions& options_;
  Repair& result_;
  Work work_;
  Choice choice_;
  Arranged now_;
  LineId first_not_welded_ = kFirst;  ///< lines before are known to go nowhere
  ExactComplex before_;
  std::size_t looked_at_ = static_cast<std::size_t>(-1);  ///< edits of which `now_` knows
};

/// Turns off the operation that goes furthest, and says so: something else was in its way. Throws:
/// Error Internal where none is on.
Refusal give_up_one(RepairOptions& options, const Tolerances& used, const Breach& breach) {
  const auto refusal = [&](EditKind kind, const Rational& size) {
    return Refusal{kind,
                   breach.where,
                   size * size,
                   "given up as a whole, since it would break a promise: " + breach.message,
                   {}};
  };
  for (const auto& [kind, size, option] :
       {std::tuple(EditKind::Simplify, &used.simplify, &options.simplify),
        std::tuple(EditKind::Snap, &used.snap, &options.snap)}) {
    if (sgn(*size) == 0) continue;
    *option = 0;
    return refusal(kind, *size);
  }
  for (const auto& [kind, size, option] :
       {std::tuple(EditKind::Weld, &used.weld, &options.weld),
        std::tuple(EditKind::Sliver, &used.sliver, &options.sliver),
        std::tuple(EditKind::Trim, &used.trim, &options.trim),
        std::tuple(EditKind::Grow, &used.grow, &options.grow)}) {
    if (sgn(*size) == 0) continue;
    *option = 0;
    return refusal(kind, *size);
  }
  throw Error(ErrorCode::Internal, "a repair breaks its promise: " + breach.message, {},
              to_text(breach.where));
}

}  // namespace

Repair repair(const SegmentSet& input, const RepairOptions& options) {
  RepairOptions now = options;
  std::vector<Refusal> given_up;
  while (true) {
    Repair result;
    result.tolerances.snap = now.snap;
    result.tolerances.simplify = now.simplify;
    result.tolerances.doors = now.doors;
    result.anchored = anchored_segments(input, now);
    const std::optional<Breach> breach = Repairing(input, now, result).run();
    if (!breach) {
      result.refused.insert(result.refused.begin(), given_up.begin(), given_up.end());
      return result;
    }
    given_up.push_back(give_up_one(now, result.tolerances, *breach));
  }
}

}  // namespace plumbline
