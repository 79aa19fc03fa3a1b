// Float LAR as an engine.

#include "plumbline/engine.hpp"
#include "engines/lar/explain/run.hpp"
#include "engines/lar/explain/stages.hpp"
#include "plumbline/engines/lar.hpp"

namespace plumbline::lar {
namespace {

constexpr const char* kRadius = "radius";

std::optional<double> radius_of(const Parameters& parameters) {
  const auto found = parameters.find(kRadius);
  return found == parameters.end() ? std::nullopt : std::optional(std::get<double>(found->second));
}

Answer run(const SegmentSet& input, const Parameters& parameters, std::size_t threads) {
  Result result = arrange(input, {radius_of(parameters), threads});
  Answer answer;
  answer.complex = std::move(result.complex);
  answer.radius = result.trace.radius;
  if (result.trace.radius_from_segment) answer.radius_from = "segment";
  answer.parameters = {{kRadius, result.trace.radius}};
  for (const Stage stage : {Stage::Transform, Stage::Intersect, Stage::Prune, Stage::EdgeOrder,
                            Stage::FaceWalk, Stage::OuterFace, Stage::Nesting}) {
    answer.stages.push_back(to_text(stage));
  }
  const auto trace = std::make_shared<const Trace>(std::move(result.trace));
  answer.trace = [trace, threads] { return std::make_shared<const ExplainedRun>(trace, threads); };
  answer.with_radius = [](const SegmentSet& same, double radius, std::size_t count) {
    Result other = arrange(same, {radius, count});
    return RadiusTrial{std::move(other.complex), other.trace.radius};
  };
  return answer;
}

}  // namespace

Engine engine() {
  return {
      "lar",
      "repaired",
      "float LAR",
      {{kRadius, Parameter::Type::Number,
        "vertices no further apart than this are merged, in drawing units [default: 0.001 x the "
        "drawing's longer side, at most a quarter of its shortest segment; at least 2^-46 x its "
        "largest coordinate]"}},
      run};
}

}  // namespace plumbline::lar
