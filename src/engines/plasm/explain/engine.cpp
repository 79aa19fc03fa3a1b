// Plasm.jl's 2D arrangement as an engine.

#include "plumbline/engine.hpp"
#include <memory>

#include "engines/plasm/explain/result.hpp"
#include "engines/plasm/explain/run.hpp"
#include "engines/plasm/explain/stages.hpp"
#include "plumbline/engines/plasm.hpp"

namespace plumbline::plasm {
namespace {

constexpr const char* kRadiusName = "radius";

Answer answer(const SegmentSet& input, const Parameters& parameters, std::size_t threads) {
  const auto chosen = parameters.find(kRadiusName);
  const double radius =
      chosen == parameters.end() ? plasm::kRadius : std::get<double>(chosen->second);
  const auto trace = std::make_shared<const Trace>(plasm::run(input, radius));
  Answer answer;
  answer.parameters = {{kRadiusName, radius}};
  answer.complex = result_complex(*trace);
  answer.compared = trace->failure ? Compared::Graph : Compared::All;
  answer.radius = radius;
  answer.failures = failures(*trace);
  for (const Stage stage : {Stage::Transform, Stage::Fragment, Stage::Merge, Stage::ComponentFilter,
                            Stage::EdgeOrder, Stage::FaceWalk, Stage::OuterFace, Stage::Nesting}) {
    answer.stages.push_back(to_text(stage));
  }
  answer.trace = [trace, threads] { return std::make_shared<const ExplainedRun>(trace, threads); };
  if (trace->failure) return answer;  // no radius gives a result that is compared as this one is
  answer.with_radius = [](const SegmentSet& same, double other, std::size_t /*count*/) {
    return RadiusTrial{result_complex(plasm::run(same, other)), other};
  };
  return answer;
}

}  // namespace

Engine engine() {
  return {"plasm",
          "1.0.4",
          "Plasm.jl",
          {{kRadiusName, Parameter::Type::Number,
            "LAR_DEFAULT_ERR: vertices no further apart than this are merged, in drawing units; "
            "parameters and cosines are as near to 0 and 1 [default: 1e-8]"}},
          answer};
}

}  // namespace plumbline::plasm
