#pragma once

namespace plumbline::inters {

/// The error where the original ran for ever.
inline constexpr const char* kNoTermination = "NoTermination";

/// Throws StageFailure: what the original raised (or kNoTermination), with which message, in which
/// of its functions.
[[noreturn]] void fail(const char* error, const char* message, const char* function);

/// Throws: Error BadInput for a radius that is not positive and finite.
void check_radius(double radius);

}  // namespace plumbline::inters
