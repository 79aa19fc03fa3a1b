#pragma once

#include <string>

#include "plumbline/complex.hpp"

namespace plumbline {

/// The certificate of an exact arrangement: the complex, and for each cell what is needed to check
/// it against the input without trusting who made it; `plumbline-verify` does. The format is in
/// docs/certificate.md. **Exact**. Requires: `complex` is what `arrange` returns for `input`.
/// Order: canonical; the same bytes whatever the engine and the number of threads. Cost: linear,
/// and an `interior_point` for each face. Throws: Error Internal where the complex is not that of
/// the input and this is noticed; that no claim is wrong is for the checker to say.
std::string certificate(const ExactComplex& complex, const SegmentSet& input);

}  // namespace plumbline
