#pragma once

#include <span>

#include "repair/work.hpp"

namespace plumbline::repair_steps {

/// Takes edges away from the lines that cover them, as one edit: of each line what is left stays.
void cut(Work& work, const Arranged& arranged, std::span<const EdgeId> edges, EditKind kind,
         const Point& where, const Rational& squared_size);

/// Whether a line that covers one of the edges is anchored or virtual.
bool is_fixed(const Work& work, const Arranged& arranged, std::span<const EdgeId> edges);

}  // namespace plumbline::repair_steps
