// Which edges the cells of a model in the plane draw.

#include <algorithm>
#include <string>

#include "plumbline/error.hpp"
#include "plumbline/structure/model.hpp"

namespace plumbline {
namespace {

using Cycle = std::vector<std::uint32_t>;

class CellEdges {
 public:
  explicit CellEdges(const LarModel& model) {
    points_.reserve(model.vertex_count());
    for (std::size_t v = 0; v < model.vertex_count(); ++v) {
      points_.push_back({model.vertex(v)[0].rational(), model.vertex(v)[1].rational()});
    }
  }

  /// The edges of a cell, closed unless it has two vertices, or why there are none.
  std::string add(std::span<const std::uint32_t> cell, ModelEdges& result) const {
    if (cell.size() < 2) return "a cell of less than two vertices";
    if (cell.size() > kMaxPolygon) {
      return "a cell of more than " + std::to_string(kMaxPolygon) + " vertices without edges";
    }
    if (has_equal_points(cell)) return "a cell that has a vertex twice";
    if (cell.size() == 2) {
      result.edges.push_back({cell[0], cell[1]});
      return {};
    }
    Cycle cycle(cell.begin(), cell.end());
    if (!is_simple(cycle)) {
      cycle = boundary_order(cycle);
      if (cycle.empty()) return "a cell that is neither a simple polygon in its order nor convex";
    }
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      result.edges.push_back({cycle[i], cycle[(i + 1) % cycle.size()]});
    }
    return {};
  }

 private:
  const Point& at(std::uint32_t v) const { return points_[v]; }

  auto by_point() const {
    return [this](std::uint32_t v, std::uint32_t w) { return at(v) < at(w); };
  }

  bool has_equal_points(std::span<const std::uint32_t> cell) const {
    Cycle sorted(cell.begin(), cell.end());
    std::sort(sorted.begin(), sorted.end(), by_point());
    return std::adjacent_find(sorted.begin(), sorted.end(),
                              [&](auto v, auto w) { return at(v) == at(w); }) != sorted.end();
  }

  /// Whether no two edges of the closed cycle of distinct points share more than the vertex between
  /// them. Pairs are tested along a sweep in x.
  bool is_simple(const Cycle& cycle) const {
    struct Side {
      std::uint32_t place, low, high;  ///< in the cycle; vertices by point
      const Rational* bottom;
      const Rational* top;
    };
    std::vector<Side> sides;
    for (std::uint32_t i = 0; i < cycle.size(); ++i) {
      const auto [low, high] = std::minmax(cycle[i], cycle[(i + 1) % cycle.size()], by_point());
      const auto [bottom, top] = std::minmax(at(low).y, at(high).y);
      sides.push_back({i, low, high, &bottom, &top});
    }
    std::sort(sides.begin(), sides.end(),
              [&](const Side& s, const Side& t) { return at(s.low) < at(t.low); });
    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (std::size_t j = i + 1; j < sides.size(); ++j) {
        if (at(sides[i].high).x < at(sides[j].low).x) break;
        if (*sides[i].top < *sides[j].bottom || *sides[j].top < *sides[i].bottom) continue;
        const std::size_t gap = (sides[j].place + cycle.size() - sides[i].place) % cycle.size();
        const bool neighbours = gap == 1 || gap + 1 == cycle.size();
        if (neighbours ? fold(sides[i].low, sides[i].high, sides[j].low, sides[j].high)
                       : meet(sides[i].low, sides[i].high, sides[j].low, sides[j].high)) {
          return false;
        }
      }
    }
    return true;
  }

  /// Whether the closed segments ab and cd have a common point.
  bool meet(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    const int c_side = orientation(at(a), at(b), at(c));
    const int d_side = orientation(at(a), at(b), at(d));
    const int a_side = orientation(at(c), at(d), at(a));
    const int b_side = orientation(at(c), at(d), at(b));
    if (c_side * d_side < 0 && a_side * b_side < 0) return true;
    return on_segment(at(a), at(b), at(c)) || on_segment(at(a), at(b), at(d)) ||
           on_segment(at(c), at(d), at(a)) || on_segment(at(c), at(d), at(b));
  }

