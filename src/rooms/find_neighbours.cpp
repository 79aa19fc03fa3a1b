#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "plumbline/geometry/layers.hpp"
#include "rooms/steps.hpp"

namespace plumbline::rooms_steps {
namespace {

using Pair = std::pair<std::size_t, std::size_t>;  ///< of rooms, the lesser one first

/// A side of a narrow face with a room on its other side, which runs with the narrow face on its
/// left.
struct WallSide {
  PointD a, b;
  std::size_t room;
};

/// Whether an edge is drawn on a layer of doors, asked once per source.
class Doors {
 public:
  Doors(const SegmentSet& input, const std::vector<std::string>& globs) : input_(input) {
    is_door_.reserve(input.sources.size());
    for (std::size_t s = 0; s < input.sources.size(); ++s) {
      const std::string layer = input.sources[s].layer;
      is_door_.push_back(!layer.empty() &&
                         std::any_of(globs.begin(), globs.end(), [&](const std::string& glob) {
                           return is_layer(layer, glob);
                         }));
    }
  }
  bool holds(std::span<const SegmentId> segments) const {
    return std::any_of(segments.begin(), segments.end(),
                       [&](SegmentId s) { return is_door_[input_.segment_source[s]]; });
  }

 private:
  const SegmentSet& input_;
  std::vector<bool> is_door_;
};

/// How much of side s faces side t, no further than `most` away: t runs the other way, in front of
/// s, and its projection covers this length of it.
double facing(const WallSide& s, const WallSide& t, double most) {
  constexpr double kParallel = 0.02;  // about a degree
  const double dx = s.b.x - s.a.x, dy = s.b.y - s.a.y, length = std::hypot(dx, dy);
  const double ex = t.b.x - t.a.x, ey = t.b.y - t.a.y, other = std::hypot(ex, ey);
  if (!(length > 0) || !(other > 0)) return 0;
  const double cosine = (dx * ex + dy * ey) / (length * other);
  if (cosine > -1 + kParallel * kParallel / 2) return 0;
  const auto along = [&](const PointD& p) {
    return ((p.x - s.a.x) * dx + (p.y - s.a.y) * dy) / length;
  };
  const auto ahead = [&](const PointD& p) {
    return (dx * (p.y - s.a.y) - dy * (p.x - s.a.x)) / length;
  };
  const double distance = (ahead(t.a) + ahead(t.b)) / 2;
  if (!(distance > 0) || distance > most) return 0;
  return std::max(0.0, std::min(length, along(t.a)) - std::max(0.0, along(t.b)));
}

/// Adds how long sides of different rooms face each other across one narrow face.
void add_facing(std::vector<WallSide>& sides, double most, std::map<Pair, double>& across) {
  const auto left = [](const WallSide& s) { return std::min(s.a.x, s.b.x); };
  const auto right = [](const WallSide& s) { return std::max(s.a.x, s.b.x); };
  std::stable_sort(sides.begin(), sides.end(),
                   [&](const WallSide& s, const WallSide& t) { return left(s) < left(t); });
  std::vector<const WallSide*> open;
  for (const WallSide& t : sides) {
    std::erase_if(open, [&](const WallSide* s) { return right(*s) + most < left(t); });
    for (const WallSide* s : open) {
      if (s->room == t.room) continue;
      const double length = facing(*s, t, most);
      const auto [low, high] = std::pair(std::min(s->room, t.room), std::max(s->room, t.room));
      if (length > 0) across[{low, high}] += length;
    }
    open.push_back(&t);
  }
}

}  // namespace

void find_neighbours(Rooms& rooms, const SegmentSet& input, const ExactComplex& complex,
                     const std::vector<std::string>& door_layers) {
  const std::vector<std::size_t> room_of = room_of_face(rooms, complex);
  const Doors doors(input, door_layers);
  std::map<Pair, double> shared, across;
  std::map<Pair, bool> is_door;
  std::map<std::size_t, std::vector<WallSide>> walls;  // by narrow face
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const auto [tail, head] = complex.edges[e];
    const PointD p = complex.vertices.nearest(tail), q = complex.vertices.nearest(head);
    const FaceId left = complex.halfedge_face[halfedge(EdgeId(e), false)];
    const FaceId right = complex.halfedge_face[halfedge(EdgeId(e), true)];
    const std::size_t l = room_of[left], r = room_of[right];
    if (l != kNoRoom && r != kNoRoom && l != r) {
      const Pair pair(std::min(l, r), std::max(l, r));
      shared[pair] += std::hypot(q.x - p.x, q.y - p.y);
      is_door[pair] = is_door[pair] || doors.holds(complex.edge_sources[e]);
    } else if (l == kNoRoom && r != kNoRoom && left != kUnbounded) {
      walls[left].push_back({p, q, r});
    } else if (r == kNoRoom && l != kNoRoom && right != kUnbounded) {
      walls[right].push_back({q, p, l});
    }
  }
  const double most = nearest_double(rooms.min_width);
  for (auto& [face, sides] : walls) add_facing(sides, most, across);

  std::map<Pair, RoomNeighbour> all;
  for (const auto& [pair, length] : shared) {
    all[pair].shared = length;
    all[pair].door = is_door[pair];
  }
  for (const auto& [pair, length] : across) all[pair].across = length;
  for (const auto& [pair, next] : all) {
    const auto [low, high] = pair;
    rooms.rooms[low].neighbours.push_back({high, next.shared, next.across, next.door});
    rooms.rooms[high].neighbours.push_back({low, next.shared, next.across, next.door});
  }
  for (Room& room : rooms.rooms) {
    std::sort(room.neighbours.begin(), room.neighbours.end(),
              [](const RoomNeighbour& a, const RoomNeighbour& b) { return a.room < b.room; });
  }
}

}  // namespace plumbline::rooms_steps
