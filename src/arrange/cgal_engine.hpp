#pragma once

#include "plumbline/complex.hpp"

namespace plumbline {

/// The reference engine: CGAL's aggregated insertion. Contract: `arrange`.
ExactComplex cgal_engine(const SegmentSet& input);

}  // namespace plumbline
