// What a picture of a repair shows: parts of lines by what became of them, and faces.

#include "output/svg/repair_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "output/text/terminal.hpp"

namespace plumbline {
namespace {

/// In lexicographic order.
Segment ordered(Segment s) {
  if (s.b < s.a) std::swap(s.a, s.b);
  return s;
}

bool on_one_line(const Segment& s, const Segment& t) {
  return orientation(s.a, s.b, t.a) == 0 && orientation(s.a, s.b, t.b) == 0;
}

/// What is left of the segment without these, which lie on its line. All are ordered.
std::vector<Segment> without(const Segment& segment, std::vector<Segment> others) {
  std::sort(others.begin(), others.end(),
            [](const Segment& s, const Segment& t) { return s.a < t.a; });
  std::vector<Segment> parts;
  Point from = segment.a;
  for (const Segment& other : others) {
    if (from < other.a) parts.push_back({from, std::min(other.a, segment.b)});
    from = std::max(from, other.b);
    if (!(from < segment.b)) return parts;
  }
  parts.push_back({from, segment.b});
  std::erase_if(parts, [](const Segment& part) { return !(part.a < part.b); });
  return parts;
}

/// Per segment of the input whether it was welded, snapped or simplified.
std::vector<bool> moved_segments(const SegmentSet& input, const Repair& repair) {
  std::vector<bool> moved(input.segments.size());
  for (const Edit& edit : repair.edits) {
    if (edit.kind < EditKind::Weld) continue;
    for (const Line& line : edit.before) {
      for (const SegmentId s : line.segments) moved[s] = true;
    }
  }
  return moved;
}

/// The segment's parts that the others, on whatever lines, leave over.
struct Rest {
  std::vector<Segment> parts;
  std::vector<Segment> common;
  bool has_moved = false;  ///< whether one of the others is its own, elsewhere
};

template <class Others, class Moved>
Rest rest_of(const Segment& segment, const Others& others, const Moved& is_moved) {
  Rest rest;
  std::vector<Segment> on_it;
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (on_one_line(segment, others[i])) {
      on_it.push_back(others[i]);
    } else if (is_moved(i)) {
      rest.has_moved = true;
    }
  }
  rest.parts = without(segment, std::move(on_it));
  rest.common = without(segment, rest.parts);
  return rest;
}

/// The parts of the input that the output does not have.
void append_lost(std::vector<LinePart>& parts, const SegmentSet& input, const Repair& repair,
                 const std::vector<bool>& moved) {
  std::vector<std::vector<std::size_t>> outputs(input.segments.size());
  for (std::size_t i = 0; i < repair.output.segments.size(); ++i) {
    for (const SegmentId s : repair.origins[i]) outputs[s].push_back(i);
  }
  for (std::size_t s = 0; s < outputs.size(); ++s) {
    std::vector<Segment> others;
    for (const std::size_t i : outputs[s]) others.push_back(ordered(repair.output.segments[i]));
    const Rest rest =
        rest_of(ordered(input.segments[s]), others, [&](std::size_t) { return bool{moved[s]}; });
    const LineFate fate = rest.has_moved ? LineFate::MovedFrom : LineFate::Removed;
    for (const Segment& part : rest.parts) parts.push_back({fate, part});
  }
}

double length(const ExactComplex& complex, EdgeId e) {
  const PointD p = complex.vertices.nearest(complex.edges[e].tail);
  const PointD q = complex.vertices.nearest(complex.edges[e].head);
  return std::hypot(p.x - q.x, p.y - q.y);
}

/// Of two colours each face after gets the one that fewer of its neighbours have so far.
void tell_apart(std::vector<ShownFace>& faces, const ExactComplex& after) {
  std::vector<int> colour(after.face_count(), -1);
  for (ShownFace& shown : faces) {
    if (!shown.is_after) continue;
    std::array<std::size_t, 2> neighbours{};
    const auto look = [&](CycleId cycle) {
      for (const HalfedgeId h : after.cycles[cycle]) {
        const int other = colour[after.halfedge_face[twin(h)]];
        if (other >= 0) ++neighbours.at(static_cast<std::size_t>(other));
      }
    };
    look(after.face_outer[shown.face]);
    for (const CycleId hole : after.face_holes[shown.face]) look(hole);
    shown.is_other = neighbours[0] > neighbours[1];
    colour[shown.face] = shown.is_other ? 1 : 0;
  }
}

std::string title_of(const FaceOutcome& outcome) {
  const std::string before = short_number(nearest_double(outcome.area_before));
  const std::string after = short_number(nearest_double(outcome.area_after));
  const std::string fate = to_text(outcome.fate) + ' ';
  if (outcome.fate == FaceFate::Closed) return fate + after;
  if (outcome.fate == FaceFate::Opened) return fate + before;
  return fate + before + " -> " + after;
}

}  // namespace

