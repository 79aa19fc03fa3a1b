// The rules of the divergence catalogue, docs/divergences.md: which one made a finding.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engines/inters/explain/run.hpp"
#include "geometry/point_d.hpp"

namespace plumbline::inters {
namespace {

/// Coordinates are written with so many digits.
constexpr int kDigits = 12;
/// Of the radius: rounding decides whether such distances are above or below it.
constexpr double kRounding = 0x1p-30;
/// A drawing of fewer radii than this is small.
constexpr double kSmallDrawing = 100;

void set(Cause& cause, const char* rule, std::string explanation, std::string advice) {
  cause.rule = rule;
  cause.explanation = std::move(explanation);
  cause.advice = std::move(advice);
}

constexpr const char* kDecideExactly = "decide it exactly: plumbline arrange";

std::vector<PointD> ends_of(const Trace& trace) {
  std::vector<PointD> ends;
  for (const auto& [a, b] : trace.lines) ends.insert(ends.end(), {a, b});
  return ends;
}

double longer_side(const Trace& trace) {
  return trace.lines.empty() ? 0 : box_of(ends_of(trace)).longer_side();
}

}  // namespace

/// The radius and the quantum are absolute.
bool ExplainedRun::is_small() const {
  return longer_side(trace_) <= kSmallDrawing * trace_.options.radius;
}

Cause ExplainedRun::explained(const Finding& finding, Cause cause) const {
  switch (stage_of(cause.stage)) {
    case Stage::Quantise:
      explain_quantisation(finding, cause);
      break;
    case Stage::Bucket:
      set(cause, "empty-half",
          "the mean of equal coordinates came out above them, so one half of a bucket was empty "
          "and "
          "the splitting failed",
          "split at the median, or move the drawing");
      break;
    case Stage::Intersect:
      explain_meeting(finding, cause);
      break;
    case Stage::Prune:
      explain_merge(finding, cause);
      break;
    case Stage::Simplify:
      set(cause, "point-edge", "a segment without length became an edge of one vertex",
          "leave out segments without length");
      break;
    case Stage::ComponentFilter:
      explain_filter(finding, cause);
      break;
    case Stage::EdgeOrder:
      set(cause, "rounded-slopes",
          "the order of the edges around a vertex was decided by rounded slopes", kDecideExactly);
      break;
    case Stage::OuterFace:
      explain_outer_face(finding, cause);
      break;
    case Stage::Nesting:
      explain_nesting(finding, cause);
      break;
    default:
      explain_walk(cause);
  }
  return cause;
}

void ExplainedRun::explain_quantisation(const Finding&, Cause& cause) const {
  const int decimals = trace_.options.decimals;
  const double largest = largest_coordinate(ends_of(trace_));
  if (largest * std::pow(10, decimals) >= std::pow(10, kDigits)) {
    return set(cause, "twelve-digits",
               fmt::format("coordinates were written with {} digits, too few for {} decimals of "
                           "numbers up to {:.3g}",
                           kDigits, decimals, largest),
               "move the drawing to the origin first");
  }
  set(cause, "absolute-quantum",
      fmt::format("coordinates were rounded to {} decimals, whatever the size of the drawing "
                  "({:.3g})",
                  decimals, longer_side(trace_)),
      "scale the drawing up first, or take more decimals and a smaller radius");
}

void ExplainedRun::explain_meeting(const Finding& finding, Cause& cause) const {
  using Kind = MissedMeeting::Kind;
  const MissedMeeting* meeting = meetings_.nearest_to(nearest(finding.where), finding.segments);
  const int decimals = trace_.options.decimals;
  if (!meeting) {
    return set(
        cause, "parameter-rounding",
        fmt::format("parameters and points of intersection were rounded to {} decimals", decimals),
        "take more decimals, or scale the drawing to a length of about 1");
  }
  switch (meeting->kind) {
    case Kind::Parallel:
      return set(cause, "parallel-skipped",
                 "parallel segments are never intersected, so those that overlap did not cut each "
                 "other",
                 "join overlapping strokes before, or cut segments where others end on them");
    case Kind::Overshoot:
      return set(cause, "parameter-overshoot",
                 "a product with the reciprocal of the determinant gave a parameter below 0 or "
                 "above 1, so the meeting was missed",
                 "divide by the determinant, and accept parameters within the radius");
    case Kind::NearMiss:
      return set(cause, "slanted-junction",
                 fmt::format("an end stops {:.3g} beside the segment that it is drawn to, and "
                             "parameters are compared exactly with 0 and 1",
                             meeting->distance),
                 "accept parameters within the radius");
    case Kind::Apart:
      return set(
          cause, "parameter-rounding",
          fmt::format("parameters were rounded to {} decimals, which put the two cuts of one "
                      "meeting {:.3g} apart",
                      decimals, meeting->distance),
          "take more decimals, or scale the drawing to a length of about 1");
  }
}

void ExplainedRun::explain_merge(const Finding& finding, Cause& cause) const {
  const double radius = trace_.options.radius;
  if (is_small()) {
    return set(cause, "absolute-quantum",
               fmt::format("vertices within {:.3g} were merged, whatever the size of the drawing "
                           "({:.3g})",
                           radius, longer_side(trace_)),
               "a smaller radius, or a drawing scaled up");
  }
  const bool crosses = finding.invariant || finding.disagreement == Disagreement::Extra;
  const engine_steps::Cluster* cluster =
      merged_.nearest_to(nearest(finding.where), finding.segments);
  const double extent = cluster ? cluster->extent : 0;
  const double least = cluster ? cluster->least_distance : radius;
  const std::string merged =
      cluster
          ? fmt::format("merging within {:.3g} made one vertex of {} that are up to {:.3g} apart",
                        radius, cluster->size, extent)
          : fmt::format("vertices within {:.3g} were merged", radius);
  if (cluster) cause.distance = least;
  if (crosses) {
    set(cause, "fold-over", merged + ", which led edges across others", "");
  } else if (extent > radius * (1 + kRounding)) {
    set(cause, "chain-collapse", merged + ", each near the next", "");
  } else if (finding.disagreement == Disagreement::Moved) {
    set(cause, "off-grid-mean", merged + "; their mean is none of them and off the grid",
        "keep one of the merged vertices");
  } else if (cluster && std::abs(least - radius) <= radius * kRounding) {
    set(cause, "at-radius", merged + ", the radius itself, so that rounding decided", "");
  } else {
    set(cause, "thin-part", merged, "");
  }
}

void ExplainedRun::explain_filter(const Finding& finding, Cause& cause) const {
  using Why = DroppedEdges::Why;
  const char* advice = "keep all components: plumbline check without --variant published";
  if (finding.kind == CellKind::Hole) {
    return set(cause, "holes-dropped", "faces have no inner boundaries", advice);
  }
  const auto why = dropped_.nearest_to(nearest(finding.where), finding.segments);
  if (!why) {
    return set(cause, "rounded-again",
               "the merged vertices were rounded once more, which moved or merged them",
               "keep the merged vertices");
  }
  switch (*why) {
    case Why::NoCycle:
      return set(cause, "bridges-dropped", "edges in no cycle were left out", advice);
    case Why::FewerEdges:
      return set(cause, "one-component", "one biconnected component was kept, another one", advice);
    case Why::LargerExtent:
      return set(cause, "most-edges",
                 "one biconnected component was kept: that with most edges, not the largest",
                 advice);
  }
}

void ExplainedRun::explain_walk(Cause& cause) const {
  const char* advice = "cut and merge until nothing changes, as the repaired pipeline does";
  if (walk_.never_ends && walk_.is_plane) {
    set(cause, "first-vertex",
        "the walk ends a face at its first vertex, not at its first edge, so that at a cut vertex "
        "or a dangling edge it never ends",
        "end a face where its first edge comes back");
  } else if (walk_.never_ends) {
    set(cause, "endless-walk", "merging made edges cross, and the face walk never ends", advice);
  } else if (walk_.aborted) {
    set(cause, "aborted-walk",
        "merging made edges cross, and the face walk left its edge and gave up the rest", advice);
  } else if (walk_.breaks_euler) {
    set(cause, "euler", "merging made edges cross, and V - E + F is not that of the plane", advice);
  } else if (walk_.depends_on_order) {
    set(cause, "hash-order",
        "merging made edges cross, and which faces are found depends on the order of a hash table",
        advice);
  } else if (!walk_.is_plane) {
    set(cause, "crossed-walk", "edges cross, so the cycles of the walk are no faces", advice);
  } else {
    set(cause, "no-cycle", "there is no cycle, and so no result", "keep the edges in no cycle");
  }
}

void ExplainedRun::explain_outer_face(const Finding& finding, Cause& cause) const {
  if (walk_.misjudges_areas) {
    return set(cause, "single-precision-area",
               "areas in single precision made an inner face as large as the exterior one",
               "signed areas in double precision");
  }
  const bool is_kept = finding.invariant || finding.disagreement == Disagreement::Extra;
  if (is_kept) {
    return set(cause, "exteriors-kept",
               "the exterior cycles of all components but the largest stayed among the faces",
               "leave out every cycle that runs clockwise");
  }
  set(cause, "largest-area",
      "every cycle with the largest area was taken for the exterior one, a face among them",
      "leave out every cycle that runs clockwise");
}

void ExplainedRun::explain_nesting(const Finding& finding, Cause& cause) const {
  using Fault = Lattice::Fault;
  if (result_ != Result::CellsFromCycles) {
    return set(cause, "holes-dropped", "faces have no inner boundaries",
               "give faces the outlines of what lies in them as holes");
  }
  const char* advice = "take the innermost cycle around each component";
  switch (lattice_.fault_at(finding.segments)) {
    case Fault::Alternates:
      return set(cause, "alternate-cells",
                 "solid and void alternate with the depth, so that every other face is no cell",
                 advice);
    case Fault::OnBoundary:
      return set(cause, "on-boundary-level",
                 "the vertex that stands for a cycle lies on another one, which spoils the levels",
                 advice);
    case Fault::OneVertex:
      return set(cause, "one-vertex",
                 "one vertex stands for a cycle, and it is level with one of the other cycle",
                 advice);
    case Fault::Crossings:
      return set(cause, "half-crossings",
                 "every vertex of a cycle is level with one of the other cycle, where half "
                 "crossings are counted in copies of the counters",
                 advice);
    case Fault::Unrounded:
      return set(cause, "unrounded-query",
                 "the polygon was rounded and the vertex on it was not, so that it is not found "
                 "on it",
                 advice);
  }
}

void ExplainedRun::explain_conversion(const Finding& finding, Cause& cause) const {
  const MissedMeeting* missed = meetings_.near_miss(nearest(finding.where), finding.segments);
  if (!missed || missed->distance > kRounding * largest_coordinate(ends_of(trace_))) return;
  set(cause, "slanted-junction",
      fmt::format("in doubles an end stops {:.3g} beside the segment that it is drawn to, and "
                  "parameters are compared exactly with 0 and 1",
                  missed->distance),
      "accept parameters within the radius");
}

Cause ExplainedRun::refined(const Finding& finding, Cause cause) const {
  if (cause.stage == kParse || cause.stage == kTransform) {
    explain_conversion(finding, cause);
    return cause;
  }
  if (cause.rule == "parallel-skipped" && finding.kind == CellKind::Face) {
    cause.rule = "parallel-wall";
  }
  if (stage_of(cause.stage) == Stage::ComponentFilter && finding.kind == CellKind::Hole) {
    explain_filter(finding, cause);
  }
  return cause;
}

}  // namespace plumbline::inters
