#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plumbline/edits.hpp"

// Points of one line are in lexicographic order along it; all segments here have their lesser end
// first.
namespace plumbline::edits {

inline Segment extent_of(const Line& line) { return {line.a, line.b}; }
std::vector<Segment> extents_of(std::span<const Line> lines);

bool is_collinear(const Segment& s, const Segment& t);
/// Whether every point of the part is one of the whole.
bool covers(const Segment& whole, const Segment& part);
/// Whether a point of `other` lies strictly between the ends of the segment.
bool meets_inside(const Segment& segment, const Segment& other);
/// The point that two segments of different directions have in common, if there is one.
std::optional<Point> crossing(const Segment& s, const Segment& t);
/// What is left of the segments without the lines; what is but a point is not.
std::vector<Segment> without(std::vector<Segment> segments, std::span<const Line> lines);
/// The least squared distance of the point from the segments. Requires: at least one.
Rational squared_distance(const Point& p, std::span<const Segment> segments);
/// The largest of these least ones of all ends of `from`; 0 for none. Requires: `to` has some.
Rational farthest_end(std::span<const Segment> from, std::span<const Segment> to);

/// All input segments that the lines stand for, ascending, each once.
std::vector<SegmentId> segments_of(std::span<const Line> lines);
bool share_segment(std::span<const SegmentId> a, std::span<const SegmentId> b);

/// The same segment with its lesser end first.
Segment ordered(Segment segment);

/// The square root in short words, for a message.
std::string length_text(const Rational& squared);

}  // namespace plumbline::edits
