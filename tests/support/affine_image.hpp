#pragma once

#include "plumbline/complex.hpp"
#include "plumbline/structure.hpp"

/// The image of a complex under an invertible map. A map that reverses orientation turns every
/// cycle.
inline plumbline::ExactComplex affine_image(plumbline::ExactComplex complex,
                                            const plumbline::Affine& map) {
  using namespace plumbline;
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    complex.vertices.replace(v, apply(map, complex.vertices[v]));
  }
  if (map(0, 0) * map(1, 1) > map(0, 1) * map(1, 0)) return canonical(complex);
  Lists<HalfedgeId> cycles;
  for (std::size_t i = 0; i < complex.cycles.size(); ++i) {
    std::vector<HalfedgeId> cycle;
    for (const HalfedgeId h : complex.cycles[i]) cycle.insert(cycle.begin(), twin(h));
    cycles.push_back(cycle);
  }
  complex.cycles = cycles;
  return canonical(complex);
}
