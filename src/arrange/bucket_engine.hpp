#pragma once

#include "plumbline/complex.hpp"

namespace plumbline {

/// The bucket engine: LAR's independent buckets with exact predicates. Contract: `arrange`.
ExactComplex bucket_engine(const SegmentSet& input);

}  // namespace plumbline
