#include "campaign/judge.hpp"

#include <exception>

#include "campaign/claims.hpp"
#include "checker/verify.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/output.hpp"

namespace plumbline::campaign {

std::string what_is_wrong(const SegmentSet& input, Relation relation, std::uint64_t seed) try {
  const ExactComplex complex = arrange(input, ExactEngine::Bucket, {1, {}});
  if (relation == Relation::Claims) return refuted_claim(input, complex, seed);
  if (complex != arrange(input, ExactEngine::Cgal)) return "the engines differ";
  for (const Violation& violation : validate(complex)) {
    return "broken invariant: " + to_text(violation.invariant);
  }
  if (!validate_coverage(complex, input).empty()) return "the edges are not the input";
  const auto verdict = plumbline_checker::verify(to_lines(input), certificate(complex, input));
  if (verdict.outcome != plumbline_checker::Outcome::Proved) {
    return "the checker refuses: " + verdict.reason;
  }
  if (!holds(relation, input, complex, seed)) return to_text(relation) + ": does not hold";
  return "";
} catch (const std::exception& error) {
  return std::string("throws ") + error.what();
}

}  // namespace plumbline::campaign
