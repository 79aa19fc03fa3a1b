// Vertices that edits have left with two lines that end there, on one line and on both sides of it.

#include <algorithm>
#include <map>
#include <set>

#include "repair/steps.hpp"

namespace plumbline::repair_steps {
namespace {

/// Where edits have taken lines away, cut them, or let them end: all ends of their lines.
std::set<Point> touched(const std::vector<Edit>& edits, std::size_t first_edit) {
  std::set<Point> result;
  for (std::size_t i = first_edit; i < edits.size(); ++i) {
    result.insert(edits[i].where);
    for (const auto* lines : {&edits[i].before, &edits[i].after}) {
      for (const Line& line : *lines) {
        result.insert(line.a);
        result.insert(line.b);
      }
    }
  }
  return result;
}

/// What is at a vertex.
struct Ends {
  std::size_t edges = 0;
  std::set<LineId> lines;
};

}  // namespace

void dissolve(Work& work, const Arranged& arranged, std::size_t first_edit) {
  if (work.edits().size() == first_edit) return;
  const ExactComplex& complex = arranged.complex;
  std::map<VertexId, Ends> at;
  for (const Point& p : touched(work.edits(), first_edit)) {
    const std::size_t v = complex.vertices.count_before(p);
    if (v < complex.vertices.size() && complex.vertices[v] == p) at[VertexId(v)];
  }
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    for (const VertexId v : {complex.edges[e].tail, complex.edges[e].head}) {
      const auto found = at.find(v);
      if (found == at.end()) continue;
      ++found->second.edges;
      for (const LineId id : arranged.lines(EdgeId(e))) found->second.lines.insert(id);
    }
  }
  for (const auto& [v, ends] : at) {
    if (ends.edges != 2 || ends.lines.size() != 2) continue;
    const Point p = complex.vertices[v];
    const LineId first = work.ending_at(*ends.lines.begin(), p);
    const LineId second = work.ending_at(*ends.lines.rbegin(), p);
    if (work.is_anchored(first) || work.is_anchored(second) || !work.is_same_layer(first, second)) {
      continue;
    }
    const Line line = work.line(first), other = work.line(second);
    const Line whole = united(line, other);
    if (orientation(whole.a, p, whole.b) != 0) continue;
    if (!(line.b == other.a && line.b == p) && !(other.b == line.a && line.a == p)) continue;
    work.apply(EditKind::Dissolve, p, 0, {first, second}, {whole});
  }
}

}  // namespace plumbline::repair_steps
