// Each halfedge is in one cycle of one face. Halfedges that the same cycles claim together are one
// violation: two faces that overlap, and not every edge that they share.

#include <algorithm>
#include <map>

#include "complex/validate.hpp"

namespace plumbline {
namespace {

/// Per halfedge how often cycles of faces have it.
std::vector<std::size_t> claim_counts(const ExactComplex& c) {
  std::vector<std::size_t> counts(2 * c.edge_count(), 0);
  for (std::size_t i = 0; i < c.cycles.size(); ++i) {
    for (const HalfedgeId h : c.cycles[i]) counts[h] += c.cycle_face[i].valid() ? 1 : 0;
  }
  return counts;
}

class Claims {
 public:
  Claims(const ExactComplex& complex, Violations& violations)
      : c_(complex), violations_(violations), counts_(claim_counts(complex)) {}

  void check() {
    const bool is_right =
        std::all_of(counts_.begin(), counts_.end(), [](std::size_t n) { return n == 1; });
    if (!is_right) {
      report_cycles_without_face();
      report_claimed_by_none();
      report_claimed_by_several();
    }
    check_derived();
  }

 private:
  void report_cycles_without_face() {
    for (std::size_t i = 0; i < c_.cycles.size(); ++i) {
      if (c_.cycle_face[i].valid()) continue;
      std::vector<HalfedgeId> halfedges(c_.cycles[i].begin(), c_.cycles[i].end());
      for (const HalfedgeId h : halfedges) counts_[h] += counts_[h] == 0 ? 1 : 0;  // is reported
      report("a cycle belongs to no face", halfedges, {});
    }
  }

  void report_claimed_by_none() {
    for (std::size_t h = 0; h < counts_.size(); ++h) {
      if (counts_[h] == 0) {
        report("a halfedge is in 0 cycles of faces, not in one", {HalfedgeId(h)}, {});
      }
    }
  }

  void report_claimed_by_several() {
    std::map<HalfedgeId, std::vector<std::size_t>> claimers;  // cycles, ascending
    for (std::size_t i = 0; i < c_.cycles.size(); ++i) {
      if (!c_.cycle_face[i].valid()) continue;
      for (const HalfedgeId h : c_.cycles[i]) {
        if (counts_[h] > 1) claimers[h].push_back(i);
      }
    }
    std::map<std::vector<std::size_t>, std::vector<HalfedgeId>> together;
    for (const auto& [h, cycles] : claimers) together[cycles].push_back(h);
    for (const auto& [cycles, halfedges] : together) {
      std::vector<FaceId> faces;
      for (const std::size_t cycle : cycles) faces.push_back(c_.cycle_face[cycle]);
      const std::string count = std::to_string(cycles.size()) + " cycles of faces, not in one";
      report(halfedges.size() == 1
                 ? "a halfedge is in " + count
                 : std::to_string(halfedges.size()) + " halfedges are in " + count,
             halfedges, std::move(faces));
    }
  }

  void report(const std::string& message, const std::vector<HalfedgeId>& halfedges,
              std::vector<FaceId> faces) {
    std::vector<EdgeId> edges;
    for (const HalfedgeId h : halfedges) edges.push_back(edge_of(h));
    violations_.add({Invariant::HalfedgeInCycle,
                     message,
                     c_.vertices[c_.origin(halfedges.front())],
                     {},
                     std::move(edges),
                     std::move(faces)});
  }

  /// Faces of cycles and halfedges are what `face_outer`, `face_holes` and `cycles` say; no member
  /// beyond. Of a halfedge in several cycles they can't be.
  void check_derived() {
    std::vector<FaceId> expected(c_.cycles.size());
    for (std::size_t f = 0; f < c_.face_count(); ++f) {
      if (c_.face_outer[f].valid()) expected[c_.face_outer[f]] = FaceId(f);
      for (const CycleId hole : c_.face_holes[f]) expected[hole] = FaceId(f);
    }
    for (std::size_t i = 0; i < c_.cycles.size(); ++i) {
      const auto cycle = c_.cycles[i];
      const auto is_right = [&](HalfedgeId h) {
        return c_.halfedge_face[h] == expected[i] || counts_[h] > 1;
      };
      if (c_.cycle_face[i] == expected[i] && std::all_of(cycle.begin(), cycle.end(), is_right)) {
        continue;
      }
      violations_.add({Invariant::Derived,
                       "a cycle or one of its halfedges names another face than its own",
                       c_.vertices[c_.origin(cycle.front())],
                       {},
                       {edge_of(cycle.front())},
                       {expected[i]}});
    }
  }

  const ExactComplex& c_;
  Violations& violations_;
  std::vector<std::size_t> counts_;
};

}  // namespace

void validate_claims(const ExactComplex& complex, Violations& violations) {
  Claims(complex, violations).check();
}

}  // namespace plumbline
