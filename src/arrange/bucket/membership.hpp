#pragma once

#include "arrange/bucket/buckets.hpp"

namespace plumbline::bucket {

/// Tells whether points are in a bucket; the same as `bucket_at`, but faster away from its border.
class Membership {
 public:
  Membership(const Buckets& buckets, std::size_t bucket)
      : buckets_(buckets),
        bucket_(bucket),
        box_(buckets.box(bucket)),
        margin_(buckets.margin().border),
        is_box_(buckets.is_box(bucket)) {}

  bool contains(const PointD& p) const {
    if (p.x < box_.x0 - margin_ || box_.x1 + margin_ < p.x || p.y < box_.y0 - margin_ ||
        box_.y1 + margin_ < p.y) {
      return false;
    }
    if (is_box_ && box_.x0 + margin_ < p.x && p.x < box_.x1 - margin_ && box_.y0 + margin_ < p.y &&
        p.y < box_.y1 - margin_) {
      return true;
    }
    return buckets_.bucket_at(p.x, p.y) == bucket_;
  }

 private:
  const Buckets& buckets_;
  std::size_t bucket_;
  Box box_;
  double margin_;
  bool is_box_;
};

}  // namespace plumbline::bucket
