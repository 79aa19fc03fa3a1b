// Matches faces by their outer boundaries, and the rest by what they cover.

#include <fmt/format.h>

#include <algorithm>

#include "compare/locate_faces.hpp"
#include "compare/overlay.hpp"
#include "compare/steps.hpp"
#include "plumbline/error.hpp"

namespace plumbline::compare_steps {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// A cell of the side and one of the other side, the exact one first.
std::pair<std::size_t, std::size_t> pair_of(Side side, std::size_t here, std::size_t there) {
  return side == Exact ? std::pair(here, there) : std::pair(there, here);
}

Rational face_area(const ExactComplex& complex, FaceId f) {
  Rational twice = 0;
  const auto add = [&](CycleId cycle) {
    for (const HalfedgeId h : complex.cycles[cycle]) {
      const Point &p = complex.vertices[complex.origin(h)],
                  &q = complex.vertices[complex.target(h)];
      twice += p.x * q.y - q.x * p.y;
    }
  };
  add(complex.face_outer[f]);
  for (const CycleId hole : complex.face_holes[f]) add(hole);
  return twice / 2;
}

class FaceMatcher {
 public:
  FaceMatcher(const Sides& sides, const VertexMatch& vertices, const EdgeMatch& edges,
              const CycleMatch& cycles, bool float_is_valid)
      : sides_(sides),
        vertices_(vertices),
        edges_(edges),
        cycles_(cycles),
        float_is_valid_(float_is_valid) {
    for (const Side side : kBothSides) {
      const std::size_t count = sides[side].face_count();
      result_.match[side].resize(count);
      result_.group[side].assign(count, kNoGroup);
      inside_[side].resize(count);
      lies_in_[side].resize(count);
    }
  }

  FaceMatch run() {
    join({{{kUnbounded}, {kUnbounded}}});
    result_.same = 1;
    match_same_boundaries();
    overlay_rest();
    account_for_groups(boundary_claims());
    const Pairs pairs = overlaps_.pairs({open_faces(Exact), open_faces(Float)});
    locate_open_faces();
    account_for_groups(pairs);
    return std::move(result_);
  }

 private:
  std::vector<std::size_t> open_faces(Side side) const;
  void match_same_boundaries();
  Pairs boundary_claims() const;
  void overlay_rest();
  void locate_open_faces();
  std::optional<Rational> area_in_dispute(const Group& group) const;
  void account_for_groups(const Pairs& relation);
  /// Gives the faces of a group their common number, and their match where it is one to one.
  void join(const Group& group);
  void report(const Group& group);
  std::string message(const Group& group) const;
  std::string note(Side side, FaceId f) const;
  /// Earlier findings that explain a disagreement, and the edges that they are about.
  struct Cause {
    Numbers numbers;
    Both<std::vector<EdgeId>> edges;
  };
  Cause cause(const Group& group) const;
  Point place_in(Side side, FaceId f) const;

