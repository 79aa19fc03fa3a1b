// Joins findings whose cells touch, then gives each face and hole to the group that made it.

#include "check/hanging_together.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/point_tree.hpp"
#include "geometry/union_find.hpp"

namespace plumbline::check_steps {
namespace {

/// Who made a finding: groups do not go across.
enum class Maker : std::size_t { Drawing, Conversion, Engine };
constexpr std::size_t kMakers = 3;

constexpr std::size_t kNone = static_cast<std::size_t>(-1);
constexpr double kRounding = 0x1p-50;  // of places, of their largest coordinate

bool is_of_line_work(const Finding& finding) {
  return finding.kind == CellKind::Vertex || finding.kind == CellKind::Edge;
}

/// Whether cycles and faces by themselves are wrong. Edges that cross, touch or coincide are wrong
/// in a place; these are not.
bool breaks_incidences(const Finding& finding) {
  constexpr std::array kOfLineWork = {Invariant::Crossing, Invariant::VertexOnEdge,
                                      Invariant::DuplicateVertex, Invariant::DuplicateEdge};
  return finding.invariant &&
         std::ranges::find(kOfLineWork, *finding.invariant) == kOfLineWork.end();
}

/// A cell of a side, as far as one maker's findings are about it.
using Place = std::pair<std::size_t, Maker>;

class Grouping {
 public:
  Grouping(const Comparison& comparison, const std::vector<Cause>& causes,
           const ExactComplex& exact_complex, const FloatComplex& answer)
      : comparison_(comparison),
        findings_(comparison.findings),
        causes_(causes),
        exact_(exact_complex),
        answer_(answer),
        sides_{&exact_complex, &answer},
        sets_(findings_.size()) {}

  /// The indices of the findings of each group, ascending; the groups by their first one.
  std::vector<std::vector<std::size_t>> groups() {
    if (is_elsewhere()) {
      for (std::size_t i = 1; i < findings_.size(); ++i) sets_.unite(0, i);
    }
    join_broken_incidences();
    join_places();
    join_touching();
    join_replaced();
    join_moved();
    join_reasons();
    give_away_faces();
    std::map<std::size_t, std::vector<std::size_t>> by_first;
    for (std::size_t i = 0; i < findings_.size(); ++i) by_first[sets_.find(i)].push_back(i);
    std::vector<std::vector<std::size_t>> result;
    for (auto& entry : by_first) result.push_back(std::move(entry.second));
    return result;
  }

 private:
  /// Whether most of the answer, and of the drawing, is not where the other has something: shifted,
  /// scaled or mirrored as a whole, or empty.
  bool is_elsewhere() const {
    const std::size_t least = std::min(exact_.vertices.size(), answer_.vertices.size());
    return comparison_.matched_vertices == 0 || 2 * comparison_.matched_vertices < least;
  }
  Maker maker(std::size_t i) const {
    if (i >= causes_.size()) return Maker::Engine;
    const std::string& stage = causes_[i].stage;
    if (stage == kDrawing) return Maker::Drawing;
    return stage == kParse || stage == kTransform ? Maker::Conversion : Maker::Engine;
  }
  bool is(std::size_t i, CellKind kind, Disagreement disagreement) const {
    return findings_[i].kind == kind && findings_[i].disagreement == disagreement;
  }
  const std::vector<std::size_t>& cells(std::size_t i, std::size_t side) const {
    return side == 0 ? findings_[i].exact_cells : findings_[i].float_cells;
  }
  std::array<std::size_t, 2> ends(std::size_t side, std::size_t edge) const {
    const Edge& e = sides_[side]->edges.at(edge);
    return {e.tail, e.head};
  }

  /// Wrong cycles and faces are one mistake of a program, and its consequences are everywhere.
  void join_broken_incidences() {
    for (std::size_t i = 0; i < findings_.size(); ++i) {
      if (!breaks_incidences(findings_[i])) continue;
      if (broken_ == kNone) broken_ = i;
      sets_.unite(broken_, i);
    }
  }