  /// Whether two sides with a common end share more than that.
  bool fold(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    const auto inside = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
      return r != p && r != q && on_segment(at(p), at(q), at(r));
    };
    return inside(a, b, c) || inside(a, b, d) || inside(c, d, a) || inside(c, d, b);
  }

  /// The vertices in the order of their convex hull's boundary; empty where one lies inside or all
  /// are collinear. Two chains from the first point to the last (Andrew, 1979); those on the line
  /// between belong to the side that has no other points.
  Cycle boundary_order(Cycle cycle) const {
    std::sort(cycle.begin(), cycle.end(), by_point());
    const std::uint32_t first = cycle.front();
    const std::uint32_t last = cycle.back();
    Cycle below, between, above;
    for (const std::uint32_t v : std::span(cycle).subspan(1, cycle.size() - 2)) {
      const int side = orientation(at(first), at(last), at(v));
      (side < 0 ? below : side > 0 ? above : between).push_back(v);
    }
    if (below.empty() && above.empty()) return {};
    if (below.empty()) {
      below.swap(between);
    } else if (above.empty()) {
      above.swap(between);
    }
    if (below.size() + above.size() + 2 != cycle.size()) return {};
    Cycle order{first};
    order.insert(order.end(), below.begin(), below.end());
    order.push_back(last);
    order.insert(order.end(), above.rbegin(), above.rend());
    const std::size_t n = order.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (orientation(at(order[i]), at(order[(i + 1) % n]), at(order[(i + 2) % n])) < 0) return {};
    }
    return order;
  }

  std::vector<Point> points_;
};

/// Each edge from its lesser vertex, and all in order.
void sort_ends(ModelEdges& found) {
  for (auto& [tail, head] : found.edges) {
    if (tail > head) std::swap(tail, head);
  }
  std::sort(found.edges.begin(), found.edges.end());
}

/// The last array with other cells than single vertices; if there is none the last.
std::vector<Cells>::const_iterator drawn_array(const LarModel& model) {
  const auto has_edges = [](const Cells& cells) { return cells.flat().size() > cells.size(); };
  const auto found = std::find_if(model.cells.rbegin(), model.cells.rend(), has_edges);
  return found == model.cells.rend() ? model.cells.end() - 1 : found.base() - 1;
}

}  // namespace

ModelEdges edges(const LarModel& model) {
  if (model.dimension != 2) throw Error(ErrorCode::BadInput, "edges of a model not in the plane");
  ModelEdges result;
  if (model.cells.empty()) return result;
  const CellEdges cell_edges(model);
  const Cells& cells = *drawn_array(model);
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    std::string reason = cell_edges.add(cells[c], result);
    if (!reason.empty()) result.refused.emplace_back(c, std::move(reason));
  }
  sort_ends(result);
  result.edges.erase(std::unique(result.edges.begin(), result.edges.end()), result.edges.end());
  return result;
}

LarModel polygon_boundary(const LarModel& model) {
  if (model.dimension != 2) {
    throw Error(ErrorCode::BadInput, "polygons of a model not in the plane");
  }
  ModelEdges sides;
  const CellEdges cell_edges(model);
  for (std::uint32_t c = 0; !model.cells.empty() && c < model.cells.front().size(); ++c) {
    const auto cell = model.cells.front()[c];
    std::string reason = cell_edges.add(cell, sides);
    if (cell.size() == 2) reason = "a cell of two vertices has no sides";
    if (!reason.empty()) {
      throw Error(ErrorCode::BadInput, reason, {}, "cell " + std::to_string(c));
    }
  }
  sort_ends(sides);
  LarModel result{model.source, model.dimension, model.coordinates, {}};
  Cells odd;
  for (auto side = sides.edges.begin(); side != sides.edges.end();) {
    const auto next = std::upper_bound(side, sides.edges.end(), *side);
    if ((next - side) % 2 == 1) odd.push_back(*side);
    side = next;
  }
  result.cells.push_back(std::move(odd));
  return result;
}

}  // namespace plumbline
