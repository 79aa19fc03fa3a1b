// Where the published pipeline has no result, or says itself that it is not all.

#include <fmt/format.h>

#include <algorithm>

#include "engines/inters/explain/run.hpp"

namespace plumbline::checking {
namespace {

using lar::published::Failure;

std::string text(const Failure& failure) {
  if (failure.error == "NoTermination")
    return fmt::format("{} runs for ever ({})", failure.function, failure.message);
  return fmt::format("{} fails with {}: {}", failure.function, failure.error, failure.message);
}

const char* key(PublishedResult result) {
  switch (result) {
    case PublishedResult::LarFromLines:
      return "larFromLines";
    case PublishedResult::AllComponents:
      return "allComponents";
    case PublishedResult::CellsFromCycles:
      return "latticeArray";
  }
  return "";
}

void set(Cause& cause, const char* rule, const char* explanation, const char* advice) {
  cause.rule = rule;
  cause.explanation = explanation;
  cause.advice = advice;
}

Finding about_complex(Disagreement disagreement, std::string message, Stage stage) {
  Finding finding;
  finding.kind = CellKind::Complex;
  finding.disagreement = disagreement;
  finding.message = std::move(message);
  finding.cause = Cause{};
  finding.cause->stage = stage;
  finding.cause->confirmed = true;  // the exact counterpart always has a result
  return finding;
}

Finding no_cycle() {
  Finding finding = about_complex(Disagreement::Missing,
                                  "the published pipeline has no result: there is no cycle",
                                  Stage::ComponentFilter);
  set(*finding.cause, "no-cycle", "where there is no cycle, nothing is returned",
      "return the vertices and edges, and the unbounded face");
  return finding;
}

}  // namespace

/// The failure as a finding; its rule is filled in for the stages that have only one.
Finding PublishedRun::failure(const Failure& failure) const {
  Finding finding =
      about_complex(Disagreement::Missing, "the published pipeline has no result: " + text(failure),
                    Stage::FaceWalk);
  Cause& cause = *finding.cause;
  if (failure.stage == "buckets") {
    cause.stage = Stage::Bucket;
    explain(finding, cause);
  } else if (failure.stage == "components") {
    const bool had_edges =
        std::any_of(trace_.raw.edges.begin(), trace_.raw.edges.end(),
                    [](const lar::VertexPair& edge) { return edge[0] != edge[1]; });
    cause.stage = had_edges ? Stage::Prune : Stage::Quantise;
    explain(finding, cause);
  } else if (failure.error == "Limit") {
    cause.stage = Stage::Nesting;
    set(cause, "limit", "every cycle would be compared with every other one", "arrange exactly");
  } else if (failure.stage == "latticeArray") {
    cause.stage = Stage::Nesting;
    set(cause, "simple-cycles-only",
        "the lattice of containment can walk components only that are simple cycles",
        "classify the outer boundaries of the components");
  } else if (trace_.components.empty()) {
    return no_cycle();
  } else {
    explain_walk(cause);
  }
  return finding;
}

std::vector<Finding> PublishedRun::failures() const {
  std::vector<Finding> result;
  const auto failed =
      std::find_if(trace_.failures.begin(), trace_.failures.end(), [&](const Failure& failure) {
        return failure.stage == "buckets" || failure.stage == "components" ||
               failure.stage == key(result_);
      });
  if (failed != trace_.failures.end())
    result.push_back(failure(*failed));
  else if (!has_result(trace_, result_))
    result.push_back(no_cycle());
  const auto add = [&](Disagreement disagreement, const char* message, const char* rule,
                       const char* explanation) {
    Finding finding = about_complex(disagreement, message, Stage::FaceWalk);
    set(*finding.cause, rule, explanation,
        "cut and merge until nothing changes, as the repaired pipeline does");
    result.push_back(std::move(finding));
  };
  if (walk_.aborted)
    add(Disagreement::Missing, "the face walk stopped early: the rest of the faces is missing",
        "aborted-walk", "merging made edges cross, and the walk left its edge");
  if (walk_.breaks_euler)
    add(Disagreement::Invalid, "the faces that the walk found break Euler's relation", "euler",
        "merging made edges cross, so the cycles of the walk are no faces");
  if (walk_.depends_on_order)
    add(Disagreement::Invalid, "with other numbers of the vertices the walk finds other faces",
        "hash-order",
        "merging made edges cross, so the order of a hash table decides what faces are found");
  return result;
}

}  // namespace plumbline::checking