  /// Findings about line work in one place.
  void join_places() {
    std::map<std::pair<PointD, Maker>, std::size_t> first;
    for (std::size_t i = 0; i < findings_.size(); ++i) {
      if (!is_of_line_work(findings_[i])) continue;
      const std::pair key(nearest(findings_[i].where), maker(i));
      sets_.unite(first.try_emplace(key, i).first->second, i);
    }
  }

  /// Findings about the same cell, and about edges that end in a vertex that has a finding: a
  /// vertex that is right ends a group. Edges of an invalid complex touch wherever they meet.
  void join_touching() {
    for (std::size_t side = 0; side < 2; ++side) {
      std::map<Place, std::size_t>& at_vertex = at_vertex_[side];
      std::map<Place, std::size_t>& at_edge = at_edge_[side];
      const auto join = [&](std::map<Place, std::size_t>& first, std::size_t cell, std::size_t i) {
        sets_.unite(first.try_emplace({cell, maker(i)}, i).first->second, i);
      };
      for (std::size_t i = 0; i < findings_.size(); ++i) {
        const bool is_invalid = findings_[i].disagreement == Disagreement::Invalid;
        for (const std::size_t cell : cells(i, side)) {
          if (findings_[i].kind == CellKind::Vertex) join(at_vertex, cell, i);
          if (findings_[i].kind != CellKind::Edge || !is_invalid) continue;
          for (const std::size_t v : ends(side, cell)) join(at_vertex, v, i);
        }
      }
      for (std::size_t i = 0; i < findings_.size(); ++i) {
        if (findings_[i].kind != CellKind::Edge) continue;
        for (const std::size_t e : cells(i, side)) {
          join(at_edge, e, i);
          for (const std::size_t v : ends(side, e)) {
            const auto found = at_vertex.find({v, maker(i)});
            if (found != at_vertex.end()) sets_.unite(found->second, i);
          }
        }
      }
    }
  }

  /// An edge that is missing and one that is there instead: both begin in one place.
  void join_replaced() {
    std::vector<PointD> places;
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < findings_.size(); ++i) {
      if (!is(i, CellKind::Edge, Disagreement::Missing)) continue;
      for (const std::size_t e : findings_[i].exact_cells) {
        for (const std::size_t v : ends(0, e)) {
          places.push_back(exact_.vertices.nearest(v));
          missing.push_back(i);
        }
      }
    }
    double largest = 0;
    for (const PointD& p : places) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    const double within = comparison_.tolerance + kRounding * largest;
    const PointTree tree(places);
    for (std::size_t i = 0; i < findings_.size(); ++i) {
      if (!is(i, CellKind::Edge, Disagreement::Extra)) continue;
      for (const std::size_t e : findings_[i].float_cells) {
        for (const std::size_t v : ends(1, e)) {
          tree.for_each_near(answer_.vertices.at(v), within, [&](std::size_t k) {
            if (maker(missing[k]) == maker(i)) sets_.unite(missing[k], i);
          });
        }
      }
    }
  }

  /// Moved vertices with an edge between them.
  void join_moved() {
    std::vector<bool> is_moved(exact_.vertices.size());
    for (std::size_t i = 0; i < findings_.size(); ++i) {
      if (!is(i, CellKind::Vertex, Disagreement::Moved)) continue;
      for (const std::size_t v : findings_[i].exact_cells) is_moved.at(v) = true;
    }
    for (const Edge& edge : exact_.edges) {
      if (!is_moved[edge.tail] || !is_moved[edge.head]) continue;
      for (std::size_t m = 0; m < kMakers; ++m) {
        const auto tail = at_vertex_[0].find({edge.tail, Maker{m}});
        const auto head = at_vertex_[0].find({edge.head, Maker{m}});
        if (tail != at_vertex_[0].end() && head != at_vertex_[0].end()) {
          sets_.unite(tail->second, head->second);
        }
      }
    }
  }

  /// Findings about line work and those that they follow from.
  void join_reasons() {
    for (std::size_t i = 0; i < findings_.size(); ++i) {
      if (!is_of_line_work(findings_[i])) continue;
      for (const std::size_t number : findings_[i].because) {
        if (maker(number - 1) == maker(i)) sets_.unite(number - 1, i);
      }
    }
  }

