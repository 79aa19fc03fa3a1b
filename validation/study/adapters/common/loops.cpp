#include "loops.hpp"

#include <algorithm>

namespace study {
namespace {

double twice_area(const Ring& ring, const std::vector<Point>& vertices) {
  const auto at = [&](std::size_t i) {
    return vertices[static_cast<std::size_t>(ring[i % ring.size()])];
  };
  const Point o = at(0);
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = at(i);
    const Point b = at(i + 1);
    sum += (a[0] - o[0]) * (b[1] - o[1]) - (b[0] - o[0]) * (a[1] - o[1]);
  }
  return sum;
}

}  // namespace

std::vector<Ring> rings_of_walk(const Ring& walk, const std::vector<Point>& vertices) {
  std::vector<Ring> rings;
  Ring way;
  std::map<Edge, std::size_t> on_way;  // edges, and where on the way they start
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const std::int64_t from = walk[i];
    const std::int64_t to = walk[(i + 1) % walk.size()];
    const auto twin = on_way.find({to, from});
    if (twin == on_way.end()) {
      on_way[{from, to}] = way.size();
      way.push_back(from);
      continue;
    }
    const auto start = way.begin() + static_cast<std::ptrdiff_t>(twin->second);
    const Ring between(start, way.end());
    way.erase(start, way.end());
    for (std::size_t k = 0; k < between.size(); ++k) {
      on_way.erase({between[k], k + 1 < between.size() ? between[k + 1] : from});
    }
    if (between.size() > 1) rings.emplace_back(between.begin() + 1, between.end());
  }
  if (!way.empty()) rings.push_back(way);
  std::stable_sort(rings.begin(), rings.end(), [&](const Ring& a, const Ring& b) {
    return twice_area(a, vertices) > twice_area(b, vertices);
  });
  return rings;
}

}  // namespace study
