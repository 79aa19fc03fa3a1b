// Union-find over the cells of both sides.

#include "compare/groups.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace plumbline::compare_steps {
namespace {

std::size_t root(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

std::size_t position(const std::vector<std::size_t>& sorted, std::size_t value) {
  return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), value) -
                                  sorted.begin());
}

}  // namespace

std::vector<Group> connected_groups(
    const Both<std::vector<std::size_t>>& cells,
    const std::vector<std::pair<std::size_t, std::size_t>>& relation) {
  const std::size_t exact_count = cells[Exact].size();
  std::vector<std::size_t> parent(exact_count + cells[Float].size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  for (const auto& [exact_cell, float_cell] : relation) {
    const std::size_t a = root(parent, position(cells[Exact], exact_cell));
    const std::size_t b = root(parent, exact_count + position(cells[Float], float_cell));
    parent[std::max(a, b)] = std::min(a, b);  // a root is the least of its group
  }
  std::map<std::size_t, Group> by_root;
  for (const Side side : kBothSides)
    for (std::size_t i = 0; i < cells[side].size(); ++i) {
      const std::size_t node = side == Exact ? i : exact_count + i;
      by_root[root(parent, node)][side].push_back(cells[side][i]);
    }
  std::vector<Group> groups;
  for (auto& entry : by_root) groups.push_back(std::move(entry.second));
  return groups;
}

}  // namespace plumbline::compare_steps
