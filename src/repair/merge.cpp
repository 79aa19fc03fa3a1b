// Lines that share an edge lie on one line; those that hang together so are an interval.

#include <algorithm>

#include "diagnose/sides.hpp"
#include "geometry/union_find.hpp"
#include "repair/steps.hpp"

namespace plumbline::repair_steps {
namespace {

/// Whether lines are sides that two closed shapes have in common; unknown of lines made since.
class CommonSides {
 public:
  explicit CommonSides(const SegmentSet& input) : sides_(diagnose_steps::sides_of(input)) {}

  bool have(LineId id, LineId other) const {
    return id < sides_.size() && other < sides_.size() && are_neighbours(sides_[id], sides_[other]);
  }

 private:
  std::vector<diagnose_steps::SideOf> sides_;
};

}  // namespace

void merge(Work& work, const Arranged& arranged) {
  const Lists<SegmentId>& sources = arranged.complex.edge_sources;
  UnionFind sets(arranged.line_of.size());
  std::optional<CommonSides> common_sides;
  bool found = false;
  for (std::size_t e = 0; e < sources.size(); ++e) {
    for (std::size_t i = 1; i < sources[e].size(); ++i) {
      if (!common_sides) common_sides.emplace(work.input());
      for (std::size_t j = 0; j < i; ++j) {
        const LineId p = arranged.line_of[sources[e][i]], q = arranged.line_of[sources[e][j]];
        if (sets.find(sources[e][i]) == sets.find(sources[e][j])) continue;
        if (work.is_anchored(p) || work.is_anchored(q) || common_sides->have(p, q)) continue;
        sets.unite(sources[e][i], sources[e][j]);
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
