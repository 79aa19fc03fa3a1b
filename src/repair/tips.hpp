#pragma once

#include <utility>
#include <vector>

#include "repair/work.hpp"

namespace plumbline::repair_steps {

/// A loose end: a vertex of one edge.
struct Tip {
  VertexId vertex;
  Point point;
  LineId line;      ///< that ends there
  Point direction;  ///< in which it leads on, as a vector
};

/// Whether a vector points to the right, or straight up.
inline bool is_forward(const Point& v) { return Point{0, 0} < v; }

/// The loose ends of lines that are not anchored, by vertex.
std::vector<Tip> growing_tips(const Work& work, const Arranged& arranged);

/// For each tip the straight way on, a little longer than the reach.
std::vector<Segment> tracks_of(const std::vector<Tip>& tips, const Rational& reach);

/// Pairs of tips on one line that lead to each other, without another one between them; of each the
/// first one is the one further to the left. Ascending.
std::vector<std::pair<std::size_t, std::size_t>> facing_pairs(const std::vector<Tip>& tips);

}  // namespace plumbline::repair_steps
