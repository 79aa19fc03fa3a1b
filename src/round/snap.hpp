#pragma once

#include "plumbline/arrange.hpp"
#include "round/hot_pixels.hpp"

namespace plumbline::round_steps {

/// The chains of centres of hot pixels as a complex, and per edge its chain. Sources are those of
/// all exact edges. Throws: Error Internal if chains meet elsewhere than at the centres.
struct Snapped {
  ExactComplex complex;
  Lists<VertexId> chains;
};
Snapped snapped(const ExactComplex& exact, const HotPixels& pixels, const Rational& spacing,
                const ArrangeOptions& options);

}  // namespace plumbline::round_steps
