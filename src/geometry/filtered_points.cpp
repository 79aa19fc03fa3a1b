#include "geometry/filtered_points.hpp"

#include "geometry/point_d.hpp"

namespace plumbline {

FilteredPoints::FilteredPoints(const PointList& points) : points_(points) {
  rough_.reserve(points.size());
  // Truncates, hence monotone.
  for (std::size_t p = 0; p < points.size(); ++p) rough_.push_back(points.truncated(p));
  // Truncating to 53 bits loses less than 2^-52 of a number, or 2^-1074.
  error_ = 0x1p-51 * largest_coordinate(rough_) + 0x1p-1022;
}

int FilteredPoints::exact_orientation(std::size_t p, std::size_t q, std::size_t r) const {
  return plumbline::orientation(points_[p], points_[q], points_[r]);
}

}  // namespace plumbline