std::vector<LinePart> line_parts(const SegmentSet& input, const Repair& repair) {
  const std::vector<bool> moved = moved_segments(input, repair);
  std::vector<LinePart> parts;
  for (std::size_t i = 0; i < repair.output.segments.size(); ++i) {
    const Segment segment = ordered(repair.output.segments[i]);
    const auto origins = repair.origins[i];
    if (origins.empty()) {
      parts.push_back({LineFate::Virtual, segment});
      continue;
    }
    std::vector<Segment> others;
    for (const SegmentId s : origins) others.push_back(ordered(input.segments[s]));
    const Rest rest =
        rest_of(segment, others, [&](std::size_t o) { return bool{moved[origins[o]]}; });
    for (const Segment& part : rest.common) parts.push_back({LineFate::Kept, part});
    const LineFate fate = rest.has_moved ? LineFate::MovedTo : LineFate::Added;
    for (const Segment& part : rest.parts) parts.push_back({fate, part});
  }
  append_lost(parts, input, repair, moved);
  return parts;
}

std::vector<double> virtual_shares(const Repair& repair, const ExactComplex& after) {
  std::vector<double> all(after.face_count()), of_virtual(after.face_count());
  for (std::size_t e = 0; e < after.edge_count(); ++e) {
    if (after.is_antenna(EdgeId(e))) continue;
    const double size = length(after, EdgeId(e));
    const bool is_virtual = std::ranges::all_of(
        after.edge_sources[e], [&](SegmentId s) { return repair.origins[s].empty(); });
    for (const bool side : {false, true}) {
      const FaceId f = after.halfedge_face[halfedge(EdgeId(e), side)];
      all[f] += size;
      if (is_virtual) of_virtual[f] += size;
    }
  }
  for (std::size_t f = 0; f < all.size(); ++f) {
    all[f] = of_virtual[f] > 0 ? of_virtual[f] / all[f] : 0;
  }
  return all;
}

std::vector<ShownFace> shown_faces(const Repair& repair, const ExactComplex& after) {
  const std::vector<double> shares = virtual_shares(repair, after);
  const auto border = [&](FaceId f) {
    return fmt::format("{:.2g} % of its border virtual", 100 * shares[f]);
  };
  std::vector<bool> is_told(after.face_count());
  std::vector<ShownFace> faces;
  for (const FaceOutcome& outcome : repair.faces) {
    if (outcome.fate == FaceFate::Changed) continue;
    const bool is_after = outcome.fate == FaceFate::Closed || outcome.fate == FaceFate::Split;
    const FaceId face = is_after ? outcome.after : outcome.before;
    std::string title = title_of(outcome);
    if (is_after) {
      is_told[face] = true;
      if (shares[face] > 0) title += ", " + border(face);
    }
    faces.push_back({to_text(outcome.fate), is_after, face, title, outcome.edits, outcome.where,
                     nearest_double(is_after ? outcome.area_after : outcome.area_before)});
  }
  tell_apart(faces, after);
  for (std::size_t f = 1; f < shares.size(); ++f) {
    if (shares[f] == 0 || is_told[f]) continue;
    const double area = nearest_double(face_area(after, FaceId(f)));
    faces.push_back({"virtual",
                     true,
                     FaceId(f),
                     short_number(area) + ", " + border(FaceId(f)),
                     {},
                     interior_point(after, FaceId(f)),
                     area});
  }
  return faces;
}

}  // namespace plumbline
