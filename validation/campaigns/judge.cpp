#include "campaigns/judge.hpp"

#include <exception>

#include "plumbline/arrange.hpp"

namespace campaign {

using namespace plumbline;

std::string what_is_wrong(const SegmentSet& input, Relation relation, std::uint64_t seed) try {
  const ExactComplex complex = arrange(input, Engine::Bucket, {1, {}});
  if (complex != arrange(input, Engine::Cgal)) return "the engines differ";
  for (const Violation& violation : validate(complex))
    return "broken invariant: " + to_text(violation.invariant);
  if (!validate_coverage(complex, input).empty()) return "the edges are not the input";
  if (!holds(relation, input, complex, seed)) return to_text(relation) + ": does not hold";
  return "";
} catch (const std::exception& error) {
  return std::string("throws ") + error.what();
}

}  // namespace campaign
