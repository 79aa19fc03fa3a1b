#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "plumbline/geometry.hpp"

/// The inputs that speed is measured on, the same on every machine. Coordinates are exact decimals.
namespace plumbline::inputs {

/// n segments of one length, centres and directions random in the unit square; some n crossings.
SegmentSet random_segments(std::uint64_t n);
/// LAR's `randomLines`: ends are differences of random points about random centres; 4.2 n crossings
/// for n = 5000, 8 n else.
SegmentSet random_lines(std::uint64_t n);
/// m vertical and m horizontal lines, m^2 crossings.
SegmentSet grid(std::uint64_t m);
/// The same turned by 0.7 rad, ends rounded to three decimals.
SegmentSet turned_grid(std::uint64_t m);
/// n segments between points of a lattice, in eight directions: touching, overlapping, repeated.
SegmentSet lattice_segments(std::uint64_t n);
/// n / 100 stars of 100 lines through one point, a lattice point or one of thirds. Requires: n a
/// multiple of 100.
SegmentSet stars(std::uint64_t n);
/// n lines through (1/3, 2/3).
SegmentSet pencil(std::uint64_t n);
/// random_segments in doubles: decimals of 17 digits, no grid of 60 bits.
SegmentSet double_segments(std::uint64_t n);
/// m x m rooms, four walls each, turned by 0.3 rad in doubles of 17 digits: walls are drawn twice,
/// those of a row are collinear but for rounding.
SegmentSet turned_rooms(std::uint64_t m);
/// n / 800 plans of 20 x 20 rooms, each wall once, each turned by a rational rotation of its own:
/// numerators and denominators of 50 bits, of 100 for differences. Requires: n a multiple of 800.
SegmentSet rational_copies(std::uint64_t n);
/// n pieces of length 0.5 in a square of 10,000, 6 decimals: nearly all disjoint.
SegmentSet tiny_pieces(std::uint64_t n);
/// m x m rooms behind walls of two lines, which the rooms on both sides draw, and a door in each;
/// 3 decimals; 11 segments a room.
SegmentSet double_walls(std::uint64_t m);
/// n / 50 polylines of 50 edges, 7 decimals. Requires: n a multiple of 50.
SegmentSet streets(std::uint64_t n);
/// `count` copies of a drawing, the i-th moved by i (dx, dy).
SegmentSet tiles(const SegmentSet& drawing, std::uint64_t count, int dx, int dy);

/// The drawings of the hospital (cvdlab/lar-cc, test/svg/hospital2, commit 7092965), overlaid.
inline constexpr const char* kHospitalFiles[] = {
    "Administration",  "Delivery",      "Emergency", "InputOutput", "Laboratories", "OutPatient",
    "PatientServices", "StaffServices", "Surgery",   "floor2Ward",  "floor3Ward"};
/// All segments of those files. Throws: Error BadFile if one is missing.
SegmentSet hospital(const std::filesystem::path& directory);

/// A workload by its name and size: R1_1e5 (random_segments), R5_5e3 (random_lines), G_300 (grid),
/// Gr_300 (turned_grid), D_1e4 (lattice_segments), S_1e4 (stars), S1_1e3 (pencil), F_1e5
/// (double_segments), T_100 (turned_rooms), Q_4e4 (rational_copies), I_1e5 (tiny_pieces), L_1e5
/// (streets), W_100 (double_walls), P_10 (tiles of the hospital in `directory`). Throws: Error
/// BadInput for another name.
SegmentSet workload(const std::string& name, const std::filesystem::path& directory = {});

/// What is known of a workload from elsewhere: counts of CGAL's arrangement and of a prototype that
/// shares no code with either engine, and the number of pairs that cross in their interiors.
struct Known {
  const char* name;
  std::uint64_t segments, vertices, edges, faces, crossings;
};
const std::vector<Known>& known();
/// Nothing (a null pointer) for a name that is not listed.
const Known* known(const std::string& name);

}  // namespace plumbline::inputs