  const Sides& sides_;
  const VertexMatch& vertices_;
  const EdgeMatch& edges_;
  const CycleMatch& cycles_;
  const bool float_is_valid_;
  Both<std::vector<std::optional<Point>>> inside_;  ///< interior points, where they were asked for
  Both<std::vector<FaceId>> lies_in_;               ///< faces of the other side at these points
  Overlaps overlaps_{{}};
  bool is_overlaid_ = true;  ///< if not, faces correspond by their boundaries only
  FaceMatch result_;
  std::size_t group_count_ = 0;
  bool is_last_step_ = false;
};

void FaceMatcher::join(const Group& group) {
  for (const Side side : kBothSides)
    for (const std::size_t f : group[side]) result_.group[side][f] = group_count_;
  ++group_count_;
  if (group[Exact].size() != 1 || group[Float].size() != 1) return;
  result_.match[Exact][group[Exact][0]] = FaceId(group[Float][0]);
  result_.match[Float][group[Float][0]] = FaceId(group[Exact][0]);
}

std::vector<std::size_t> FaceMatcher::open_faces(Side side) const {
  std::vector<std::size_t> result;
  for (std::size_t f = 0; f < sides_[side].face_count(); ++f)
    if (result_.group[side][f] == kNoGroup) result.push_back(f);
  return result;
}

/// Pairs of faces without a group whose outer boundaries are the same, but for merged and split
/// cells. Exact faces first, so that pairs with equal boundaries come in their order.
Pairs FaceMatcher::boundary_claims() const {
  Pairs result;
  for (const Side side : kBothSides)
    for (const std::size_t f : open_faces(side)) {
      const CycleId cycle = cycles_.same[side][sides_[side].face_outer[f]];
      if (!cycle.valid()) continue;
      const ExactComplex& others = sides_[other(side)];
      const FaceId g = others.cycle_face[cycle];
      if (!g.valid() || g == kUnbounded || others.face_outer[g] != cycle) continue;
      if (result_.group[other(side)][g] == kNoGroup) result.push_back(pair_of(side, f, g));
    }
  return result;
}

void FaceMatcher::match_same_boundaries() {
  for (const auto& [f, g] : boundary_claims()) {
    if (!cycles_.is_one_to_one[sides_[Exact].face_outer[f]]) continue;
    if (result_.group[Exact][f] != kNoGroup || result_.group[Float][g] != kNoGroup) continue;
    join({{{f}, {g}}});
    ++result_.same;
  }
}

/// Overlays the faces that have no counterpart so far. Where one side has none, nothing overlaps.
void FaceMatcher::overlay_rest() {
  const Both<std::vector<std::size_t>> faces{open_faces(Exact), open_faces(Float)};
  if (faces[Exact].empty() || faces[Float].empty()) return;
  if (auto regions = overlay(sides_, faces))
    overlaps_ = Overlaps(std::move(*regions));
  else
    is_overlaid_ = false;
}

/// Locates an interior point of each face without a group on the other side.
void FaceMatcher::locate_open_faces() {
  is_last_step_ = true;
  for (const Side side : kBothSides) {
    std::vector<FaceId> faces;
    std::vector<Point> points;
    for (const std::size_t f : open_faces(side)) {
      try {
        inside_[side][f] = interior_point(sides_[side], FaceId(f));
      } catch (const Error&) {
        // Only in an invalid complex, where a face can be without interior; `note` says so.
        if (side == Exact || float_is_valid_) throw;
        continue;
      }
      faces.emplace_back(f);
      points.push_back(*inside_[side][f]);
    }
    const std::vector<FaceId> found = locate_all(sides_[other(side)], points);
    for (std::size_t i = 0; i < faces.size(); ++i) lies_in_[side][faces[i]] = found[i];
  }
}

/// The area of the symmetric difference; that of a face on its own is by the shoelace formula.
std::optional<Rational> FaceMatcher::area_in_dispute(const Group& group) const {
  if (!group[Exact].empty() && !group[Float].empty()) {
    if (!is_overlaid_) return std::nullopt;
    return overlaps_.symmetric_difference(group);
  }
  Rational area = 0;
  for (const Side side : kBothSides)
    for (const std::size_t f : group[side]) area += abs(face_area(sides_[side], FaceId(f)));
  return area;
}

/// Joins the groups of the relation and reports them. In the last step also the faces that
/// correspond to none.
void FaceMatcher::account_for_groups(const Pairs& relation) {
  for (const Group& group : connected_groups({open_faces(Exact), open_faces(Float)}, relation)) {
    const bool is_alone = group[Exact].empty() || group[Float].empty();
    if (is_alone && !is_last_step_) continue;
    if (!is_alone) join(group);
    report(group);
  }
}

/// By the edges of the outer boundaries that disagree; where there are none, by the vertices (two
/// vertices that became one can close a face or take it apart).
FaceMatcher::Cause FaceMatcher::cause(const Group& group) const {
  Cause by_edges, by_vertices, unknown;
  for (const Side side : kBothSides)
    for (const std::size_t f : group[side])
      for (const HalfedgeId h : sides_[side].cycles[sides_[side].face_outer[f]]) {
        const EdgeId e = edge_of(h);
        unknown.edges[side].push_back(e);
        if (edges_.number[side][e] != 0) {
          by_edges.numbers.push_back(edges_.number[side][e]);
          by_edges.edges[side].push_back(e);
        }
        const VertexId v = sides_[side].origin(h);
        if (vertices_.number[side][v] != 0) {
          by_vertices.numbers.push_back(vertices_.number[side][v]);
          for (const HalfedgeId out : sides_.outgoing[side][v])
            by_vertices.edges[side].push_back(edge_of(out));
        }
      }
  return !by_edges.numbers.empty()      ? by_edges
         : !by_vertices.numbers.empty() ? by_vertices
                                        : unknown;
}

Point FaceMatcher::place_in(Side side, FaceId f) const {
  if (inside_[side][f]) return *inside_[side][f];
  try {
    return interior_point(sides_[side], f);
  } catch (const Error&) {
    return midpoint(sides_[side], edge_of(sides_[side].cycles[sides_[side].face_outer[f]].front()));
  }
}

std::string FaceMatcher::message(const Group& group) const {
  const std::size_t m = group[Exact].size(), n = group[Float].size();
  if (n == 0) return "an exact face is missing from the float result";
  if (m == 0) return "a float face has no exact counterpart";
  if (m == 1 && n == 1) return "a face has other edges on its outer boundary";
  return fmt::format("{} became {}", counted(m, "one exact face", "exact faces"),
                     counted(n, "one float face", "float faces"));
}

/// Where a face that has no counterpart lies.
std::string FaceMatcher::note(Side side, FaceId f) const {
  if (!inside_[side][f]) return " (no interior point could be found in the invalid complex)";
  const FaceId g = lies_in_[side][f];
  if (!g.valid()) return fmt::format("; its place is in no {} face", name(other(side)));
  return g == kUnbounded ? fmt::format("; its place is in the unbounded {} face", name(other(side)))
                         : fmt::format("; its place is in {} face {}", name(other(side)),
                                       static_cast<std::size_t>(g));
}

void FaceMatcher::report(const Group& group) {
  Finding finding;
  finding.kind = CellKind::Face;
  const std::size_t m = group[Exact].size(), n = group[Float].size();
  finding.disagreement = n == 0   ? Disagreement::Missing
                         : m == 0 ? Disagreement::Extra
                         : m == n ? Disagreement::Reshaped
                         : m > n  ? Disagreement::Merged
                                  : Disagreement::Split;
  finding.message = message(group);
  Cause why = cause(group);
  finding.segments = joined(segments_of(sides_[Exact], why.edges[Exact]),
                            segments_of(sides_[Float], why.edges[Float]));
  for (const Side side : kBothSides) cells(finding, side) = group[side];
  finding.area = area_in_dispute(group);
  const Side side = m == 0 || m < n ? Float : Exact;
  const FaceId last(group[side].back());
  finding.where = place_in(side, last);
  if (m == 0 || n == 0) finding.message += note(side, last);
  add_causes(finding, std::move(why.numbers));
  result_.findings.push_back(std::move(finding));
}

}  // namespace

FaceMatch match_faces(const Sides& sides, const VertexMatch& vertices, const EdgeMatch& edges,
                      const CycleMatch& cycles, bool float_is_valid) {
  return FaceMatcher(sides, vertices, edges, cycles, float_is_valid).run();
}

}  // namespace plumbline::compare_steps
