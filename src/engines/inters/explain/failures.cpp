// Where the published pipeline has no result, or says itself that it is not all.

#include <fmt/format.h>

#include <algorithm>

#include "engines/inters/explain/run.hpp"

namespace plumbline::inters {
namespace {

std::string text(const Failure& failure) {
  if (failure.error == "NoTermination") {
    return fmt::format("{} runs for ever ({})", failure.function, failure.message);
  }
  return fmt::format("{} fails with {}: {}", failure.function, failure.error, failure.message);
}

const char* key(Result result) {
  switch (result) {
    case Result::LarFromLines:
      return "larFromLines";
    case Result::AllComponents:
      return "allComponents";
    case Result::CellsFromCycles:
      return "latticeArray";
  }
  return "";
}

void set_cause(Cause& cause, const char* rule, const char* explanation, const char* advice) {
  cause.rule = rule;
  cause.explanation = explanation;
  cause.advice = advice;
}

Explained about_complex(Disagreement disagreement, std::string message, Stage stage) {
  Explained result;
  result.finding.kind = CellKind::Complex;
  result.finding.disagreement = disagreement;
  result.finding.message = std::move(message);
  result.cause.stage = to_text(stage);
  result.cause.confirmed = true;  // the exact counterpart always has a result
  return result;
}

Explained no_cycle() {
  Explained result = about_complex(Disagreement::Missing,
                                   "the published pipeline has no result: there is no cycle",
                                   Stage::ComponentFilter);
  set_cause(result.cause, "no-cycle", "where there is no cycle, nothing is returned",
            "return the vertices and edges, and the unbounded face");
  return result;
}

}  // namespace

/// The failure as a finding; its rule is filled in for the stages that have only one.
Explained ExplainedRun::failure(const Failure& failure) const {
  const auto missing = [&](Stage stage) {
    return about_complex(Disagreement::Missing,
                         "the published pipeline has no result: " + text(failure), stage);
  };
  const auto by_stage = [&](Stage stage) {
    Explained result = missing(stage);
    result.cause = explained(result.finding, std::move(result.cause));
    return result;
  };
  if (failure.stage == "buckets") return by_stage(Stage::Bucket);
  if (failure.stage == "components") {
    const bool had_edges =
        std::any_of(trace_.raw.edges.begin(), trace_.raw.edges.end(),
                    [](const lar::VertexPair& edge) { return edge[0] != edge[1]; });
    return by_stage(had_edges ? Stage::Prune : Stage::Quantise);
  }
  if (failure.error == "Limit") {
    Explained result = missing(Stage::Nesting);
    set_cause(result.cause, "limit", "every cycle would be compared with every other one",
              "arrange exactly");
    return result;
  }
  if (failure.stage == "latticeArray") {
    Explained result = missing(Stage::Nesting);
    set_cause(result.cause, "simple-cycles-only",
              "the lattice of containment can walk components only that are simple cycles",
              "classify the outer boundaries of the components");
    return result;
  }
  if (trace_.components.empty()) return no_cycle();
  Explained result = missing(Stage::FaceWalk);
  explain_walk(result.cause);
  return result;
}

std::vector<Explained> ExplainedRun::failures() const {
  std::vector<Explained> result;
  const auto failed =
      std::find_if(trace_.failures.begin(), trace_.failures.end(), [&](const Failure& failure) {
        return failure.stage == "buckets" || failure.stage == "components" ||
               failure.stage == key(result_);
      });
  if (failed != trace_.failures.end()) {
    result.push_back(failure(*failed));
  } else if (!has_result(trace_, result_)) {
    result.push_back(no_cycle());
  }
  const auto add = [&](Disagreement disagreement, const char* message, const char* rule,
                       const char* explanation) {
    Explained walk = about_complex(disagreement, message, Stage::FaceWalk);
    set_cause(walk.cause, rule, explanation,
              "cut and merge until nothing changes, as the repaired pipeline does");
    result.push_back(std::move(walk));
  };
  if (walk_.aborted) {
    add(Disagreement::Missing, "the face walk stopped early: the rest of the faces is missing",
        "aborted-walk", "merging made edges cross, and the walk left its edge");
  }
  if (walk_.breaks_euler) {
    add(Disagreement::Invalid, "the faces that the walk found break Euler's relation", "euler",
        "merging made edges cross, so the cycles of the walk are no faces");
  }
  if (walk_.depends_on_order) {
    add(Disagreement::Invalid, "with other numbers of the vertices the walk finds other faces",
        "hash-order",
        "merging made edges cross, so the order of a hash table decides what faces are found");
  }
  return result;
}

}  // namespace plumbline::inters
