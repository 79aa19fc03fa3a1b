#pragma once

#include <span>

#include "plumbline/geometry/point_list.hpp"

namespace plumbline {

/// The point in lowest terms.
Point lowest(const LongPoint& point);

/// Whether point i of a list is the point (x, y). **Exact**.
bool is_at(const PointList& points, std::size_t i, const Number& x, const Number& y);

/// Whether point i of a list lies on the line through a segment, ax, ay, bx, by. **Exact**. Cost:
/// some multiplications, where the point is a WidePoint and the segment decimals of which a few
/// digits suffice.
bool is_on_line(const PointList& points, std::size_t i, std::span<const Number, 4> segment);

}  // namespace plumbline
