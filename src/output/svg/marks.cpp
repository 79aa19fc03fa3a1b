// Which cells the findings mark.

#include "output/svg/marks.hpp"

#include <algorithm>

namespace plumbline::svg {

Marks marks_of(const Comparison& comparison, const Incidences& complex,
               std::vector<std::size_t> Finding::*cells) {
  Marks marks;
  for (const Finding& finding : comparison.findings) {
    for (const std::size_t cell : finding.*cells) {
      if (finding.kind == CellKind::Vertex) marks.vertices.emplace_back(cell);
      if (finding.kind == CellKind::Edge) marks.edges.emplace_back(cell);
      if (finding.kind == CellKind::Face && finding.disagreement != Disagreement::Reshaped) {
        marks.faces.emplace_back(cell);
      }
      if (finding.kind == CellKind::Hole) {
        for (const HalfedgeId h : complex.cycles[cell]) marks.edges.push_back(edge_of(h));
      }
    }
  }
  const auto make_unique = [](auto& ids) {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  };
  make_unique(marks.vertices);
  make_unique(marks.edges);
  make_unique(marks.faces);
  return marks;
}

}  // namespace plumbline::svg
