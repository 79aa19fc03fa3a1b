#include <algorithm>
#include <map>
#include <utility>

#include "rooms/steps.hpp"

namespace plumbline::rooms_steps {
namespace {

void add_name(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

/// Whether p lies on the boundary of the face or on an antenna of it.
bool is_on_boundary(const ExactComplex& complex, FaceId face, const Point& p) {
  const auto on_cycle = [&](CycleId cycle) {
    const auto edges = complex.cycles[cycle];
    return std::any_of(edges.begin(), edges.end(), [&](HalfedgeId h) {
      return on_segment(complex.vertices[complex.origin(h)], complex.vertices[complex.target(h)],
                        p);
    });
  };
  const auto& holes = complex.face_holes[face];
  return (face != kUnbounded && on_cycle(complex.face_outer[face])) ||
         std::any_of(holes.begin(), holes.end(), on_cycle);
}

/// Labels that have a place: large letters first, of the same height as one reads them.
std::vector<std::size_t> by_size(const SegmentSet& input) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < input.labels.size(); ++i) {
    if (input.labels[i].place) result.push_back(i);
  }
  std::stable_sort(result.begin(), result.end(), [&](std::size_t a, std::size_t b) {
    const Label &first = input.labels[a], &second = input.labels[b];
    if (first.height != second.height) return first.height > second.height;
    const Point &p = *first.place, &q = *second.place;
    if (const int by_y = cmp(p.y, q.y); by_y != 0) return input.y_up ? by_y > 0 : by_y < 0;
    return p.x < q.x;
  });
  return result;
}

void add_texts(Rooms& rooms, const SegmentSet& input, const ExactComplex& complex,
               const std::vector<FaceId>& surrounding) {
  const std::vector<std::size_t> room_of = room_of_face(rooms, complex);
  const std::vector<std::size_t> order = by_size(input);
  std::vector<Point> places;
  for (const std::size_t i : order) places.push_back(*input.labels[i].place);
  const std::vector<FaceId> faces = locate_all(complex, places);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t room = is_on_boundary(complex, faces[k], places[k])
                                 ? kNoRoom
                                 : room_around(surrounding, room_of, faces[k]);
    if (room == kNoRoom) {
      rooms.outside.push_back(order[k]);
    } else {
      add_name(rooms.rooms[room].names, input.labels[order[k]].text);
    }
  }
  std::sort(rooms.outside.begin(), rooms.outside.end());
}

/// The closed lines of one element, for exact questions.
class ClosedElement {
 public:
  ClosedElement(const SegmentSet& input, std::vector<std::size_t> segments)
      : input_(input), segments_(std::move(segments)) {
    for (const std::size_t s : segments_) {
      const Segment segment = input.segments[s];
      sides_.push_back({nearest(segment.a), nearest(segment.b)});
      const auto& [a, b] = sides_.back();
      area_ += (a.x * b.y - b.x * a.y) / 2;
    }
  }

  /// Whether as many lines begin as end wherever one does.
  bool is_closed() const {
    std::vector<Point> ends;
    for (const std::size_t s : segments_) {
      Segment segment = input_.segments[s];
      ends.push_back(std::move(segment.a));
      ends.push_back(std::move(segment.b));
    }
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i < ends.size();) {
      std::size_t j = i;
      while (j < ends.size() && ends[j] == ends[i]) ++j;
      if ((j - i) % 2 != 0) return false;
      i = j;
    }
    return !ends.empty();
  }

  double area() const { return std::abs(area_); }

  /// By parity. Requires: p is on no side.
  bool holds(const Point& p) const {
    const PointD near = nearest(p);
    bool inside = false;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const auto& [a, b] = sides_[i];
      // Rounding is monotone: what unequal doubles say is so.
      if (std::max(a.y, b.y) < near.y || near.y < std::min(a.y, b.y)) continue;
      if (std::max(a.x, b.x) < near.x) continue;
      const Segment side = input_.segments[segments_[i]];
      const bool a_is_above = side.a.y > p.y, b_is_above = side.b.y > p.y;
      if (a_is_above == b_is_above) continue;
      const int turn = orientation(side.a, side.b, p);
      if ((turn > 0) == b_is_above) inside = !inside;
    }
    return inside;
  }

 private:
  const SegmentSet& input_;
  std::vector<std::size_t> segments_;
  std::vector<SegmentD> sides_;
  double area_ = 0;
};

struct NamedElement {
  std::vector<std::string> names;
  std::vector<std::size_t> segments;
};

std::map<std::size_t, NamedElement> named_elements(const SegmentSet& input) {
  std::map<std::size_t, NamedElement> result;
  for (const Label& label : input.labels) {
    if (!label.place) result[label.source].names.push_back(label.text);
  }
  if (result.empty()) return result;
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const auto found = result.find(input.segment_source[s]);
    if (found != result.end()) found->second.segments.push_back(s);
  }
  return result;
}

void add_names_of_elements(Rooms& rooms, const SegmentSet& input, const ExactComplex& complex) {
  const std::map<std::size_t, NamedElement> elements = named_elements(input);
  if (elements.empty()) return;
  std::vector<Point> inside;
  for (const Room& room : rooms.rooms) inside.push_back(interior_point(complex, room.face));
  std::vector<std::vector<std::pair<double, const NamedElement*>>> around(rooms.rooms.size());
  for (const auto& [source, element] : elements) {
    const ClosedElement closed(input, element.segments);
    if (!closed.is_closed()) continue;
    for (std::size_t r = 0; r < inside.size(); ++r) {
      if (closed.holds(inside[r])) around[r].emplace_back(closed.area(), &element);
    }
  }
  for (std::size_t r = 0; r < around.size(); ++r) {
    std::stable_sort(around[r].begin(), around[r].end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [area, element] : around[r]) {
      for (const std::string& name : element->names) add_name(rooms.rooms[r].names, name);
    }
  }
}

}  // namespace

void name_rooms(Rooms& rooms, const SegmentSet& input, const ExactComplex& complex,
                const std::vector<FaceId>& surrounding) {
  add_texts(rooms, input, complex, surrounding);
  add_names_of_elements(rooms, input, complex);
}

}  // namespace plumbline::rooms_steps
