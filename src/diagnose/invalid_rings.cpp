// The problems of rings as defects.

#include "diagnose/steps.hpp"

namespace plumbline::diagnose_steps {

Defects invalid_rings(const Subject& subject) {
  Defects result(subject.most_listed);
  for (RingProblem& problem : ring_problems(subject.input, subject.graph.complex())) {
    Defect defect;
    defect.kind = DefectKind::InvalidRing;
    defect.where = problem.where;
    if (problem.until) {
      defect.squared_size = squared_distance(problem.where, *problem.until);
      defect.size = nearest_sqrt(*defect.squared_size);
    }
    defect.segments = problem.segments;
    defect.ring = std::move(problem);
    result.add(std::move(defect));
  }
  return result;
}

}  // namespace plumbline::diagnose_steps
