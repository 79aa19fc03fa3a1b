#pragma once

#include <string>
#include <vector>

#include "plumbline/engine.hpp"

namespace plumbline::check_steps {

/// Of larger drawings, whether later stages would make a finding again is tried only where the
/// float complex is invalid (Cause::remade): each stage that owns findings takes a run more. Where
/// such a run gives a larger complex, it is not tried of findings that take the correspondence of
/// faces.
inline constexpr std::size_t kMostEdgesRunAgain = 20'000;

/// The arrangement of the rounded input, its comparison and the causes of its findings.
struct Converted {
  const ExactComplex& complex;
  const Comparison& comparison;
  const std::vector<Cause>& causes;
};

/// The causes of the findings of a run's float complex. The owner of a finding is the first stage
/// from which on it is there to the end, each stage's output being continued exactly: its own
/// input, so continued, does not have the finding. What makes the float complex invalid belongs to
/// the stage that left it; what is wrong in the rounded input already has the causes of
/// `converted`. Cost: per stage, from the last one back to the first that is needed, an arrangement
/// and a comparison.
std::vector<Cause> attribute(const Comparison& comparison, const ExactComplex& exact_complex,
                             const FloatComplex& float_complex, const Run& run,
                             const Converted& converted, std::size_t threads);

/// The causes of a comparison of the rounded input: kParse where the finding is there without
/// rounding what maps gave, too; else kTransform. Without `parsed` all is kParse.
std::vector<Cause> attribute_conversion(const Comparison& conversion, const Comparison* parsed,
                                        const ExactComplex& exact_complex);

/// The causes of the findings of an answer that can't be looked into: those of `converted` where
/// rounding to doubles alone makes the finding; else the engine, with the kind of finding as the
/// rule.
std::vector<Cause> attribute_to_engine(const Comparison& comparison, const std::string& engine,
                                       const ExactComplex& exact_complex,
                                       const Converted& converted);

}  // namespace plumbline::check_steps
