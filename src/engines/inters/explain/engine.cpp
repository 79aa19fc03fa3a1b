// LAR's module inters as an engine.

#include <algorithm>
#include <map>

#include "engines/inters/explain/run.hpp"
#include "engines/inters/explain/stages.hpp"
#include "engines/inters/explain/svg_lines.hpp"
#include "plumbline/engine.hpp"

namespace plumbline::inters {
namespace {

constexpr const char* kRadiusName = "radius";
constexpr const char* kDecimalsName = "decimals";
constexpr const char* kResultName = "result";

const std::map<std::string, Result>& results() {
  static const std::map<std::string, Result> by_name{{"larFromLines", Result::LarFromLines},
                                                     {"allComponents", Result::AllComponents},
                                                     {"cells", Result::CellsFromCycles}};
  return by_name;
}

template <class T>
T value_of(const Parameters& parameters, const char* name, T otherwise) {
  const auto found = parameters.find(name);
  return found == parameters.end() ? otherwise : std::get<T>(found->second);
}

Answer answer(const SegmentSet& input, const Original& original, const Parameters& parameters,
              std::size_t threads) {
  Options options;
  options.radius = value_of(parameters, kRadiusName, inters::kRadius);
  options.decimals = static_cast<int>(std::clamp<std::int64_t>(
      value_of(parameters, kDecimalsName, std::int64_t{inters::kDecimals}), -1, kMaxDecimals + 1));
  options.threads = threads;
  const std::string result = value_of(parameters, kResultName, std::string("larFromLines"));
  const auto trace =
      std::make_shared<const Trace>(inters::run(original.lines.value_or(lines(input)), options));
  const auto run = std::make_shared<const ExplainedRun>(trace, results().at(result), threads);
  Answer answer;
  answer.parameters = {{kRadiusName, options.radius},
                       {kDecimalsName, std::int64_t{options.decimals}},
                       {kResultName, result}};
  answer.complex = run->complex();
  answer.compared = run->has_faces() ? Compared::All : Compared::Graph;
  answer.radius = options.radius;
  answer.failures = run->failures();
  if (original.svg) {
    for (Explained& misread : svg_to_lines_findings(*original.svg, input)) {
      answer.failures.push_back(std::move(misread));
    }
  }
  for (const Stage stage : {Stage::Transform, Stage::Quantise, Stage::Bucket, Stage::Intersect,
                            Stage::Prune, Stage::Simplify, Stage::ComponentFilter, Stage::EdgeOrder,
                            Stage::FaceWalk, Stage::OuterFace, Stage::Nesting}) {
    answer.stages.push_back(to_text(stage));
  }
  answer.trace = [run] { return run; };
  return answer;
}

}  // namespace

Engine engine(Original original) {
  return {
      "inters",
      "2015",
      "LAR inters",
      {{kRadiusName, Parameter::Type::Number,
        "vertices no further apart than this are merged, in drawing units [default: 0.001]"},
       {kDecimalsName, Parameter::Type::Integer,
        "decimals of coordinates and parameters [default: 4]"},
       {kResultName,
        Parameter::Type::Text,
        "which of its results: the faces of the component with most edges, of all components, or "
        "cells with holes [default: larFromLines]",
        {"larFromLines", "allComponents", "cells"}}},
      [original = std::move(original)](const SegmentSet& input, const Parameters& parameters,
                                       std::size_t threads) {
        return answer(input, original, parameters, threads);
      }};
}

}  // namespace plumbline::inters
