#include "plumbline/repair.hpp"

#include <set>
#include <tuple>

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
  /// `stays` are segments that are not welded to others.
  Repairing(const SegmentSet& input, const RepairOptions& options, const std::set<SegmentId>& stays,
            Repair& result)
      : options_(options),
        result_(result),
        work_(input, result.anchored),
        choice_(input, result.reasons),
        stays_(stays) {}

  /// What is not true of the result; nothing where all is.
  std::vector<Breach> run() {
    if (!settle()) return {{"there is no end of edits", work_.edits().back().where, {}}};
    if (sgn(result_.tolerances.grow) > 0) refuse_open_ends(work_, now_, result_.tolerances.grow);
    work_.write(result_);
    arrange_merged();
    ensure_going_on();
    result_.faces = face_outcomes(before_, result_, now_.complex);
    ensure_going_on();
    return verify(work_.input(), before_, result_, now_.complex);
  }

 private:
  /// Until there is nothing to do; whether that comes to be.
  bool settle() {
    for (std::size_t round = 0; round < kMostRounds; ++round) {
      const std::size_t edits = work_.edits().size();
      run_once(round == 0);
      if (work_.edits().size() > edits) continue;
      // Doors come when walls are where they stay.
      if (result_.tolerances.doors) close_doors(work_, *result_.tolerances.doors, options_.walls);
      if (work_.edits().size() == edits) return true;
    }
    return false;
  }

  void run_once(bool is_first) {
    const std::size_t first_edit = work_.edits().size();
    work_.forget_refusals();
    look_anew();
    Tolerances& tolerances = result_.tolerances;
    merge_lines();
    if (is_first) tolerances.weld = options_.weld ? *options_.weld : choice_.weld(work_, now_);
    if (sgn(tolerances.weld) > 0) weld_lines(tolerances.weld);
    if (sgn(tolerances.snap) > 0) {
      arrange_merged();
      snap(work_, now_, tolerances.snap);
    }
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
    if (sgn(tolerances.simplify) > 0) {
      arrange_merged();
      repeat([&] { simplify(work_, now_, tolerances.simplify); });
    }
    dissolve(work_, first_edit);
  }

  /// Without the vertices where merged lines ended.
  void arrange_merged() {
    if (!is_as_arranged_) now_ = arranged(work_);
    is_as_arranged_ = true;
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
    merge(work_, now_, options_.keeps_common_sides, options_.keeps_layers);
    if (work_.edits().size() == edits) return;
    rename_lines(now_, work_);
    looked_at_ = work_.edits().size();
    is_as_arranged_ = false;
  }

  /// Until nothing moves any more.
  void weld_lines(const Rational& distance) {
    for (std::size_t round = 0; round < kMostRounds; ++round) {
      const std::size_t edits = work_.edits().size(), lines = work_.count();
      weld(work_, now_, distance, first_not_welded_, stays_);
      first_not_welded_ = LineId(lines);
      if (work_.edits().size() == edits) return;
      look_anew();
      merge_lines();
    }
  }

  void ensure_going_on() const {
    if (!options_.goes_on || options_.goes_on()) return;
    throw Error(ErrorCode::Cancelled, "the repair was cancelled");
  }

  /// Arranges the lines if they have changed.
  void look_anew() {
    ensure_going_on();
    if (looked_at_ == work_.edits().size()) return;
    looked_at_ = work_.edits().size();
    now_ = arranged(work_);
    is_as_arranged_ = true;
    if (looked_at_ == 0) before_ = now_.complex;
  }

  const RepairOptions& options_;
  Repair& result_;
  Work work_;
  Choice choice_;
  const std::set<SegmentId>& stays_;
  Arranged now_;
  LineId first_not_welded_ = kFirstLine;  ///< lines before are known to go nowhere
  bool is_as_arranged_ = false;           ///< else it may have vertices where merged lines ended
  ExactComplex before_;
  std::size_t looked_at_ = static_cast<std::size_t>(-1);  ///< edits of which `now_` knows
};

void ensure_sizes(const RepairOptions& options) {
  const Range doors = options.doors.value_or(Range{0, 0});
  for (const Rational& size :
       {options.weld.value_or(0), options.grow.value_or(0), options.trim.value_or(0),
        options.sliver.value_or(0), options.snap, options.simplify, doors.least}) {
    if (sgn(size) < 0) {
      throw Error(ErrorCode::BadInput, "a tolerance is negative", {}, exact_text(size));
    }
  }
  if (doors.most < doors.least) {
    throw Error(ErrorCode::BadInput, "doors are at least as wide as at most", {},
                exact_text(doors.least) + ".." + exact_text(doors.most));
  }
}

/// Lets what was welded where promises are broken stay. What is there now, and why.
std::vector<Refusal> give_up_welds(const Repair& repair, const std::vector<Breach>& breaches,
                                   std::set<SegmentId>& stays) {
  std::vector<Refusal> result;
  const Rational near = 4 * repair.tolerances.weld * repair.tolerances.weld;
  for (const Edit& edit : repair.edits) {
    if (edit.kind != EditKind::Weld) continue;
    const auto is_to_blame = [&](const Breach& breach) {
      return std::ranges::any_of(edit.after, [&](const Line& line) {
        return squared_distance(breach.where, line.a, line.b) <= near;
      });
    };
    const auto breach = std::ranges::find_if(breaches, is_to_blame);
    if (breach == breaches.end()) continue;
    Refusal refusal{EditKind::Weld,
                    edit.where,
                    edit.squared_size,
                    "it would break a promise: " + breach->message,
                    {}};
    for (const Line& line : edit.before) {
      for (const SegmentId s : line.segments) {
        if (stays.insert(s).second) refusal.segments.push_back(s);
      }
    }
    if (!refusal.segments.empty()) result.push_back(std::move(refusal));
  }
  return result;
}

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
  ensure_sizes(options);
  RepairOptions now = options;
  std::set<SegmentId> stays;
  std::vector<Refusal> given_up;
  while (true) {
    Repair result;
    result.tolerances.snap = now.snap;
    result.tolerances.simplify = now.simplify;
    result.tolerances.doors = now.doors;
    result.anchored = anchored_segments(input, now);
    const std::vector<Breach> breaches = Repairing(input, now, stays, result).run();
    if (breaches.empty()) {
      result.refused.insert(result.refused.begin(), given_up.begin(), given_up.end());
      return result;
    }
    std::vector<Refusal> refused = give_up_welds(result, breaches, stays);
    if (refused.empty()) refused = {give_up_one(now, result.tolerances, breaches.front())};
    given_up.insert(given_up.end(), refused.begin(), refused.end());
  }
}

}  // namespace plumbline
