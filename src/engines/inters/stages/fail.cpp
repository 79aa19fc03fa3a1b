#include "engines/inters/stages/fail.hpp"

#include <cmath>
#include <string>

#include "plumbline/engines/inters_stages.hpp"
#include "plumbline/number.hpp"

namespace plumbline::inters {
namespace {

std::string description(const Failure& failure) {
  const std::string what =
      failure.error == kNoTermination ? "runs for ever" : "raises " + failure.error;
  return "the published " + failure.function + ' ' + what + ": " + failure.message;
}

}  // namespace

StageFailure::StageFailure(Failure failure)
    : Error(ErrorCode::BadInput, description(failure)), failure_(std::move(failure)) {}

void fail(const char* error, const char* message, const char* function) {
  throw StageFailure({"", error, message, function});
}

void check_radius(double radius) {
  if (std::isfinite(radius) && radius > 0) return;
  throw Error(ErrorCode::BadInput, "the radius must be finite and positive", {},
              shortest_text(radius));
}

}  // namespace plumbline::inters
