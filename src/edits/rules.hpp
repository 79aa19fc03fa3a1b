#pragma once

#include <string>

#include "edits/lines.hpp"

// What is wrong with an edit, in words; nothing if it does what its kind says.
namespace plumbline::edits {

/// Merge, Dissolve.
std::string wrong_union(const Edit& edit);
/// Grow, Bridge, Joint, Door.
std::string wrong_addition(const Edit& edit, const Tolerances& tolerances);
/// Trim, and Sliver as far as it can be told from the edit alone.
std::string wrong_removal(const Edit& edit, const Tolerances& tolerances);
/// Weld, Snap, Simplify. `origins`: of the segments that the lines stand for, as authored.
std::string wrong_movement(const Edit& edit, const Tolerances& tolerances,
                           std::span<const Segment> origins);

/// "goes 0.3, more than 0.2", where it does.
std::string beyond(const Rational& squared, const Rational& limit);
/// What an addition drew: of Grow and Bridge what the lines before do not cover.
std::vector<Segment> added(const Edit& edit);

}  // namespace plumbline::edits
