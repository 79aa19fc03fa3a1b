#include "check/right_radii.hpp"
#include "plumbline/check.hpp"

namespace plumbline {

Check advised(Check check, const AdviceOptions& options) {
  const ExactComplex& complex = check.exact_complex;
  if (complex.edge_count() > 0) check.feature_size = feature_size(complex);
  check.ladder = tolerance_ladder(complex, options.ladder);
  if (check.answer.with_radius && options.max_runs > 0) {
    check.right_radii = check_steps::right_radii(check, options);
  }
  return check;
}

}  // namespace plumbline
