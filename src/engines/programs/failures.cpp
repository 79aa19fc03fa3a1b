#include "engines/programs/failures.hpp"

namespace plumbline::programs {
namespace {

void set(Cause& cause, const char* rule, const char* explanation, const char* advice) {
  cause.rule = rule;
  cause.explanation = explanation;
  cause.advice = advice;
}

}  // namespace

Explained explained(const Failure& failure, const std::string& engine) {
  Explained result;
  result.finding.kind = CellKind::Complex;
  result.finding.disagreement = Disagreement::Missing;
  result.finding.message = engine + ' ' + failure.message;
  Cause& cause = result.cause;
  cause.stage = engine;
  cause.confirmed = true;  // the exact engine has a result
  switch (failure.kind) {
    case Failure::Kind::Error:
    case Failure::Kind::BadTolerance:
      set(cause, "engine-error", "the engine itself says that it failed",
          "run another of its configurations, or another radius");
      break;
    case Failure::Kind::Crash:
      set(cause, "engine-crash", "its program ended before it answered",
          "run it in a process of its own, and be ready for its end");
      break;
    case Failure::Kind::Timeout:
      set(cause, "engine-timeout", "it was ended: it may run for ever",
          "allow it more time by the parameter seconds");
      break;
    case Failure::Kind::Memory:
      set(cause, "engine-memory", "it was refused more memory, or ended for it",
          "allow it more by the parameter memory");
  }
  return result;
}

}  // namespace plumbline::programs
