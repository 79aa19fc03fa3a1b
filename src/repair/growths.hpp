#pragma once

#include <optional>
#include <vector>

#include "repair/tips.hpp"

namespace plumbline::repair_steps {

/// Where a loose end runs to, or two that face each other on one line.
struct Growth {
  Tip tip;
  std::optional<Tip> other;  ///< further to the right
  Point end;
  Rational squared_length;  ///< of the way of one, of the gap between two
};

/// What `grow` would do. Bridges first, each by place.
std::vector<Growth> growths(const Work& work, const Arranged& arranged, const Rational& reach);

}  // namespace plumbline::repair_steps
