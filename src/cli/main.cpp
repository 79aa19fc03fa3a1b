#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <new>

#include "cli/commands.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

constexpr const char* kDescription =
    "Exact planar arrangements of drawings, and a verdict on the float LAR result.\n\n"
    "  plumbline info plan.svg\n"
    "  plumbline arrange plan.svg -o plan.json\n"
    "  plumbline check plan.svg --picture check.svg\n"
    "  plumbline lar plan.svg --show components -o components.svg\n"
    "  plumbline eval table.json -o table.svg\n"
    "  plumbline random 5000 -o random.lines\n";
constexpr const char* kExitCodes =
    "Exit codes: 0 done or agree, 1 exact and float result disagree, 2 bad input or usage, 3 "
    "internal.";
constexpr const char* kFile =
    "A drawing: .svg, .svgz, .dxf, .lines, .geojson, .json, .wkt, .wkb or .csv";

void add_input(CLI::App& command, InputArguments& arguments, const char* file = kFile) {
  command.add_option("FILE", arguments.file, file)->required()->type_name("");
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

constexpr const char* kLarExamples =
    "Examples: plumbline lar plan.svg --variant published --trace plan.json\n"
    "          plumbline lar plan.svg --show polylines -o polylines.svg\n"
    "          plumbline lar plan.svg --show boundary --faces 0,3 -o boundary.svg";

void add_threads(CLI::App& command, std::size_t& threads) {
  command
      .add_option("--threads", threads,
                  "Use at most N threads [default: one for each core]; never changes the result")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
}

void add_plot(CLI::App& command, std::optional<std::string>& plot) {
  command
      .add_option("--plot", plot,
                  "Plot the numbers of vertices, edges and faces over the radius to an SVG file")
      ->type_name("FILE");
}

void add_advice(CLI::App& command, CheckArguments& arguments) {
  CLI::Option* advice = command.add_flag_callback(
      "--advice", [&] { arguments.advice = true; },
      "Look for the radii that float LAR is right with: a dozen more runs [default: for up to "
      "20,000 edges]");
  command
      .add_flag_callback(
          "--no-advice", [&] { arguments.advice = false; }, "Do not, even for small drawings")
      ->excludes(advice);
  add_plot(command, arguments.plot);
}

template <class Arguments>
CLI::App* add_command(CLI::App& app, Arguments& arguments, const char* name,
                      const char* description, const char* examples, ExitCode& exit_code) {
  CLI::App* command = app.add_subcommand(name, description);
  command->footer(examples);
  add_input(*command, arguments);
  command
      ->add_option_function<std::string>(
          "--engine",
          [&](const std::string& engine) {
            arguments.engine = engine == "cgal" ? Engine::Cgal : Engine::Bucket;
          },
          "Arrange with bucket (the default) or cgal (the reference, slower)")
      ->check(CLI::IsMember({"cgal", "bucket"}))
      ->type_name("ENGINE");
  add_threads(*command, arguments.threads);
  command->add_flag("--verify", arguments.verify, "Arrange with both engines and compare");
  command->callback([&] { exit_code = run(arguments); });
  return command;
}

void add_info_command(CLI::App& app, InfoArguments& arguments, ExitCode& exit_code) {
  CLI::App* command = add_command(
      app, arguments, "info", "What a drawing holds: counts, extent, repetitions, feature size",
      "Examples: plumbline info plan.svg --ladder --plot ladder.svg\n"
      "          plumbline info plan.svg --diagnose --within 0.5 --picture defects.svg",
      exit_code);
  command->add_flag("--ladder", arguments.ladder,
                    "The tolerance ladder: at which radii merging within the radius would give "
                    "other numbers of vertices, edges or faces");
  add_plot(*command, arguments.plot);
  CLI::Option* diagnose = command->add_flag(
      "--diagnose", arguments.diagnose,
      "Name the defects of the line work: duplicates, overlaps, gaps, undershoots, overshoots, "
      "near-misses, dangles, bridges, slivers, short edges, nearly parallel edges");
  command
      ->add_option_function<std::string>(
          "--within",
          [&](const std::string& distance) {
            arguments.within = parse_decimal(distance);
            if (sgn(*arguments.within) >= 0) return;
            throw Error(ErrorCode::BadInput, "the search distance is negative", {}, distance);
          },
          "What is no further away than this is near, in drawing units [default: 0.001 x the "
          "drawing's longer side]")
      ->needs(diagnose)
      ->type_name("DISTANCE");
  command->add_option("-o,--output", arguments.output, "Write the diagnosis to a JSON file")
      ->needs(diagnose)
      ->type_name("FILE");
  command->add_option("--picture", arguments.picture, "Draw the defects to an SVG file")
      ->needs(diagnose)
      ->type_name("FILE");
}

void add_lar_command(CLI::App& app, LarArguments& arguments, ExitCode& exit_code) {
  const std::map<std::string, bool> variants{{"published", true}, {"repaired", false}};
  const std::map<std::string, LarShow> pictures{
      {"buckets", LarShow::Buckets},  {"components", LarShow::Components},
      {"faces", LarShow::Faces},      {"explode", LarShow::Explode},
      {"numbers", LarShow::Numbers},  {"pruning", LarShow::Pruning},
      {"filled", LarShow::Filled},    {"polylines", LarShow::Polylines},
      {"boundary", LarShow::Boundary}};
  CLI::App* command =
      app.add_subcommand("lar", "The float LAR pipeline, stage by stage, as published or repaired");
  command->footer(kLarExamples);
  add_input(*command, arguments);
  command->add_option("--variant", arguments.is_published, "repaired (the default) or published")
      ->transform(CLI::CheckedTransformer(variants).description(""))
      ->type_name("VARIANT");
  command
      ->add_option("--decimals", arguments.decimals,
                   "Decimals of the published variant's coordinates and parameters [default: 4]")
      ->type_name("N");
  command
      ->add_option("--radius", arguments.radius,
                   "Vertices no further apart than this are merged [default: published 0.001, "
                   "repaired 0.001 x the drawing's longer side]")
      ->type_name("R");
  command->add_flag("--unit-square", arguments.unit_square,
                    "Map the drawing to the unit square first, y upwards, as published for SVG");
  command->add_option("--trace", arguments.trace, "Write the output of every stage to a JSON file")
      ->type_name("FILE");
  command
      ->add_option("--show", arguments.picture.show,
                   "What -o draws: buckets, components, faces (the default), explode, numbers, "
                   "pruning, filled (triangulated faces), polylines (boundaries joined by bridge "
                   "edges), boundary (of the chain of --faces)")
      ->transform(CLI::CheckedTransformer(pictures, CLI::ignore_case).description(""))
      ->type_name("WHAT");
  command->add_option("--factor", arguments.picture.explode, "Of --show explode [default: 1.2]")
      ->type_name("F");
  command
      ->add_option("--faces", arguments.picture.faces,
                   "Of --show boundary: faces by the numbers that it shows [default: all]")
      ->delimiter(',')
      ->type_name("F,F,...");
  add_threads(*command, arguments.threads);
  command->add_option("-o,--output", arguments.output, "Write a picture to an SVG file")
      ->type_name("FILE");
  command->callback([&] { exit_code = run(arguments); });
}

void add_eval_command(CLI::App& app, EvalArguments& arguments, ExitCode& exit_code) {
  CLI::App* command =
      app.add_subcommand("eval", "Evaluate a hierarchical structure to one LAR model or a picture");
  command->footer(
      "Examples: plumbline eval table.json -o table.svg\n"
      "          plumbline eval plan.svg --structure -o plan.json\n"
      "          plumbline eval plan.svg -o plan.lines\n");
  add_input(*command, arguments, "A structure (.json), or any drawing");
  command
      ->add_option("--decimals", arguments.decimals,
                   "Identify vertices that are equal after rounding to N decimals [default: exact]")
      ->check(CLI::Range(0, Number::kMaxDigits))
      ->type_name("N");
  command->add_flag("--merge-cells", arguments.merge_cells, "Keep repeated cells once");
  command->add_flag("--boundary", arguments.boundary,
                    "The boundary of all cells: facets that an odd number of them hold");
  command
      ->add_option("--embed", arguments.embed, "Add N dimensions (-N: drop the last N coordinates)")
      ->type_name("N");
  command
      ->add_option("--category", arguments.category,
                   "Only what stands within structures of this category (layer, block, ...)")
      ->type_name("NAME");
  command->add_flag("--structure", arguments.as_structure,
                    "Write the hierarchy itself to the .json file, not the LAR model");
  command
      ->add_option(
          "-o,--output", arguments.output,
          "Write the LAR model to a .json file, its segments to a .lines file or a picture of "
          "them to an .svg file")
      ->type_name("FILE");
  command->callback([&] { exit_code = run(arguments); });
}

void add_random_command(CLI::App& app, RandomArguments& arguments, ExitCode& exit_code) {
  CLI::App* command = app.add_subcommand(
      "random", "Random segments, the same for the same seed: LAR's randomLines");
  command->footer(
      "Example: plumbline random 5000 --scaling 0.1 -o random.lines\n"
      "Each is the difference of two random points of the unit square, scaled, about a third.");
  command->add_option("N", arguments.count, "How many")
      ->required()
      ->check(CLI::Range(std::size_t{0}, kMostRandomSegments))
      ->type_name("");
  command->add_option("--scaling", arguments.scaling, "Of their lengths [default: 0.1]")
      ->type_name("S");
  command->add_option("--seed", arguments.seed, "Determines the segments [default: 1]")
      ->type_name("K");
  command
      ->add_option("-o,--output", arguments.output,
                   "Write them to a .lines file [default: to standard output]")
      ->type_name("FILE");
  command->callback([&] { exit_code = run(arguments); });
}

void add_variant_options(CLI::App& command, CheckArguments& arguments) {
  const std::map<std::string, bool> variants{{"published", true}, {"repaired", false}};
  const std::map<std::string, PublishedResult> results{
      {"larFromLines", PublishedResult::LarFromLines},
      {"allComponents", PublishedResult::AllComponents},
      {"cells", PublishedResult::CellsFromCycles}};
  command
      .add_option("--variant", arguments.is_published,
                  "Of float LAR: repaired (the default) or published, with all its divergences")
      ->transform(CLI::CheckedTransformer(variants).description(""))
      ->type_name("VARIANT")
      ->excludes("--against");
  command
      .add_option("--result", arguments.result,
                  "Of the published variant: larFromLines (the default), allComponents (the faces "
                  "of all components) or cells (of cycles, with holes)")
      ->transform(CLI::CheckedTransformer(results).description(""))
      ->type_name("RESULT");
  command
      .add_option("--decimals", arguments.decimals,
                  "Decimals of the published variant's coordinates and parameters [default: 4]")
      ->type_name("N");
  CLI::Option* unit_square =
      command.add_flag("--unit-square", arguments.unit_square,
                       "Map the drawing to the unit square first, y upwards, as published for SVG");
  command
      .add_flag("--svg2lines", arguments.with_svg2lines,
                "Also find what the published svg2lines would misread of an .svg file")
      ->excludes(unit_square);
}

void add_check_options(CLI::App& command, CheckArguments& arguments) {
  command
      .add_option(
          "--radius", arguments.radius,
          "Float LAR merges vertices no further apart than this, in drawing units "
          "[default: 0.001 x the drawing's longer side; at least 2^-46 x its largest coordinate; "
          "of the published variant 0.001]")
      ->type_name("R");
  command
      .add_option(
          "--against", arguments.against,
          "Check this result, made by another program, and not float LAR's: LAR (V, FV, EV) "
          "as JSON; polygons and lines as GeoJSON, WKT, WKB, CSV; what arrange -o and lar "
          "--trace write")
      ->type_name("FILE")
      ->excludes("--radius");
  command
      .add_option("--tolerance", arguments.tolerance,
                  "Vertices match within this distance, in drawing units [default: the radius; "
                  "with --against 1e-9 x the drawing's longer side, at least 2^-46 x its largest "
                  "coordinate]")
      ->type_name("T");
  command.add_option("--list", arguments.listed, "Print at most so many findings [default: 4]")
      ->type_name("N");
  command.add_option("-o,--output", arguments.output, "Write all findings to a JSON file")
      ->type_name("FILE");
  command
      .add_option("--picture", arguments.picture,
                  "Draw both results and the findings to an SVG file")
      ->type_name("FILE");
  command.add_option("--report", arguments.report, "Write an HTML page with all of it")
      ->type_name("FILE");
  command
      .add_option("--findings", arguments.findings,
                  "Write the findings as points to a GeoJSON file, for QGIS and OGR")
      ->type_name("FILE");
  add_advice(command, arguments);
  add_variant_options(command, arguments);
}

/// CLI11 would only say that a command is required.
void refuse_unknown_command(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  const std::string command = argv[1];
  for (const char* known : {"arrange", "check", "eval", "info", "lar", "random"})
    if (command == known) return;
  throw Error(ErrorCode::BadInput,
              "unknown command (the commands are arrange, check, eval, info, lar, random)", {},
              command);
}

ExitCode parse_and_run(int argc, char** argv) {
  ExitCode exit_code = kAgree;
  CLI::App app(kDescription, "plumbline");
  app.set_version_flag("--version", "plumbline " PLUMBLINE_VERSION);
  app.footer(kExitCodes);
  app.require_subcommand(1);

  ArrangeArguments arrange;
  CLI::App* command =
      add_command(app, arrange, "arrange", "Exact arrangement of a drawing: faces, holes, nesting",
                  "Examples: plumbline arrange plan.svg -o plan.json\n"
                  "          plumbline arrange plan.lines --certify plan.certificate",
                  exit_code);
  command->add_option("-o,--output", arrange.output, "Write the complex to a .json or .svg file")
      ->type_name("FILE");
  command
      ->add_option("--certify", arrange.certificate,
                   "Write the complex, and what plumbline-verify needs to check it, to a "
                   ".certificate file")
      ->type_name("FILE");

  CheckArguments check;
  command = add_command(
      app, check, "check", "Hold the float LAR result against the exact one",
      "Examples: plumbline check plan.svg --radius 0.01 -o report.json --picture check.svg\n"
      "          plumbline check plan.svg --against polygons.geojson",
      exit_code);
  add_check_options(*command, check);

  InfoArguments info;
  add_info_command(app, info, exit_code);

  LarArguments lar;
  add_lar_command(app, lar, exit_code);

  EvalArguments eval;
  add_eval_command(app, eval, exit_code);

  RandomArguments random;
  add_random_command(app, random, exit_code);

  try {
    refuse_unknown_command(argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kAgree : kBadInput;
  }
  return exit_code;
}

ExitCode guarded(int argc, char** argv) {
  try {
    const ExitCode code = parse_and_run(argc, argv);
    if (std::fflush(stdout) != 0)
      throw Error(ErrorCode::BadFile, "cannot write to standard output");
    return code;
  } catch (const Error& error) {
    fmt::print(stderr, "plumbline: {}\n", error.what());
    return error.code() == ErrorCode::Internal ? kInternal : kBadInput;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "plumbline: out of memory\n");
    return kBadInput;
  } catch (const std::exception& error) {
    fmt::print(stderr, "plumbline: internal error: {}\n", error.what());
    return kInternal;
  }
}

}  // namespace
}  // namespace plumbline::cli

int main(int argc, char** argv) { return plumbline::cli::guarded(argc, argv); }