  /// Faces, holes and the complex as a whole: each to where most of its reasons are, of several
  /// the first; those without any reason to what touches their boundaries, to others about the same
  /// faces, or to the broken incidences.
  void give_away_faces() {
    std::vector<std::pair<std::size_t, std::size_t>> given;
    std::vector<std::size_t> without_reason;
    std::array<std::map<Place, std::size_t>, 2> first_of_face;
    const auto join_faces = [&](std::size_t i, bool unites) {
      for (std::size_t side = 0; side < 2; ++side) {
        for (const std::size_t face : faces(i, side)) {
          if (face == kUnbounded) continue;
          const auto first = first_of_face[side].try_emplace({face, maker(i)}, i).first;
          if (unites) sets_.unite(first->second, i);
        }
      }
    };
    for (std::size_t i = 0; i < findings_.size(); ++i) {
      if (is_of_line_work(findings_[i])) continue;
      if (const std::size_t group = group_of_reasons(i); group != kNone) {
        given.emplace_back(group, i);
        join_faces(i, false);
      } else {
        without_reason.push_back(i);
      }
    }
    for (const auto& [group, i] : given) sets_.unite(group, i);
    for (const std::size_t i : without_reason) {
      std::size_t group = group_at_boundary(i);
      if (group == kNone) group = broken_;
      if (group != kNone) sets_.unite(group, i);
      join_faces(i, group == kNone);
    }
  }

  std::size_t group_of_reasons(std::size_t i) {
    std::map<std::size_t, std::size_t> count;
    for (const std::size_t number : findings_[i].because) {
      if (is_of_line_work(findings_[number - 1])) ++count[sets_.find(number - 1)];
    }
    const auto most =
        std::max_element(count.begin(), count.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == count.end() ? kNone : most->first;
  }

  /// The faces that a finding about faces, or about holes of faces, is about.
  std::vector<std::size_t> faces(std::size_t i, std::size_t side) const {
    if (findings_[i].kind != CellKind::Hole) return cells(i, side);
    std::vector<std::size_t> result;
    for (const std::size_t c : cells(i, side)) result.push_back(sides_[side]->cycle_face.at(c));
    return result;
  }

  std::vector<CycleId> cycles(std::size_t i, std::size_t side) const {
    std::vector<CycleId> result;
    for (const std::size_t cell : cells(i, side)) {
      if (findings_[i].kind == CellKind::Hole) {
        result.emplace_back(cell);
      } else if (cell != kUnbounded) {
        result.push_back(sides_[side]->face_outer.at(cell));
      }
    }
    return result;
  }

  std::size_t group_at_boundary(std::size_t i) const {
    for (std::size_t side = 0; side < 2; ++side) {
      for (const CycleId cycle : cycles(i, side)) {
        if (!cycle.valid()) continue;
        for (const HalfedgeId h : sides_[side]->cycles[cycle]) {
          const auto edge = at_edge_[side].find({edge_of(h), maker(i)});
          if (edge != at_edge_[side].end()) return edge->second;
          const auto vertex = at_vertex_[side].find({sides_[side]->origin(h), maker(i)});
          if (vertex != at_vertex_[side].end()) return vertex->second;
        }
      }
    }
    return kNone;
  }

  const Comparison& comparison_;
  const std::vector<Finding>& findings_;
  const std::vector<Cause>& causes_;
  const ExactComplex& exact_;
  const FloatComplex& answer_;
  std::array<const Incidences*, 2> sides_;  ///< exact, answer
  UnionFind sets_;                          ///< of findings
  std::size_t broken_ = kNone;              ///< the first finding that breaks incidences
  std::array<std::map<Place, std::size_t>, 2> at_vertex_, at_edge_;  ///< by side: a finding there
};

}  // namespace

std::vector<std::vector<std::size_t>> hanging_together(const Comparison& comparison,
                                                       const std::vector<Cause>& causes,
                                                       const ExactComplex& exact_complex,
                                                       const FloatComplex& answer) {
  return Grouping(comparison, causes, exact_complex, answer).groups();
}

}  // namespace plumbline::check_steps
