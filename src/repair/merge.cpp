// Lines that share an edge lie on one line; those that hang together so are an interval.

#include <algorithm>

#include "diagnose/sides.hpp"
#include "geometry/union_find.hpp"
#include "repair/steps.hpp"

namespace plumbline::repair_steps {
void merge(Work& work, const Arranged& arranged, bool keeps_common_sides, bool keeps_layers) {
  const Lists<SegmentId>& sources = arranged.complex.edge_sources;
  UnionFind sets(arranged.line_of.size());
  std::optional<std::vector<diagnose_steps::SideOf>> sides;
  bool found = false;
  for (std::size_t e = 0; e < sources.size(); ++e) {
    for (std::size_t i = 1; i < sources[e].size(); ++i) {
      if (!sides) {
        sides = keeps_common_sides ? diagnose_steps::sides_of(work.drawing())
                                   : std::vector<diagnose_steps::SideOf>(arranged.line_of.size());
      }
      for (std::size_t j = 0; j < i; ++j) {
        const std::size_t p = sources[e][i], q = sources[e][j];
        if (sets.find(p) == sets.find(q) || are_neighbours((*sides)[p], (*sides)[q])) continue;
        const LineId line = arranged.line_of[p], other = arranged.line_of[q];
        if (work.is_anchored(line) || work.is_anchored(other)) continue;
        if (keeps_layers && !work.is_same_layer(line, other)) continue;
        sets.unite(p, q);
        found = true;
      }
    }
  }
  if (!found) return;
  std::vector<std::vector<LineId>> groups(arranged.line_of.size());
  for (std::size_t s = 0; s < groups.size(); ++s) {
    groups[sets.find(s)].push_back(arranged.line_of[s]);
  }
  std::erase_if(groups, [](const auto& group) { return group.size() < 2; });
  std::vector<std::pair<Line, const std::vector<LineId>*>> merged;
  for (const auto& group : groups) {
    Line line = work.line(group.front());
    for (const LineId id : group) line = united(line, work.line(id));
    merged.emplace_back(std::move(line), &group);
  }
  std::ranges::sort(merged, [](const auto& p, const auto& q) {
    return p.first.a == q.first.a ? p.first.b < q.first.b : p.first.a < q.first.a;
  });
  for (auto& [line, group] : merged) {
    const Point where = line.a;
    work.apply(EditKind::Merge, where, 0, *group, {std::move(line)});
  }
}

}  // namespace plumbline::repair_steps
