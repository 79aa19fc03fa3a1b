#pragma once

#include <optional>

#include "plumbline/arrange.hpp"
#include "plumbline/check.hpp"
#include "plumbline/engines/lar.hpp"

namespace plumbline {

/// The drawing held against float LAR's answer; its own radius by default.
inline Check check_lar(const SegmentSet& input, std::optional<double> radius = {},
                       const CheckOptions& options = {}) {
  Parameters parameters;
  if (radius) parameters["radius"] = *radius;
  Answer answer = answer_of(lar::engine(), input, parameters, options.threads);
  return check(input, arrange(input), std::move(answer), options);
}

}  // namespace plumbline
