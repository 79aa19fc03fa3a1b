// Complexes between exact and double coordinates. Rounding may change the canonical order (two
// vertices may coincide), so the result is put in canonical order anew.

#include <utility>

#include "plumbline/complex.hpp"

namespace plumbline {

FloatComplex nearest(const ExactComplex& complex) {
  FloatComplex result;
  static_cast<Incidences&>(result) = complex;
  result.vertices.reserve(complex.vertices.size());
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    result.vertices.push_back(complex.vertices.nearest(v));
  }
  return canonical(std::move(result));
}

ExactComplex exact(const FloatComplex& complex) {
  ExactComplex result;
  static_cast<Incidences&>(result) = complex;
  result.vertices.reserve(complex.vertices.size());
  for (const PointD& p : complex.vertices) result.vertices.push_back(exact(p));
  return canonical(std::move(result));
}

}  // namespace plumbline
