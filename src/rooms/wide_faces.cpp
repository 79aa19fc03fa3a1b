#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "plumbline/error.hpp"
#include "rooms/inscribed_circle.hpp"
#include "rooms/steps.hpp"

namespace plumbline::rooms_steps {
namespace {

/// What walls are not as wide as, and no room is smaller than, in metres.
const Rational kLeastWidth(1, 2);
const Rational kLeastArea(1, 2);
/// No plan of rooms is smaller, in metres: files say inches or millimetres where nobody chose.
constexpr double kTiny = 3;
/// What is not as wide as this part of the drawing is no room where there is no unit.
constexpr double kLeastPart = 1.0 / 200;

/// The sides of a face, antennas left out.
std::vector<std::vector<SegmentD>> sides_of_faces(const ExactComplex& complex) {
  std::vector<std::vector<SegmentD>> result(complex.face_count());
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    if (complex.is_antenna(EdgeId(e))) continue;
    const SegmentD side{complex.vertices.nearest(complex.edges[e].tail),
                        complex.vertices.nearest(complex.edges[e].head)};
    if (side.a == side.b) continue;
    for (const bool reversed : {false, true}) {
      const FaceId face = complex.halfedge_face[halfedge(EdgeId(e), reversed)];
      if (face != kUnbounded) result[face].push_back(side);
    }
  }
  return result;
}

/// Three significant digits, exactly.
Rational three_digits(double value) {
  if (!(value > 0)) return 0;
  const double unit = std::pow(10, std::floor(std::log10(value)) - 2);
  return parse_decimal(shortest_text(std::round(value / unit) * unit));
}

/// Where there is no unit, what parts walls from rooms: the middle of the widest clear gap between
/// the widths of faces, above one of a 200th of the drawing to a 20th. Where there is none, a
/// 200th; but 0 where that would leave nothing.
double parting_width(std::vector<double> widths, double extent) {
  constexpr double kMost = 1.0 / 20, kClear = 1.5;
  const double least = kLeastPart * extent;
  std::erase_if(widths, [&](double width) { return width < least; });
  std::sort(widths.begin(), widths.end());
  if (widths.empty()) return 0;
  double ratio = kClear, parting = least;
  for (std::size_t i = 1; i < widths.size() && widths[i - 1] <= kMost * extent; ++i) {
    if (widths[i] <= ratio * widths[i - 1]) continue;
    ratio = widths[i] / widths[i - 1];
    parting = std::sqrt(widths[i] * widths[i - 1]);
  }
  return parting;
}

std::vector<std::string> layers_of(const SegmentSet& input,
                                   const std::vector<SegmentId>& segments) {
  std::set<std::string> layers;
  for (const SegmentId s : segments) {
    std::string layer = input.sources[input.segment_source[s]].layer;
    if (!layer.empty()) layers.insert(std::move(layer));
  }
  return {layers.begin(), layers.end()};
}

/// Whether the drawing is made of areas: then each of them is one, however narrow.
bool is_of_areas(const SegmentSet& input) {
  std::size_t sides = 0;
  for (const Ring& ring : input.rings) {
    if (ring.role != RingRole::Line) sides += ring.count;
  }
  return 2 * sides > input.segments.size();
}

/// The limits that are not given.
void choose_limits(Rooms& result, const RoomOptions& options, const std::vector<Circle>& circles,
                   double extent, bool is_areas) {
  const auto metres = [&](const Rational& value) -> Rational {
    return value / result.unit->metres;
  };
  if (options.min_width) {
    result.min_width = *options.min_width;
  } else if (is_areas) {
    result.min_width = 0;
  } else if (result.unit) {
    result.min_width = metres(kLeastWidth);
  } else {
    std::vector<double> widths;
    for (const Circle& circle : circles) widths.push_back(2 * circle.radius);
    result.min_width = three_digits(parting_width(std::move(widths), extent));
  }
  if (options.min_area) {
    result.min_area = *options.min_area;
  } else if (is_areas) {
    result.min_area = 0;
  } else if (result.unit) {
    result.min_area = metres(metres(kLeastArea));
  } else {
    result.min_area = result.min_width * result.min_width * Rational(9, 4);
  }
}

}  // namespace

Rooms wide_faces(const SegmentSet& input, const ExactComplex& complex, const RoomOptions& options) {
  Rooms result;
  const double extent = plumbline::extent(complex).longer_side();
  result.unit = options.unit ? options.unit : input.unit;
  if (!options.unit && result.unit && extent * nearest_double(result.unit->metres) < kTiny) {
    result.doubted = std::exchange(result.unit, {});
    result.extent = extent;
  }
  const auto sides = sides_of_faces(complex);
  const bool is_areas = is_of_areas(input);
  // Of faces that are narrower than this nothing more is asked.
  const double least = options.min_width ? nearest_double(*options.min_width)
                       : is_areas        ? 0
                       : result.unit     ? nearest_double(kLeastWidth / result.unit->metres)
                                         : kLeastPart * extent;
  const auto circles_in = [&](double width) {
    std::vector<Circle> found;
    for (const auto& of_face : sides) found.push_back(inscribed_circle(of_face, width / 2));
    return found;
  };
  std::vector<Circle> circles = circles_in(least);
  choose_limits(result, options, circles, extent, is_areas);
  if (sgn(result.min_width) == 0 && least > 0) circles = circles_in(0);

  const std::vector<Rational> areas = face_areas(complex);
  const std::vector<double> lengths = perimeters(complex);
  const auto sources = face_sources(complex);
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    const double width = 2 * circles[f].radius;
    if (width < nearest_double(result.min_width)) {
      ++result.narrow;
    } else if (areas[f] < result.min_area) {
      ++result.small;
    } else {
      result.rooms.push_back({FaceId(f),
                              {},
                              layers_of(input, sources[f]),
                              areas[f],
                              {},
                              lengths[f],
                              width,
                              circles[f].centre,
                              complex.face_depth[f],
                              {},
                              {}});
    }
  }
  return result;
}

std::vector<std::size_t> room_of_face(const Rooms& rooms, const ExactComplex& complex) {
  std::vector<std::size_t> result(complex.face_count(), kNoRoom);
  for (std::size_t r = 0; r < rooms.rooms.size(); ++r) result[rooms.rooms[r].face] = r;
  return result;
}

std::size_t room_around(const std::vector<FaceId>& surrounding,
                        const std::vector<std::size_t>& room_of, FaceId face) {
  while (face != kUnbounded && room_of[face] == kNoRoom) face = surrounding[face];
  return room_of[face];
}

}  // namespace plumbline::rooms_steps
