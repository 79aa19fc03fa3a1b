#pragma once

#include "engine/stages.hpp"

namespace plumbline::checking {

/// Of larger drawings, whether later stages would make a finding again is tried only where the
/// float complex is invalid (Cause::remade): each stage that owns findings takes a run more.
inline constexpr std::size_t kMostEdgesRunAgain = 20'000;

/// Fills in the causes of all findings of `result`, the cross-check of a run's float complex. The
/// owner of a finding is the first stage from which on it is there to the end, each stage's output
/// being continued exactly: its own input, so continued, does not have the finding. What makes the
/// float complex invalid belongs to the stage that left it. `conversion` is the cross-check of the
/// rounded input, its causes filled in: what is wrong from there on has those. Cost: per stage,
/// from the last one back to the first that is needed, an arrangement and a cross-check.
void attribute(Crosscheck& result, const ExactComplex& exact_complex,
               const FloatComplex& float_complex, const TracedRun& run,
               const Crosscheck& conversion, std::size_t threads);

/// Fills in the causes of a cross-check of the rounded input: Parse where the finding is there
/// without rounding what maps gave, too; else Transform. Without `parsed` all is Parse.
void attribute_conversion(Crosscheck& conversion, const Crosscheck* parsed,
                          const ExactComplex& exact_complex);

/// Fills in the causes of the cross-check of a result that another program made: those of
/// `conversion`, its own filled in, where rounding to doubles alone makes the finding; else
/// Foreign, with the kind of finding as the rule.
void attribute_foreign(Crosscheck& result, const ExactComplex& exact_complex,
                       const Crosscheck& conversion);

}  // namespace plumbline::checking
