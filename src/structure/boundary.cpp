// Incidences of LAR models, mod 2, and their boundaries.

#include <algorithm>
#include <set>
#include <string>

#include "plumbline/error.hpp"
#include "plumbline/structure/model.hpp"

namespace plumbline {
namespace {

/// Per vertex the cells that hold it, ascending.
Cells cells_of_vertices(const Cells& cells, std::size_t vertex_count) {
  std::vector<std::vector<std::uint32_t>> holders(vertex_count);
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    for (const std::uint32_t v : cells[c]) {
      if (holders[v].empty() || holders[v].back() != c) holders[v].push_back(c);
    }
  }
  Cells result;
  for (const auto& list : holders) result.push_back(list);
  return result;
}

/// The closed walks along the edges of a graph whose degrees are even.
class Walks {
 public:
  explicit Walks(std::size_t vertex_count) : links_(vertex_count), place_(vertex_count, kNone) {}

  void add(std::uint32_t a, std::uint32_t b) {
    links_[a].insert(b);
    links_[b].insert(a);
  }

  Cells polylines() && {
    for (std::uint32_t v = 0; v < links_.size(); ++v) {
      if (links_[v].size() % 2 == 0) continue;
      throw Error(ErrorCode::BadInput,
                  "the boundary does not close in vertex " + std::to_string(v));
    }
    for (std::uint32_t v = 0; v < links_.size(); ++v) {
      while (!links_[v].empty()) walk_from(v);
    }
    return std::move(result_);
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Walks along edges that are left, which it takes, until it is back; each simple loop on the way
  /// becomes a polyline.
  void walk_from(std::uint32_t start) {
    extend(start);
    do {
      const std::uint32_t at = way_.back();
      const std::uint32_t next = *links_[at].begin();
      links_[at].erase(next);
      links_[next].erase(at);
      if (place_[next] == kNone) {
        extend(next);
      } else {
        split_off(place_[next]);
      }
    } while (way_.size() > 1);
    place_[start] = kNone;
    way_.clear();
  }

  void extend(std::uint32_t v) {
    place_[v] = way_.size();
    way_.push_back(v);
  }

  /// The loop from this place of the way to its end; its first vertex stays.
  void split_off(std::size_t from) {
    result_.push_back(std::span(way_).subspan(from));
    for (std::size_t i = from + 1; i < way_.size(); ++i) place_[way_[i]] = kNone;
    way_.resize(from + 1);
  }

  std::vector<std::set<std::uint32_t>> links_;  ///< per vertex: what edges that are left lead to
  std::vector<std::uint32_t> way_;
  std::vector<std::size_t> place_;  ///< per vertex, in way_
  Cells result_;
};

}  // namespace

Cells facet_cells(const LarModel& model, std::size_t k) {
  ensure(k + 1 < model.cells.size(), "a model with cells and facets");
  const Cells& facets = model.cells[k + 1];
  const Cells holders = cells_of_vertices(model.cells[k], model.vertex_count());
  Cells result;
  std::vector<std::uint32_t> vertices, holding;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    // The fewest candidates, looked up in the longer lists: a hub of many cells costs no more.
    vertices.assign(facets[f].begin(), facets[f].end());
    std::sort(vertices.begin(), vertices.end(), [&](std::uint32_t v, std::uint32_t w) {
      return holders[v].size() < holders[w].size();
    });
    holding.clear();
    if (!vertices.empty()) {
      for (const std::uint32_t cell : holders[vertices.front()]) {
        if (std::all_of(vertices.begin() + 1, vertices.end(), [&](std::uint32_t v) {
              return std::binary_search(holders[v].begin(), holders[v].end(), cell);
            })) {
          holding.push_back(cell);
        }
      }
    }
    result.push_back(holding);
  }
  return result;
}

std::vector<std::uint32_t> boundary_cells(const LarModel& model, std::size_t k) {
  const Cells incident = facet_cells(model, k);
  std::vector<std::uint32_t> odd;
  for (std::uint32_t f = 0; f < incident.size(); ++f) {
    if (incident[f].size() % 2 == 1) odd.push_back(f);
  }
  return odd;
}

LarModel boundary_model(const LarModel& model) {
  LarModel result{model.source, model.dimension, model.coordinates, {}};
  Cells facets;
  for (const std::uint32_t f : boundary_cells(model)) facets.push_back(model.cells[1][f]);
  result.cells.push_back(std::move(facets));
  return result;
}

Cells boundary_polylines(const LarModel& model) {
  const Cells boundary =
      model.cells.size() == 1 ? model.cells.front() : boundary_model(model).cells.front();
  Walks walks(model.vertex_count());
  for (std::size_t e = 0; e < boundary.size(); ++e) {
    const auto edge = boundary[e];
    if (edge.size() != 2 || edge[0] == edge[1]) {
      throw Error(ErrorCode::BadInput, "boundary polylines of cells that are not bounded by edges");
    }
    walks.add(edge[0], edge[1]);
  }
  return std::move(walks).polylines();
}

Cells simplicial_fan(const Cells& cells, std::uint32_t apex) {
  Cells fan;
  std::vector<std::uint32_t> simplex;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto cell = cells[c];
    if (std::find(cell.begin(), cell.end(), apex) != cell.end()) continue;
    simplex.assign(1, apex);
    simplex.insert(simplex.end(), cell.begin(), cell.end());
    fan.push_back(simplex);
  }
  return fan;
}

}  // namespace plumbline
