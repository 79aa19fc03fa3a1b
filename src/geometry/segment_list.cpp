#include <algorithm>

#include "plumbline/geometry.hpp"

namespace plumbline {

SegmentList::SegmentList(std::span<const Segment> segments) {
  reserve(segments.size());
  for (const Segment& segment : segments) push_back(segment);
}

Segment SegmentList::operator[](std::size_t i) const {
  const auto n = numbers(i);
  return {{n[0].rational(), n[1].rational()}, {n[2].rational(), n[3].rational()}};
}

Segment SegmentList::at(std::size_t i) const {
  static_cast<void>(numbers_.at(4 * i));
  return (*this)[i];
}

void SegmentList::push_back(Segment segment) {
  push_back({std::move(segment.a.x), std::move(segment.a.y)},
            {std::move(segment.b.x), std::move(segment.b.y)});
}

void SegmentList::push_back(NumberPoint a, NumberPoint b) {
  if (numbers_.size() == numbers_.capacity()) reserve(std::max<std::size_t>(1, 2 * size()));
  numbers_.push_back(std::move(a.x));
  numbers_.push_back(std::move(a.y));
  numbers_.push_back(std::move(b.x));
  numbers_.push_back(std::move(b.y));
}

}  // namespace plumbline
