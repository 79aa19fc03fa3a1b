// Joins the cells of both sides to disjoint sets.

#include "compare/groups.hpp"

#include <algorithm>
#include <map>

#include "geometry/union_find.hpp"

namespace plumbline::compare_steps {
namespace {

std::size_t position(const std::vector<std::size_t>& sorted, std::size_t value) {
  return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), value) -
                                  sorted.begin());
}

}  // namespace

std::vector<Group> connected_groups(
    const Both<std::vector<std::size_t>>& cells,
    const std::vector<std::pair<std::size_t, std::size_t>>& relation) {
  const std::size_t exact_count = cells[Exact].size();
  UnionFind sets(exact_count + cells[Float].size());
  for (const auto& [exact_cell, float_cell] : relation) {
    sets.unite(position(cells[Exact], exact_cell),
               exact_count + position(cells[Float], float_cell));
  }
  std::map<std::size_t, Group> by_least;
  for (const Side side : kBothSides) {
    for (std::size_t i = 0; i < cells[side].size(); ++i) {
      const std::size_t node = side == Exact ? i : exact_count + i;
      by_least[sets.find(node)][side].push_back(cells[side][i]);
    }
  }
  std::vector<Group> groups;
  for (auto& entry : by_least) groups.push_back(std::move(entry.second));
  return groups;
}

}  // namespace plumbline::compare_steps
