// A side that one ring alone has lies on the outline, unless a neighbour has its vertices
// elsewhere: then sides that the neighbour alone has lead along it. Slivers are told from that by
// their own ring, which has both the side and the way along it.

#include "engines/files/split_rings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace plumbline::files {
namespace {

using Ring = std::vector<VertexId>;
using Side = std::pair<VertexId, VertexId>;

Side side(VertexId v, VertexId w) { return std::minmax(v, w); }

template <class Visit>
void for_each_ring(CellLists& cells, const Visit& visit) {
  for (Polygon& face : cells.faces) {
    visit(face.outer);
    for (Ring& hole : face.holes) visit(hole);
  }
}

class Splitting {
 public:
  explicit Splitting(CellLists& cells) : cells_(cells) {
    std::map<Side, std::size_t> uses;
    for_each_ring(cells, [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const VertexId v = ring[i], w = ring[(i + 1) % ring.size()];
        if (v != w) ++uses[side(v, w)];
      }
    });
    for (const auto& [ends, count] : uses) {
      if (count != 1) continue;
      lone_.insert(ends);
      beside_[ends.first].push_back(ends.second);
      beside_[ends.second].push_back(ends.first);
    }
    near_ = kInLine * extent();
  }

  std::vector<VertexId> run() && {
    for_each_ring(cells_, [&](Ring& ring) { ring = split(ring); });
    return {passed_.begin(), passed_.end()};
  }

 private:
  double extent() const {
    if (cells_.vertices.empty()) return 0;
    PointD low = cells_.vertices.front(), high = low;
    for (const PointD& p : cells_.vertices) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return std::max(high.x - low.x, high.y - low.y);
  }

  Ring split(const Ring& ring) {
    Ring result;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const VertexId v = ring[i], w = ring[(i + 1) % ring.size()];
      result.push_back(v);
      if (v == w || !lone_.contains(side(v, w))) continue;
      const Ring way = way_along(v, w);
      result.insert(result.end(), way.begin(), way.end());
      passed_.insert(way.begin(), way.end());
    }
    return result;
  }

  /// The vertices between a and b on lone sides in line with them; none if there is no such way.
  Ring way_along(VertexId a, VertexId b) const {
    const PointD from = cells_.vertices[a], to = cells_.vertices[b];
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const PointD along{(to.x - from.x) / length, (to.y - from.y) / length};
    const auto parameter = [&](VertexId v) {
      const PointD p = cells_.vertices[v];
      return (p.x - from.x) * along.x + (p.y - from.y) * along.y;
    };
    const auto is_in_line = [&](VertexId v) {
      const PointD p = cells_.vertices[v];
      return std::abs((p.y - from.y) * along.x - (p.x - from.x) * along.y) <= near_;
    };
    Ring way;
    for (VertexId at = a; at != b;) {
      VertexId next;
      for (const VertexId v : beside_.at(at)) {
        if ((at == a && v == b) || !is_in_line(v) || parameter(v) <= parameter(at) ||
            parameter(v) > length + near_) {
          continue;
        }
        if (!next.valid() || parameter(v) < parameter(next)) next = v;
      }
      if (!next.valid()) return {};
      if (next != b) way.push_back(next);
      at = next;
    }
    return way;
  }

  CellLists& cells_;
  std::set<Side> lone_;
  std::map<VertexId, std::vector<VertexId>> beside_;
  double near_ = 0;
  std::set<VertexId> passed_;
};

}  // namespace

std::vector<VertexId> split_rings(CellLists& cells) { return Splitting(cells).run(); }

}  // namespace plumbline::files
