#include "repair/promises.hpp"

#include <algorithm>
#include <optional>

#include "plumbline/arrange.hpp"
#include "plumbline/error.hpp"

namespace plumbline::repairs {
namespace {

std::string signature_of(const SegmentSet& set) { return signature(arrange(set)); }

/// The same tolerances, as numbers.
RepairOptions as_used(const Repair& repair, RepairOptions options) {
  options.weld = repair.tolerances.weld;
  options.grow = repair.tolerances.grow;
  options.trim = repair.tolerances.trim;
  options.sliver = repair.tolerances.sliver;
  options.snap = repair.tolerances.snap;
  options.simplify = repair.tolerances.simplify;
  options.doors = repair.tolerances.doors;
  return options;
}

Rational largest(const Tolerances& tolerances) {
  Rational result = tolerances.doors ? tolerances.doors->most : Rational(0);
  for (const auto* each : {&tolerances.weld, &tolerances.grow, &tolerances.trim, &tolerances.sliver,
                           &tolerances.snap, &tolerances.simplify}) {
    result = std::max(result, *each);
  }
  return result;
}

/// Whether something was refused no further from the edit than twice the largest tolerance.
bool is_near_refusal(const Edit& edit, const Repair& first) {
  const Rational reach = 2 * largest(first.tolerances);
  return std::ranges::any_of(first.refused, [&](const Refusal& refusal) {
    const auto is_near = [&](const Line& line) {
      return squared_distance(refusal.where, line.a, line.b) <= reach * reach;
    };
    return std::ranges::any_of(edit.before, is_near) || std::ranges::any_of(edit.after, is_near);
  });
}

/// The segments in reverse order and direction, and, if wanted, once more as they were.
SegmentSet rearranged(const SegmentSet& set, bool is_repeated) {
  SegmentSet result = set;
  result.segments = {};
  result.segment_source.clear();
  const auto add = [&](std::size_t i, bool is_reversed) {
    const Segment s = set.segments[i];
    result.add(is_reversed ? Segment{s.b, s.a} : s, set.segment_source[i]);
  };
  for (std::size_t i = set.segments.size(); i-- > 0;) add(i, true);
  for (std::size_t i = 0; is_repeated && i < set.segments.size(); ++i) add(i, false);
  return result;
}

void judge(const Trial& trial, Verdict& verdict) {
  const auto fail = [&](std::string what, std::string detail) {
    if (!verdict.broken.empty()) return;
    verdict.broken = std::move(what);
    verdict.detail = std::move(detail);
  };
  const Repair first = repair(trial.drawing, trial.options);
  verdict.edits = first.edits.size();
  verdict.refused = first.refused.size();
  for (const Refusal& refusal : first.refused) {
    const bool is_given_up = refusal.reason.starts_with("given up as a whole");
    const bool is_stayed = refusal.reason.starts_with("it would break a promise");
    verdict.given_up += is_given_up ? 1 : 0;
    verdict.stayed += is_stayed ? 1 : 0;
    if (is_given_up || is_stayed) verdict.detail = to_text(refusal.kind) + ": " + refusal.reason;
  }
  if (const auto breaches = verify(trial.drawing, first); !breaches.empty()) {
    fail("breach", breaches.front().message + " at " + to_text(breaches.front().where));
  }
  if (signature_of(undo(first.output, net_changes(trial.drawing, first))) !=
      signature_of(trial.drawing)) {
    fail("undo", "it does not make the input again");
  }
  const Repair second = repair(first.output, as_used(first, trial.options));
  for (const Edit& edit : second.edits) {
    if (is_near_refusal(edit, first)) continue;
    fail("second run", to_text(edit.kind) + " at " + to_text(edit.where));
  }
  const std::string expected = signature_of(first.output);
  for (const bool is_repeated : {false, true}) {
    const Repair other = repair(rearranged(trial.drawing, is_repeated), trial.options);
    if (signature_of(other.output) == expected) continue;
    fail(is_repeated ? "repetition" : "order", "another result");
  }
}

}  // namespace

Verdict judged(const Trial& trial) {
  Verdict verdict;
  try {
    judge(trial, verdict);
  } catch (const Error& error) {
    verdict.broken = "throws";
    verdict.detail = error.what();
  }
  return verdict;
}

}  // namespace plumbline::repairs
