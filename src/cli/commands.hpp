#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumbline/arrange.hpp"
#include "plumbline/coverage.hpp"
#include "plumbline/engine.hpp"
#include "plumbline/engines/lar_show.hpp"
#include "plumbline/minimise.hpp"
#include "plumbline/output.hpp"
#include "plumbline/overlay.hpp"
#include "plumbline/pipeline.hpp"
#include "plumbline/read.hpp"
#include "plumbline/repair.hpp"
#include "plumbline/round.hpp"
#include "plumbline/validity.hpp"

namespace plumbline::cli {

/// Exit codes of every command.
enum ExitCode { kAgree = 0, kDisagree = 1, kBadInput = 2, kInternal = 3 };

/// That of a process that can't arrange a tile since a vertex lies on its left cut; one more: on
/// its right cut.
inline constexpr int kCutThroughVertex = 10;

/// When to give up.
struct Limits {
  std::optional<std::uint64_t> bytes;  ///< of memory
  std::string memory;                  ///< the same, as it was said
  std::optional<double> seconds;
};

/// How a command talks.
struct Manners {
  bool json = false;     ///< a summary as JSON in place of text
  bool quiet = false;    ///< neither
  bool verbose = false;  ///< also how long the parts take, on standard error
};

/// What every command has.
struct CommonArguments : Manners {
  Limits limits;
  std::vector<std::string> notes;  ///< to be told first, on standard error
};

/// What it reads, and how.
struct InputArguments : CommonArguments {
  std::string file;                ///< the one at hand
  std::vector<std::string> files;  ///< all of them, where a command takes several
  ReadOptions reading;
  bool lenient = false;  ///< go on where not all that looks like geometry could be read
};

/// How large it may become.
inline EvaluateOptions limits_of(const InputArguments& arguments) {
  return {kMaxEvaluatedWords, arguments.reading.max_segments};
}

/// How it is arranged.
struct DrawingArguments : InputArguments {
  ExactEngine exact_engine = ExactEngine::Bucket;
  std::size_t threads = 0;              ///< 0: as many as there are cores
  bool both_engines = false;            ///< arrange with both and compare
  std::vector<std::string> walls = {};  ///< layers that are arranged; none: all
  std::optional<LengthUnit> unit = {};  ///< instead of the file's
  bool unit_square = false;             ///< map the drawing to the unit square first
  bool joins_drift = false;             ///< join what printed doubles leave apart
};

struct ArrangeArguments : DrawingArguments {
  std::optional<std::string> output;
  std::optional<std::string> format;  ///< of the output
  std::optional<std::string> certificate;
  bool compact = false;            ///< JSON as short arrays
  bool safe = false;               ///< prove that what is written, rounded, is a valid complex
  std::vector<std::string> cells;  ///< of features; none: edges of DXF, else faces
  Grid grid;
  std::size_t tiles = 0;    ///< arranged one by one in files, where the output is a folder; 0: none
  std::size_t workers = 0;  ///< processes that arrange tiles; 0: as many as there are cores
};

struct CheckArguments : DrawingArguments {
  std::optional<std::string> against;
  bool some_faces = false;            ///< of `against`
  std::optional<std::size_t> listed;  ///< groups printed with their findings
  std::string engine = "lar";
  std::vector<std::string> settings;    ///< NAME=VALUE, its parameters
  std::optional<std::string> radius;    ///< of the engine, as text
  std::optional<std::string> decimals;  ///< the same
  std::optional<std::string> result;    ///< the same
  bool with_svg2lines = false;
  std::optional<double> tolerance;
  std::optional<std::string> output;
  std::optional<std::string> picture;
  std::optional<std::string> report;
  std::optional<std::string> findings;
  std::optional<bool> advice;  ///< by default for small drawings, and for a plot
  std::optional<std::string> plot;
};

struct MinimiseArguments : DrawingArguments {
  std::string engine = "lar";
  std::vector<std::string> settings;  ///< NAME=VALUE, its parameters
  std::optional<double> tolerance;
  std::optional<double> seconds;  ///< then it ends with what there is
  std::size_t max_runs = MinimiseOptions().max_runs;
  std::optional<std::string> output, picture, report;
};

struct InfoArguments : DrawingArguments {
  bool ladder = false;
  std::optional<std::string> plot;
  bool diagnose = false;
  std::optional<Rational> within;  ///< search distance of the diagnosis
  std::optional<Range> doors;      ///< how wide openings are
  std::size_t listed = 0;          ///< defects printed of each kind, after those that matter most
  std::optional<std::string> findings;
  std::optional<std::string> output;
  std::optional<std::string> picture;
};

struct RoomsArguments : DrawingArguments {
  RoomOptions rooms;
  std::optional<std::size_t> listed;  ///< rooms printed
  std::optional<std::string> output;
  std::optional<std::string> format;  ///< of the output
  std::optional<std::string> picture;
  std::optional<std::string> report;
};

struct OverlayArguments : InputArguments {
  std::string second;  ///< the other layer's file
  OverlayHow how = OverlayHow::Intersection;
  FillRule rule = FillRule::EvenOdd;
  std::size_t threads = 0;            ///< 0: as many as there are cores
  std::optional<std::size_t> listed;  ///< pieces printed
  std::optional<std::string> output;
  std::optional<std::string> format;  ///< of the output
  std::optional<std::string> picture;
};

struct SelectArguments : DrawingArguments {
  std::string expression;
  FillRule rule = FillRule::EvenOdd;
  std::optional<std::size_t> listed;  ///< polygons printed
  std::optional<std::string> output;
  std::optional<std::string> format;  ///< of the output
  std::optional<std::string> picture;
};

struct CoverageArguments : DrawingArguments {
  bool check = false, clean = false;  ///< the first where neither is said
  CoveragePolicy policy = CoveragePolicy::LongestBorder;
  std::optional<Rational> width, area;  ///< limits of gaps and overlaps
  bool all_overlaps = false;            ///< these without limits
  std::optional<std::size_t> listed;    ///< faults printed, of each kind
  std::optional<std::string> output;
  std::optional<std::string> format;  ///< of the output
};

struct ValidityArguments : DrawingArguments {
  std::optional<ValidMeaning> meaning;  ///< by which polygons are made valid
  std::optional<std::size_t> listed;    ///< polygons printed
  std::optional<std::string> output;
  std::optional<std::string> format;  ///< of the output
};

struct RepairArguments : InputArguments {
  RepairOptions repair;
  bool dry_run = false;
  bool compare = false;               ///< with rules in use
  std::optional<std::size_t> listed;  ///< edits printed
  std::optional<std::string> output;  ///< none: a dry run
  std::optional<std::string> format;  ///< of the output
  std::optional<std::string> log;
  std::optional<std::string> findings;
  std::optional<std::string> picture, report;
  std::optional<std::string> undo;  ///< the log of what is undone
};

struct LarArguments : InputArguments {
  bool is_published = false;
  bool unit_square = false;
  std::optional<int> decimals;
  std::optional<std::string> radius;  ///< as text: a number or a preset
  std::size_t threads = 0;            ///< 0: as many as there are cores
  LarPicture picture;
  std::optional<std::string> trace;
  std::optional<std::string> output;
};

struct EvalArguments : InputArguments {
  std::optional<std::string> category;
  std::optional<int> decimals;
  int embed = 0;
  bool merge_cells = false;
  bool boundary = false;
  bool as_structure = false;
  std::optional<std::string> output;
  std::optional<std::string> format;  ///< of the output
};

/// Whether the text of a radius is the name of a preset and no number.
inline bool is_preset(std::string_view radius) {
  return std::ranges::find(kRadiusPresets, radius) != kRadiusPresets.end();
}

inline constexpr std::size_t kMostTiles = 100'000, kMostWorkers = 1024;
inline constexpr std::size_t kMostRandomSegments = 10'000'000;

/// What a process does that arranges a tile for another one.
struct TileArguments : CommonArguments {
  std::string folder;
  std::uint64_t tile = 0;
};

struct EnginesArguments : CommonArguments {};

struct RandomArguments : CommonArguments {
  std::size_t count = 0;
  double scaling = 0.1;
  std::uint64_t seed = 1;
  std::optional<std::string> output;
};

/// The engines that can be checked by their names.
struct KnownEngines {
  std::vector<Engine> built_in;
  std::vector<std::filesystem::path> folders = {};  ///< in which programs are looked for
};

class Report;

/// Each command tells its report what it has to say and returns its exit code. Throws: Error.
ExitCode run(const ArrangeArguments& arguments, Report& report);
ExitCode run(const CheckArguments& arguments, Report& report, const KnownEngines& known);
ExitCode run(const EnginesArguments& arguments, Report& report, const KnownEngines& known);
ExitCode run(const MinimiseArguments& arguments, Report& report, const KnownEngines& known);
ExitCode run(const InfoArguments& arguments, Report& report);
ExitCode run(const RoomsArguments& arguments, Report& report);
ExitCode run(const OverlayArguments& arguments, Report& report);
ExitCode run(const SelectArguments& arguments, Report& report);
ExitCode run(const CoverageArguments& arguments, Report& report);
ExitCode run(const ValidityArguments& arguments, Report& report);
ExitCode run(const RepairArguments& arguments, Report& report);
ExitCode run(const LarArguments& arguments, Report& report);
ExitCode run(const EvalArguments& arguments, Report& report);
ExitCode run(const TileArguments& arguments, Report& report);
/// `arrange` in tiles.
ExitCode run_in_tiles(const ArrangeArguments& arguments, Report& report);
ExitCode run(const RandomArguments& arguments, Report& report);

}  // namespace plumbline::cli
