#include "read/dxf/hatch.hpp"

#include <algorithm>
#include <deque>
#include <string>
#include <utility>

#include "read/dxf/curves.hpp"

namespace plumbline::dxf {
namespace {

// Groups of a HATCH, DXF reference.
constexpr int kPathCount = 91;
constexpr int kPathFlags = 92;
constexpr int kEdgeType = 72;  ///< of a polyline: whether it has bulges
constexpr int kSources = 97;   ///< ends a path; in a spline its fit points, which are not used
constexpr int kHatchStyle = 75;
constexpr int kIsCounterClockwise = 73;
constexpr std::int64_t kPolylinePath = 2, kTextPath = 8;
constexpr int kStartAngle = 50, kEndAngle = 51;

/// What the boundaries' edges are, by their numbers.
enum class Edge : std::int64_t { Line = 1, Arc = 2, Ellipse = 3, Spline = 4 };

/// Goes over the groups and draws each polyline and edge at its end.
class HatchReader {
 public:
  HatchReader(const Entity& entity, Pen& pen)
      : groups_(entity.record().groups), numbers_(entity.numbers()), pen_(pen) {}

  DrawnEntity read() && {
    const auto begin = std::find_if(groups_.begin(), groups_.end(),
                                    [](const Group& group) { return group.code == kPathCount; });
    if (begin == groups_.end()) throw Unusable{"hatch without boundaries", {}};
    for (auto group = begin + 1; group != groups_.end(); ++group) {
      if (group->code == kHatchStyle) break;
      visit(*group);
    }
    draw();
    return std::move(drawn_);
  }

 private:
  void visit(const Group& group) {
    const bool is_polyline = (flags_ & kPolylinePath) != 0;
    if (group.code == kPathFlags) {
      draw();
      flags_ = integer_of(group, numbers_);
      is_open_ = (flags_ & kPolylinePath) != 0;
    } else if (group.code == kSources) {
      draw();
    } else if (group.code == kEdgeType && !is_polyline) {
      draw();
      type_ = integer_of(group, numbers_);
      is_open_ = true;
    } else if (is_open_) {
      edge_.groups.push_back(group);
    }
  }

  /// Draws what has been collected.
  void draw() {
    Record edge = std::exchange(edge_, Record{});
    const bool is_drawn = std::exchange(is_open_, false) && (flags_ & kTextPath) == 0;
    if (!is_drawn) return;
    try {
      append(drawn_, (flags_ & kPolylinePath) != 0 ? polyline(std::move(edge))
                                                   : drawn_edge(std::move(edge)));
    } catch (const Unusable& problem) {
      drawn_.refused.push_back({"an edge of its boundary: " + problem.reason, problem.text, false});
    }
  }

  /// A closed LWPOLYLINE, which has the same groups.
  DrawnEntity polyline(Record record) {
    record.type = "LWPOLYLINE";
    record.groups.push_back({kFlags, 0, "1"});
    return draw_shape({record, numbers_}, pen_);
  }

  DrawnEntity drawn_edge(Record edge) {
    switch (static_cast<Edge>(type_)) {
      case Edge::Line:
        edge.type = "LINE";
        break;
      case Edge::Arc:
      case Edge::Ellipse:
        make_counter_clockwise(edge);
        if (type_ == static_cast<std::int64_t>(Edge::Ellipse)) {
          return draw_ellipse_by_degrees({edge, numbers_}, pen_);
        }
        edge.type = "ARC";
        break;
      case Edge::Spline:
        make_spline(edge);
        break;
      default:
        throw Unusable{"not understood", "group 72: " + std::to_string(type_)};
    }
    return draw_shape({edge, numbers_}, pen_);
  }

  /// The angles of what turns clockwise are those of its mirror image.
  void make_counter_clockwise(Record& edge) {
    if (Entity(edge, numbers_).integer(kIsCounterClockwise, 1) != 0) return;
    for (Group& group : edge.groups) {
      if (group.code != kStartAngle && group.code != kEndAngle) continue;
      group.code = group.code == kStartAngle ? kEndAngle : kStartAngle;
      std::string_view angle = group.value;
      const bool is_negative = angle.starts_with('-');
      if (is_negative || angle.starts_with('+')) angle.remove_prefix(1);
      group.value = texts_.emplace_back((is_negative ? "" : "-") + std::string(angle));
    }
  }

  /// The codes of a SPLINE.
  static void make_spline(Record& edge) {
    constexpr int kDegreeOfEdge = 94, kWeightOfEdge = 42, kDegreeOfSpline = 71,
                  kWeightOfSpline = 41;
    edge.type = "SPLINE";
    for (Group& group : edge.groups) {
      if (group.code == kDegreeOfEdge) group.code = kDegreeOfSpline;
      if (group.code == kWeightOfEdge) group.code = kWeightOfSpline;
    }
  }

  const std::vector<Group>& groups_;
  Numbers& numbers_;
  Pen& pen_;
  DrawnEntity drawn_;
  std::int64_t flags_ = 0;  ///< of the path
  std::int64_t type_ = 0;   ///< of the edge
  bool is_open_ = false;    ///< whether groups of a polyline or an edge are being collected
  Record edge_;
  std::deque<std::string> texts_;  ///< of angles
};

}  // namespace

DrawnEntity draw_hatch(const Entity& entity, Pen& pen) {
  DrawnEntity drawn = HatchReader(entity, pen).read();
  if (plane_of(entity) == Plane::Front) return drawn;
  SegmentList mirrored;
  for (std::size_t i = 0; i < drawn.segments.size(); ++i) {
    const auto n = drawn.segments.numbers(i);
    std::vector<NumberPoint> ends{{n[0], n[1]}, {n[2], n[3]}};
    mirror_x(ends);
    mirrored.push_back(ends[0], ends[1]);
  }
  drawn.segments = std::move(mirrored);
  for (Curve& curve : drawn.curves) {
    if (curve.ellipse) mirror_x(*curve.ellipse);
  }
  return drawn;
}

}  // namespace plumbline::dxf
