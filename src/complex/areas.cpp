#include "plumbline/complex.hpp"

namespace plumbline {

std::vector<Rational> cycle_areas(const ExactComplex& complex) {
  std::vector<Rational> areas(complex.cycles.size());
  for (std::size_t c = 0; c < areas.size(); ++c) {
    Rational twice = 0;
    for (const HalfedgeId h : complex.cycles[c]) {
      const Point& p = complex.vertices[complex.origin(h)];
      const Point& q = complex.vertices[complex.target(h)];
      twice += p.x * q.y - q.x * p.y;
    }
    areas[c] = twice / 2;
  }
  return areas;
}

std::vector<Rational> face_areas(const ExactComplex& complex) {
  const std::vector<Rational> of_cycles = cycle_areas(complex);
  std::vector<Rational> areas(complex.face_count());
  for (std::size_t f = 1; f < areas.size(); ++f) {
    areas[f] = of_cycles[complex.face_outer[f]];
    for (const CycleId hole : complex.face_holes[f]) areas[f] += of_cycles[hole];
  }
  return areas;
}

}  // namespace plumbline
