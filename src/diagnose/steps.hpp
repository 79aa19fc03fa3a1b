#pragma once

#include <array>
#include <optional>
#include <vector>

#include "diagnose/line_graph.hpp"
#include "diagnose/near_edges.hpp"
#include "plumbline/diagnose.hpp"

namespace plumbline::diagnose_steps {

/// The drawing that is diagnosed, as every step looks at it.
struct Subject {
  const SegmentSet& input;
  const LineGraph& graph;
  const NearEdges& near;
  Rational within;
  Rational squared_within;
  std::size_t most_listed;
};

/// Defects as they are found: counts all, keeps the most relevant ones.
class Defects {
 public:
  explicit Defects(std::size_t most_listed) : most_listed_(most_listed) {}

  void add(Defect defect);
  /// More of a kind that are counted but not made.
  void add_unlisted(DefectKind kind, std::size_t count, double proposed_tolerance);
  /// An edge that is there by accident: its length is no detail of the drawing.
  void add_accident(EdgeId e) { accidents_.push_back(e); }
  void add_cut_short() { ++cut_short_; }
  void append(Defects other);

  /// At most `most_listed` of each kind, in the order of `diagnose`.
  std::vector<Defect> take_listed();
  const std::array<std::size_t, kDefectKinds>& found() const { return found_; }
  /// Of all defects that have one, ascending.
  std::vector<double> proposed_tolerances() const;
  const std::vector<EdgeId>& accidents() const { return accidents_; }
  std::size_t cut_short() const { return cut_short_; }

 private:
  void keep_most_relevant(std::vector<Defect>& defects) const;

  std::size_t most_listed_;
  std::array<std::vector<Defect>, kDefectKinds> listed_;
  std::array<std::size_t, kDefectKinds> found_{};
  std::vector<double> tolerances_;
  std::vector<EdgeId> accidents_;
  std::size_t cut_short_ = 0;
};

/// What a tip is, and why.
struct Tip {
  VertexId vertex;
  DefectKind kind = DefectKind::Dangle;
  VertexId partner;           ///< of Gap: the other tip; of Overshoot one that is cut short, if any
  EdgeId edge;                ///< of Undershoot the edge ahead, else that of the partner
  Rational squared_distance;  ///< of Gap, Undershoot, Overshoot with a partner
  std::vector<VertexId>
      meets;  ///< of Gap: tips about as near whose lines lead to where its own does
};
struct Tips {
  std::vector<Tip> tips;  ///< by vertex
  std::size_t cut_short = 0;
  /// The tip v. Requires: v is one.
  const Tip& at(VertexId v) const;
};

// The steps, in the order in which `diagnose` takes them.
Defects duplicates_and_overlaps(const Subject& subject);
Tips classify_tips(const Subject& subject);
/// Whether a segment of a dangling line runs through the vertex where the line leaves the others.
bool goes_beyond(const Subject& subject, const Chain& line);
/// Gaps, undershoots, overshoots and dangles.
Defects dangling_lines(const Subject& subject, const Tips& tips);
Defects near_misses(const Subject& subject, const Tips& tips);
Defects bridges(const Subject& subject);
Defects slivers(const Subject& subject);
Defects short_edges(const Subject& subject);
Defects nearly_parallel_edges(const Subject& subject);
Defects invalid_rings(const Subject& subject);
std::vector<Opening> openings(const LineGraph& graph, std::span<const VertexId> loose_ends,
                              const Range& doors);
/// One sentence on a defect whose other members are there; of a Dangle whether its line is the rest
/// of one that crosses others.
std::string describe(const Subject& subject, const Defect& defect);

/// The squared sine of the angle at v between two of its edges that leave it in nearly the same
/// direction; none for others.
std::optional<Rational> nearly_parallel(const LineGraph& graph, VertexId v, EdgeId e, EdgeId f);

Point midpoint(const Point& p, const Point& q);

}  // namespace plumbline::diagnose_steps
