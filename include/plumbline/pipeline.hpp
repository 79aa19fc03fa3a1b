#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumbline/arrange.hpp"
#include "plumbline/check.hpp"
#include "plumbline/edits.hpp"
#include "plumbline/features.hpp"
#include "plumbline/read.hpp"
#include "plumbline/round.hpp"

/// From a file to the answers, in one call each: what the tool does apart from arguments, limits
/// and the terminal.
namespace plumbline {

/// Told now and then what is being done ("arranging 12 segments") and which part of it is done,
/// from 0 to 1; negative where that is not known. The work ends with Error Cancelled where it
/// returns false.
using Watch = std::function<bool(const std::string& what, double part)>;

/// How a file becomes an exact answer.
struct DrawingOptions {
  ReadOptions reading;
  bool unit_square = false;  ///< maps the drawing to the unit square first, as LAR does for SVG
  /// Layers whose lines are arranged, as `on_layers` takes them; all where there are none. Labels
  /// of the others are kept.
  std::vector<std::string> walls;
  ExactEngine exact_engine = ExactEngine::Bucket;
  bool both_engines = false;  ///< arranges with the other engine, too, and compares
  /// Whether the arrangement is `without_drift`: a gap of 1e-13 between printed doubles makes one
  /// room of two.
  bool joins_drift = false;
  std::size_t threads = 0;  ///< 0: as many as there are cores; does not change the result
  Watch watch;
};

/// A drawing with its exact arrangement, which has passed `validate` and `validate_coverage`.
struct Drawing {
  std::filesystem::path file;
  bool unit_square = false;  ///< whether `input` was mapped to the unit square
  Structure structure;
  SegmentSet input;
  ExactComplex complex;
  Drift joined;  ///< with `joins_drift`: what was apart
};

/// Reads, evaluates, arranges and validates. **Exact**. Throws: as `read`, `evaluate`, `arrange`;
/// Internal, with the first violation, where the exact arrangement fails a check or the engines
/// differ.
Drawing exact_answer(const std::filesystem::path& file, const DrawingOptions& options = {});

/// The text of a drawing's file with what is different in another drawing made of it
/// (`patched_dxf`, `patched_svg`), or why that cannot be done.
struct PatchedFile {
  std::string text;
  std::vector<Source> replaced;  ///< elements that gave way to lines
  std::string why_not;           ///< "" where it is done
};
/// Of `input`, as it was read from the file with these options. The text is read again: it has the
/// segments of `output`, as nearest doubles. Curves that would meet other lines now, and so have
/// other chords, become lines, too. `format` is wanted. Throws: Error BadFile.
PatchedFile patched_file(const std::filesystem::path& file, std::string_view format,
                         const ReadOptions& options, const SegmentSet& input,
                         const SegmentSet& output);

/// The same for a GeoJSON file whose polygons changed (`patched_geojson`). Throws: Error BadFile.
PatchedFile patched_file(const std::filesystem::path& file, const ReadOptions& options,
                         const std::vector<DrawnPolygon>& polygons);

/// What the log of a repair, as `to_json` writes it, says was changed, and of which drawing: for
/// `undo`.
struct RepairLog {
  std::vector<NetChange> changes;
  std::string input_signature, output_signature;  ///< `rounded_signature`
};
/// Throws: Error BadFile; BadInput, with its place, for what is no such log.
RepairLog read_repair_log(const std::filesystem::path& file);
/// The drawing that was repaired, of the repaired one. Throws: Error BadInput where that is not the
/// one of the log, or the log does not lead back to the other one; as `undo`.
SegmentSet undo(const SegmentSet& output, const RepairLog& log);

/// What a rule makes of a drawing.
struct RuleOutcome {
  std::string rule;
  std::size_t vertices = 0, edges = 0, faces = 0;  ///< faces without the unbounded one
  double area = 0;                                 ///< of the faces, **rounded**
  std::size_t skewed = 0;  ///< edges that are nearly, but not, parallel to an axis
  std::size_t moved = 0;   ///< vertices where the drawing as it was has none
  double furthest = 0;     ///< of those from the nearest vertex that was there, **rounded**
};
/// The drawing as it is, its repair, and what rules in use make of it at one tolerance: LAR's
/// pruning, gaps closed at the mean of their ends, every segment extended at both ends (each in
/// doubles, short versions but for LAR's). Throws: as `lar::arrange`.
std::vector<RuleOutcome> compare_rules(const SegmentSet& input, const Repair& repair,
                                       double tolerance);

/// All engines that there are, by name: lar, inters, plasm, files.
std::vector<Engine> engines();
/// The one of that name; else the program of that name in the folders (`programs::found_in`); what
/// has a slash is the path of a program. Throws: Error BadInput, with the names that there are, for
/// another; as `programs::engine`.
Engine engine_named(const std::string& name, const std::vector<Engine>& engines,
                    std::span<const std::filesystem::path> folders = {});
/// The engine as it runs on this drawing: inters maps to the unit square in floats, as published.
Engine engine_for(Engine engine, const Drawing& drawing, const Parameters& parameters);
/// inters, which then also finds what its reader of SVG, svg2lines, would misread of the file.
/// Throws: Error BadInput for a file that is no .svg, or is mapped to the unit square.
Engine inters_with_svg2lines(const Drawing& drawing);

/// Radii by where they come from.
inline constexpr std::array<std::string_view, 3> kRadiusPresets{"larlib", "plasm", "drawing"};
/// The radius of a preset: "larlib", 0.001 of the unit square, so times the longer side of the
/// drawing's box, as larlib maps it; "plasm", 1e-8 in drawing units, as Plasm.jl and
/// LinearAlgebraicRepresentation.jl have it; none for "drawing", the engine's own default.
/// Requires: one of kRadiusPresets.
std::optional<double> preset_radius(std::string_view preset, const SegmentSet& input);

/// How to give advice unasked.
struct AdvicePolicy {
  /// Whether to look for right radii; by default for up to kMostEdgesForAdvice edges.
  std::optional<bool> right_radii;
  bool ladder = false;  ///< whether the tolerance ladder is needed in any case
};
/// Advice runs an engine a dozen times: unasked only where that takes a few seconds.
inline constexpr std::size_t kMostEdgesForAdvice = 50'000;

/// The drawing held against the answer: `check`, which can tell parsing from transforming here.
/// `begins` is told which part of the work begins.
Check checked(Drawing drawing, Answer answer, std::optional<double> tolerance = {},
              std::size_t threads = 0, std::function<void(const std::string&)> begins = {});
/// `advised`, as far as the policy goes; else the check as it is.
Check with_advice(Check check, const AdvicePolicy& policy, const AdviceOptions& options = {});

/// What stands within Structs of this category. Throws: Error BadInput, with those that there are,
/// where there is none.
Structure only(const Structure& structure, const std::string& category);
/// The boundary of the chain of all cells: in the plane by the sides of its polygons, elsewhere by
/// the facets that its cells hold. Throws: Error BadInput for cells without facets, (V, CV).
LarModel boundary_of_all(const LarModel& model);
/// A structure of one model.
Structure structure_of(LarModel model, bool y_up);
/// The structure as lines of the plane; one of space in an oblique view, (x + y/2, z + y/4).
SegmentSet drawn(const Structure& structure);

/// n random segments (LAR's `randomLines`, appendix of Paoluzzi, "Accelerated
/// intersection of geometric objects", November 2015): the differences of random points of the unit
/// square, scaled, about random points; moved to where the least coordinates are 0. A seed
/// determines them, on every machine. Throws: Error BadInput for a scaling that is not finite, or
/// with which the coordinates are not.
std::vector<SegmentD> random_lines(std::size_t n, double scaling, std::uint64_t seed);

}  // namespace plumbline
