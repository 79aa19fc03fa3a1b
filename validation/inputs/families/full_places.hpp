#pragma once

namespace plumbline::inputs {

class Draw;

// Families of many segments in one place, too many for a bucket to test pair by pair.

/// Lines through several points that are far apart or next to each other, some through two of
/// them, some ending there.
void pencils(Draw& draw);
/// Lines through nearly one point: off by single units.
void near_pencils(Draw& draw);
/// Segments with a common end, some of them collinear, and what crosses or touches them.
void fan(Draw& draw);
/// Parallel segments of any direction, and what crosses or touches them.
void hatch(Draw& draw);
/// Lines through one point, among parallel ones.
void pencil_in_bundle(Draw& draw);
/// Segments between the points of a lattice of thirds: a pencil in each.
void stars_on_lattice(Draw& draw);

}  // namespace plumbline::inputs
