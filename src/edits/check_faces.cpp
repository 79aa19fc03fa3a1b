#include <algorithm>

#include "edits/steps.hpp"

namespace plumbline::edits {
namespace {

/// Whether an edit of this kind can do this to a face. What is trimmed or merged is no border; only
/// what is added or moved parts a face, only what is removed or moved joins two.
bool can_do(EditKind kind, FaceFate fate) {
  const bool parts = fate == FaceFate::Closed || fate == FaceFate::Split;
  const bool joins = fate == FaceFate::Opened || fate == FaceFate::Joined;
  switch (kind) {
    case EditKind::Merge:
    case EditKind::Dissolve:
    case EditKind::Trim:
      return false;
    case EditKind::Grow:
    case EditKind::Bridge:
    case EditKind::Joint:
    case EditKind::Door:
      return !joins;
    case EditKind::Sliver:
      return !parts;
    default:
      return true;
  }
}

std::string text_of(const FaceOutcome& outcome) {
  return "face " + std::to_string(outcome.before) + " of area " + exact_text(outcome.area_before) +
         " " + to_text(outcome.fate) + " to face " + std::to_string(outcome.after) + " of area " +
         exact_text(outcome.area_after);
}

/// Virtual lines with the same face on both sides close nothing.
void check_doors(const Repair& repair, const ExactComplex& after, std::vector<Breach>& result) {
  for (std::size_t e = 0; e < after.edge_count(); ++e) {
    const auto is_virtual = [&](SegmentId i) { return repair.origins[i].empty(); };
    if (!after.is_antenna(EdgeId(e)) || !std::ranges::any_of(after.edge_sources[e], is_virtual)) {
      continue;
    }
    result.push_back(
        {"a door has the same face on both sides", after.vertices[after.edges[e].tail], {}});
  }
}

}  // namespace

std::vector<Breach> check_faces(const ExactComplex& before, const Repair& repair,
                                const ExactComplex& after) {
  std::vector<Breach> result;
  const std::vector<FaceOutcome> found = face_outcomes(before, repair, after);
  for (const FaceOutcome& outcome : found) {
    const bool is_done = std::ranges::any_of(
        outcome.edits, [&](std::size_t t) { return can_do(repair.edits[t].kind, outcome.fate); });
    if (!is_done) {
      result.push_back(
          {"no edit that can do that explains " + text_of(outcome), outcome.where, {}});
    }
  }
  for (std::size_t i = 0; i < std::max(found.size(), repair.faces.size()); ++i) {
    if (i < found.size() && i < repair.faces.size() && found[i] == repair.faces[i]) continue;
    const FaceOutcome& outcome = i < found.size() ? found[i] : repair.faces[i];
    result.push_back({i < found.size() ? "the repair does not say so: " + text_of(outcome)
                                       : "the repair says what is not so: " + text_of(outcome),
                      outcome.where,
                      {}});
    break;  // the others may be the same, one place further
  }
  check_doors(repair, after, result);
  return result;
}

}  // namespace plumbline::edits
