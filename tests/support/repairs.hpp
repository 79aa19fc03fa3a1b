#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "plumbline/arrange.hpp"
#include "plumbline/edits.hpp"
#include "segments.hpp"

namespace plumbline {

/// A repair made by hand.
struct Made {
  std::string name;
  SegmentSet input;
  Repair repair;
};

/// A line, as text "ax ay bx by", that stands for these segments.
inline Line line(const std::string& text, const std::vector<std::size_t>& ids) {
  const Segment s = segments(text).segments[0];
  Line result{std::min(s.a, s.b), std::max(s.a, s.b), {}};
  for (const std::size_t id : ids) result.segments.emplace_back(id);
  return result;
}

inline Point point(const std::string& text) { return segments(text + " 1e9 1e9").segments[0].a; }

/// The lines after the edits, as output; and the faces.
inline void finish(const SegmentSet& input, Repair& repair) {
  std::vector<Line> lines;
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const Segment segment = input.segments[s];
    lines.push_back(
        {std::min(segment.a, segment.b), std::max(segment.a, segment.b), {SegmentId(s)}});
  }
  for (const Edit& edit : repair.edits) {
    for (const Line& line : edit.before) {
      const auto place = std::ranges::find(lines, line);
      if (place != lines.end()) lines.erase(place);
    }
    lines.insert(lines.end(), edit.after.begin(), edit.after.end());
  }
  repair.output = input;
  repair.output.segments = {};
  repair.output.segment_source.clear();
  repair.origins = {};
  Source virtual_source;
  virtual_source.layer = kVirtualLayer;
  const SourceId added = repair.output.add_source(virtual_source);
  for (const Line& line : lines) {
    repair.output.segments.push_back(Segment{line.b, line.a});
    repair.output.segment_source.push_back(
        line.segments.empty() ? added : input.segment_source[line.segments.front()]);
    repair.origins.push_back(line.segments);
  }
  repair.faces = face_outcomes(arrange(input), repair, arrange(repair.output));
}

inline Made made(std::string name, const std::string& drawing, const Tolerances& tolerances,
                 std::vector<Edit> edits) {
  Made result{std::move(name), segments(drawing), {}};
  result.repair.tolerances = tolerances;
  result.repair.edits = std::move(edits);
  finish(result.input, result.repair);
  return result;
}

inline Rational decimal(const std::string& text) { return parse_decimal(text); }

/// Of operations that are not named 0.
inline Tolerances up_to(Rational Tolerances::*operation, const std::string& distance) {
  Tolerances result{0, 0, 0, 0, 0, 0, {}};
  result.*operation = decimal(distance);
  return result;
}

inline Made corner() {
  return made("corner", "0 0 10.03 0  10 0.02 10 8  10 8 0 8  0 8 0 0",
              {0, decimal("0.05"), decimal("0.05"), 0, 0, 0, {}},
              {{EditKind::Grow,
                point("10 0.02"),
                decimal("0.0004"),
                {line("10 0.02 10 8", {1})},
                {line("10 0 10 8", {1})}},
               {EditKind::Trim,
                point("10 0"),
                decimal("0.0009"),
                {line("0 0 10.03 0", {0})},
                {line("0 0 10 0", {0})}}});
}

inline Made pieces() {
  return made("pieces", "0 0 5 0  5.06 0 5.1 0  5.15 0 10 0  10 0 10 8  10 8 0 8  0 8 0 0",
              up_to(&Tolerances::grow, "0.1"),
              {{EditKind::Bridge,
                point("5 0"),
                decimal("0.0036"),
                {line("0 0 5 0", {0}), line("5.06 0 5.1 0", {1})},
                {line("0 0 5.1 0", {0, 1})}},
               {EditKind::Bridge,
                point("5.1 0"),
                decimal("0.0025"),
                {line("0 0 5.1 0", {0, 1}), line("5.15 0 10 0", {2})},
                {line("0 0 10 0", {0, 1, 2})}}});
}

/// Two ends meet on a wall between them.
inline Made meeting_on_wall() {
  return made("meeting on a wall", "0 0 4 0  4.02 0 8 0  4.015 -1 4.015 1",
              up_to(&Tolerances::grow, "0.1"),
              {{EditKind::Bridge,
                point("4 0"),
                decimal("0.0004"),
                {line("0 0 4 0", {0}), line("4.02 0 8 0", {1})},
                {line("0 0 8 0", {0, 1})}}});
}

inline Made door() {
  return made("door",
              "0 0 12 0  12 0 12 6  12 6 0 6  0 6 0 0  6 0 6 2.5  6 3.4 6 6  6.6 3 8.5 3  "
              "9 0 9 1.5  9 4.5 9 6",
              {0, 0, 0, 0, 0, 0, Range{decimal("0.6"), decimal("1.2")}},
              {{EditKind::Door, point("6 2.5"), decimal("0.81"), {}, {line("6 2.5 6 3.4", {})}}});
}

inline Made doubled() {
  return made("doubled", "0 0 10 0  0 0.002 7 0.002  10 0 10 8  10 8 0 8  0 8 0 0  4 0.002 4 8",
              up_to(&Tolerances::weld, "0.01"),
              {{EditKind::Weld,
                point("0 0.002"),
                decimal("0.000004"),
                {line("0 0.002 7 0.002", {1})},
                {line("0 0 7 0", {1})}},
               {EditKind::Weld,
                point("4 0.002"),
                decimal("0.000004"),
                {line("4 0.002 4 8", {5})},
                {line("4 0 4 8", {5})}},
               {EditKind::Merge,
                point("0 0"),
                0,
                {line("0 0 10 0", {0}), line("0 0 7 0", {1})},
                {line("0 0 10 0", {0, 1})}}});
}

inline Made dangles() {
  return made("dangles",
              "0 0 10 0  10 0 10 8  10 8 0 8  0 8 0 0  5 0 5 0.2  5 0.2 4.7 0.2  5 0.2 5 0.6",
              up_to(&Tolerances::trim, "0.5"),
              {{EditKind::Trim, point("5 0.2"), decimal("0.09"), {line("5 0.2 4.7 0.2", {5})}, {}},
               {EditKind::Dissolve,
                point("5 0.2"),
                0,
                {line("5 0 5 0.2", {4}), line("5 0.2 5 0.6", {6})},
                {line("5 0 5 0.6", {4, 6})}}});
}

/// A wall of two lines, not quite parallel, that meet at one end and are joined at the other one.
inline Made thin() {
  return made("thin", "0 0 10 0  10 0 10 8  10 8 0 8  0 8 0 0  0 4 10 4  0 4 5 4.01  5 4.01 10 4",
              up_to(&Tolerances::sliver, "0.02"),
              {{EditKind::Sliver,
                point("5 4.01"),
                decimal("0.0001"),
                {line("0 4 5 4.01", {5}), line("5 4.01 10 4", {6})},
                {}}});
}

inline Made simplified() {
  return made("simplified", "0 0 10 0  10 0 10 8  10 8 0 8  0 8 0 0  0 4 5 4.01  5 4.01 10 4",
              up_to(&Tolerances::simplify, "0.02"),
              {{EditKind::Simplify,
                point("5 4.01"),
                decimal("0.0001"),
                {line("0 4 5 4.01", {4}), line("5 4.01 10 4", {5})},
                {line("0 4 10 4", {4, 5})}}});
}

}  // namespace plumbline
