#include "read/dxf/mline.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "read/dxf/polyline.hpp"

namespace plumbline::dxf {
namespace {

constexpr int kMlineVertexX = 11;
constexpr int kDirectionX = 12;
constexpr int kMiterX = 13;
constexpr int kParameterCount = 74;
constexpr int kParameter = 41;
constexpr int kMlineFlags = 71;
constexpr std::int64_t kClosedMline = 2, kNoStartCap = 4, kNoEndCap = 8;

struct MlineVertex {
  Point at, direction, miter;
  /// Per line: where it crosses the miter; then, along the direction from there, where it begins,
  /// ends, begins again, ...
  std::vector<std::vector<Rational>> parameters;
};

Point along(const Point& p, const Point& direction, const Rational& distance) {
  return {p.x + direction.x * distance, p.y + direction.y * distance};
}

NumberPoint stored(const Point& p) { return {Number(p.x), Number(p.y)}; }

std::vector<MlineVertex> mline_vertices(const Entity& entity) {
  std::vector<MlineVertex> vertices;
  for (const Group& group : entity.record().groups) {
    const auto number = [&] { return number_of(group, entity.numbers()).rational(); };
    if (group.code == kMlineVertexX) vertices.push_back({{number(), 0}, {}, {}, {}});
    if (vertices.empty()) continue;
    MlineVertex& last = vertices.back();
    constexpr int kFromXToY = 10;
    if (group.code == kMlineVertexX + kFromXToY) last.at.y = number();
    if (group.code == kDirectionX) last.direction.x = number();
    if (group.code == kDirectionX + kFromXToY) last.direction.y = number();
    if (group.code == kMiterX) last.miter.x = number();
    if (group.code == kMiterX + kFromXToY) last.miter.y = number();
    if (group.code == kParameterCount) last.parameters.emplace_back();
    if (group.code == kParameter && !last.parameters.empty()) {
      last.parameters.back().push_back(number());
    }
  }
  if (vertices.size() < 2) throw Unusable{"multiline of fewer than two vertices", {}, true};
  const std::size_t lines = vertices.front().parameters.size();
  for (const MlineVertex& vertex : vertices) {
    const bool is_whole =
        lines > 0 && vertex.parameters.size() == lines &&
        std::none_of(vertex.parameters.begin(), vertex.parameters.end(),
                     [](const std::vector<Rational>& list) { return list.empty(); });
    if (!is_whole) throw Unusable{"multiline without parameters for all of its lines", {}};
  }
  return vertices;
}

Point start_of(const MlineVertex& vertex, std::size_t line) {
  return along(vertex.at, vertex.miter, vertex.parameters[line].front());
}

/// One line from a vertex to the next.
void draw_piece(DrawnEntity& drawn, const MlineVertex& from, const MlineVertex& to,
                std::size_t line) {
  const std::vector<Rational>& stops = from.parameters[line];
  const Point start = start_of(from, line);
  if (stops.size() == 1) {
    return drawn.segments.push_back(stored(start), stored(start_of(to, line)));
  }
  for (std::size_t i = 1; i < stops.size(); i += 2) {
    const bool is_last = i + 1 == stops.size();
    const Point end = is_last ? start_of(to, line) : along(start, from.direction, stops[i + 1]);
    drawn.segments.push_back(stored(along(start, from.direction, stops[i])), stored(end));
  }
}

/// The lines in their order across a vertex.
std::vector<std::size_t> across(const MlineVertex& vertex) {
  std::vector<std::size_t> order(vertex.parameters.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return vertex.parameters[a].front() < vertex.parameters[b].front();
  });
  return order;
}

void join(DrawnEntity& drawn, const MlineVertex& vertex, std::size_t a, std::size_t b) {
  drawn.segments.push_back(stored(start_of(vertex, a)), stored(start_of(vertex, b)));
}

/// A half circle between two lines at an end of them, on the side of `outwards`.
void join_by_arc(DrawnEntity& drawn, const MlineVertex& vertex, std::size_t a, std::size_t b,
                 const Point& outwards, Pen& pen) {
  const Point p = start_of(vertex, a), q = start_of(vertex, b);
  const Rational side = (q.x - p.x) * outwards.y - (q.y - p.y) * outwards.x;
  if (sgn(side) == 0) return;
  const Number bulge = Number::decimal(sgn(side) < 0 ? 1 : -1, 0);
  append(drawn, draw_polyline({{stored(p), bulge}, {stored(q), {}}}, false, Plane::Front, pen));
}

/// What a style draws at an end.
struct Cap {
  bool line, inner_arcs, arc;
};

void draw_cap(DrawnEntity& drawn, const MlineVertex& vertex, const Point& outwards, const Cap& cap,
              Pen& pen) {
  const std::vector<std::size_t> order = across(vertex);
  if (order.size() < 2) return;
  if (cap.line) join(drawn, vertex, order.front(), order.back());
  if (cap.arc) join_by_arc(drawn, vertex, order.front(), order.back(), outwards, pen);
  if (!cap.inner_arcs) return;
  for (std::size_t i = 1, k = order.size() - 2; i < k; ++i, --k) {
    join_by_arc(drawn, vertex, order[i], order[k], outwards, pen);
  }
}

}  // namespace

std::int64_t MlineStyles::flags(std::string_view name) {
  if (!flags_) {
    flags_.emplace();
    RecordReader records(text_, file_);
    Record record;
    Numbers numbers;
    constexpr int kStyleName = 2;
    while (records.next(record)) {
      if (record.type != "MLINESTYLE") continue;
      const Entity style(record, numbers);
      std::int64_t flags = 0;
      parse_integer(style.text(kFlags), flags);
      flags_->emplace(names_.key(style.text(kStyleName)), flags);
    }
  }
  const auto found = flags_->find(names_.key(name));
  return found == flags_->end() ? 0 : found->second;
}

DrawnEntity draw_mline(const Entity& entity, std::int64_t style, Pen& pen) {
  const std::vector<MlineVertex> vertices = mline_vertices(entity);
  const std::int64_t flags = entity.integer(kMlineFlags, 0);
  const bool closed = (flags & kClosedMline) != 0;
  DrawnEntity drawn;
  for (std::size_t line = 0; line < vertices.front().parameters.size(); ++line) {
    const std::size_t first = drawn.segments.size();
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      draw_piece(drawn, vertices[i - 1], vertices[i], line);
    }
    if (!closed) continue;
    draw_piece(drawn, vertices.back(), vertices.front(), line);
    if (drawn.segments.size() == first + vertices.size()) end_ring(drawn, first);
  }
  const auto has = [style](std::int64_t flag) { return (style & flag) != 0; };
  if (has(kJoints)) {
    for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < vertices.size(); ++i) {
      const std::vector<std::size_t> order = across(vertices[i]);
      if (order.size() > 1) join(drawn, vertices[i], order.front(), order.back());
    }
  }
  if (closed) return drawn;
  const MlineVertex& start = vertices.front();
  const Point before{-start.direction.x, -start.direction.y};
  if ((flags & kNoStartCap) == 0) {
    draw_cap(drawn, start, before, {has(kStartLine), has(kStartInnerArcs), has(kStartArc)}, pen);
  }
  // The direction of the last vertex may not be given: that of the last piece.
  const Point ahead = vertices[vertices.size() - 2].direction;
  if ((flags & kNoEndCap) == 0) {
    draw_cap(drawn, vertices.back(), ahead, {has(kEndLine), has(kEndInnerArcs), has(kEndArc)}, pen);
  }
  return drawn;
}

}  // namespace plumbline::dxf
