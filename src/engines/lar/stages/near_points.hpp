#pragma once

#include <functional>
#include <memory>
#include <span>

#include "plumbline/geometry.hpp"

namespace plumbline::lar {

/// Points in a KD-tree, for the question which of them are near each other. Keeps the span, not the
/// points.
class NearPoints {
 public:
  NearPoints(std::span<const PointD> points, double radius);
  NearPoints(const NearPoints&) = delete;
  NearPoints& operator=(const NearPoints&) = delete;
  ~NearPoints();

  /// Calls visit(j) for all points j (i too) no further than the radius from point i, in no order.
  void for_each(std::size_t i, const std::function<void(std::size_t)>& visit) const;

 private:
  struct Tree;
  std::span<const PointD> points_;
  double radius_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace plumbline::lar
