#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "plumbline/complex.hpp"

/// Segments from text: four numbers each, e.g. "0 0 1 1  1/3 0 0.5 2"; two numbers after '+' are an
/// isolated point. Every item is a source of its own, numbered from 1 as its line.
inline plumbline::SegmentSet segments(const std::string& text) {
  plumbline::SegmentSet set;
  set.add_file("text");
  std::istringstream words(text);
  const auto point = [&](const std::string& x) {
    std::string y;
    words >> y;
    return plumbline::Point{plumbline::parse_decimal(x), plumbline::parse_decimal(y)};
  };
  std::uint32_t line = 0;
  for (std::string word; words >> word;) {
    const auto source = set.add_source({0, ++line, 1, "text", "", ""});
    if (word == "+") {
      words >> word;
      set.add_point(point(word), source);
    } else {
      const plumbline::Point a = point(word);
      words >> word;
      set.add({a, point(word)}, source);
    }
  }
  return set;
}

inline std::vector<plumbline::Segment> to_vector(const plumbline::SegmentList& segments) {
  return {segments.begin(), segments.end()};
}

/// The segments, each changed by `change`.
template <class Change>
plumbline::SegmentList changed(const plumbline::SegmentList& segments, Change change) {
  std::vector<plumbline::Segment> all = to_vector(segments);
  for (plumbline::Segment& s : all) change(s);
  return plumbline::SegmentList(all);
}

inline plumbline::SegmentList reversed(const plumbline::SegmentList& segments) {
  return changed(segments, [](plumbline::Segment& s) { std::swap(s.a, s.b); });
}

template <class Random>
plumbline::SegmentList shuffled(const plumbline::SegmentList& segments, Random& random) {
  std::vector<plumbline::Segment> all = to_vector(segments);
  std::shuffle(all.begin(), all.end(), random);
  return plumbline::SegmentList(all);
}

/// The first, then the second.
inline plumbline::SegmentList joined(plumbline::SegmentList first,
                                     const plumbline::SegmentList& second) {
  for (const plumbline::Segment& s : second) first.push_back(s);
  return first;
}

/// An axis-parallel rectangle as text for `segments`.
inline std::string rectangle(int x0, int y0, int x1, int y1) {
  std::ostringstream text;
  const auto side = [&](int ax, int ay, int bx, int by) {
    text << ax << ' ' << ay << ' ' << bx << ' ' << by << "  ";
  };
  side(x0, y0, x1, y0);
  side(x1, y0, x1, y1);
  side(x1, y1, x0, y1);
  side(x0, y1, x0, y0);
  return text.str();
}

/// "V 4 E 4 F 2 C 1", faces with the unbounded one, then holes, isolated vertices, antennas and the
/// greatest depth where they are not 0, 0, 0 and 1.
template <class P>
std::string summary(const plumbline::CellComplex<P>& c) {
  std::ostringstream text;
  text << "V " << c.vertices.size() << " E " << c.edge_count() << " F " << c.face_count() << " C "
       << c.component_count();
  std::size_t holes = 0, antennas = 0, depth = 0;
  for (std::size_t f = 1; f < c.face_count(); ++f) {
    holes += c.face_holes[f].size();
    depth = std::max<std::size_t>(depth, c.face_depth[f]);
  }
  for (std::size_t e = 0; e < c.edge_count(); ++e) antennas += c.is_antenna(plumbline::EdgeId(e));
  if (holes != 0) text << " holes " << holes;
  if (!c.face_isolated_vertices.flat().empty()) {
    text << " isolated " << c.face_isolated_vertices.flat().size();
  }
  if (antennas != 0) text << " antennas " << antennas;
  if (depth > 1) text << " depth " << depth;
  return text.str();
}

/// The violations as text, one a line; empty for a valid complex.
inline std::string to_text(const std::vector<plumbline::Violation>& violations) {
  std::string text;
  for (const auto& v : violations) {
    text += to_text(v.invariant) + ": " + v.message + " at " + to_text(v.where) + '\n';
  }
  return text;
}
