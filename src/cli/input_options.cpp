// The options that several commands have.

#include "cli/options.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

constexpr const char* kFile =
    "A drawing: .svg, .svgz, .dxf, .lines, .geojson, .json, .wkt, .wkb or .csv";

}  // namespace

void add_input(CLI::App& command, InputArguments& arguments, const char* file) {
  command.add_option("FILE", arguments.file, file == nullptr ? kFile : file)
      ->required()
      ->type_name("");
  command
      .add_option_function<std::string>(
          "--flatten",
          [&](const std::string& tolerance) {
            arguments.reading.chord_tolerance = parse_decimal(tolerance);
            if (sgn(arguments.reading.chord_tolerance) > 0) return;
            throw Error(ErrorCode::BadInput, "the tolerance of curves is not positive", {},
                        tolerance);
          },
          "Curves become chords no further than this from the curve, in the units of the curve's "
          "own coordinates [default: 0.001 x the curve's longer side]")
      ->type_name("TOLERANCE");
  command
      .add_option("--angle", arguments.reading.angle_bound,
                  "Rotations become rational ones, their angles within this [default: 1e-15]")
      ->check(CLI::PositiveNumber)
      ->type_name("RADIANS");
  command.add_flag("--visible", arguments.reading.visible_only,
                   "Leave out, and list, what the drawing hides; else it is drawn");
}

void add_threads(CLI::App& command, std::size_t& threads) {
  command
      .add_option("--threads", threads,
                  "Use at most N threads [default: one for each core]; never changes the result")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
}

void add_drawing(CLI::App& command, DrawingArguments& arguments) {
  add_input(command, arguments);
  command
      .add_option_function<std::string>(
          "--engine",
          [&](const std::string& engine) {
            arguments.engine = engine == "cgal" ? Engine::Cgal : Engine::Bucket;
          },
          "Arrange with bucket (the default) or cgal (the reference, slower)")
      ->check(CLI::IsMember({"cgal", "bucket"}))
      ->type_name("ENGINE");
  add_threads(command, arguments.threads);
  command.add_flag("--verify", arguments.verify, "Arrange with both engines and compare");
}

}  // namespace plumbline::cli
