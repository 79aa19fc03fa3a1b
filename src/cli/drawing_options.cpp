// The commands that arrange a drawing: arrange, info, check.

#include <map>

#include "cli/options.hpp"
#include "cli/suggestions.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

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
      "50,000 edges]");
  command
      .add_flag_callback(
          "--no-advice", [&] { arguments.advice = false; }, "Do not, even for small drawings")
      ->excludes(advice);
}

/// Whose answer is checked, and how it is run.
void add_engine_options(CLI::App& command, CheckArguments& arguments) {
  command.option_defaults()->group("The engine that is checked");
  CLI::Option* engine =
      command
          .add_option_function<std::string>(
              "--engine",
              [&](const std::string& name) {
                if (name != "bucket" && name != "cgal") {
                  arguments.engine = name;
                  return;
                }
                arguments.exact_engine = exact_engine(name);
                arguments.notes.push_back("--engine " + name + " is --exact-engine " + name +
                                          " now; --engine chooses the engine that is checked");
              },
              "Check the answer of this engine: lar (float LAR, the default), inters (LAR's module "
              "as published, with all its divergences), plasm (Plasm.jl's ARRANGE2D), files; or of "
              "a "
              "program: its NAME, as plumbline engines tells, or a path with a slash")
          ->type_name("NAME:lar|inters|plasm|files")
          ->excludes("--against");
  command
      .add_option(
          "--set", arguments.settings,
          "A parameter of the engine: of lar radius; of inters radius, decimals, result; of "
          "plasm radius; of files file; of programs configuration, radius, seconds, memory")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
  command
      .add_option_function<std::string>(
          "--variant",
          [&](const std::string& variant) {
            arguments.engine = variant == "published" ? "inters" : "lar";
          },
          "Short for --engine: repaired is lar, published is inters")
      ->transform(one_of({"repaired", "published"}))
      ->type_name("VARIANT")
      ->excludes("--against")
      ->excludes(engine);
  command
      .add_option("--result", arguments.result,
                  "Of inters: larFromLines (the default), allComponents (the faces of all "
                  "components) or cells (of cycles, with holes)")
      ->type_name("RESULT:larFromLines|allComponents|cells");
  command
      .add_option("--decimals", arguments.decimals,
                  "Of inters: decimals of coordinates and parameters [default: 4]")
      ->type_name("N");
  CLI::Option* unit_square =
      command.add_flag("--unit-square", arguments.unit_square,
                       "Map the drawing to the unit square first, y upwards, as published for SVG");
  command
      .add_flag("--svg2lines", arguments.with_svg2lines,
                "Of inters: also find what its svg2lines would misread of an .svg file")
      ->excludes(unit_square);
}

void add_comparison(CLI::App& command, CheckArguments& arguments) {
  command.option_defaults()->group("Comparison");
  command
      .add_option(
          "--radius", arguments.radius,
          "The engine merges vertices no further apart than this: a number in drawing units; "
          "larlib, its 0.001 on the unit square, so x the drawing's longer side; plasm, 1e-8 as "
          "Plasm.jl has it; drawing, the default [default: 0.001 x the drawing's longer side, "
          "at most a quarter of its shortest segment; at least 2^-46 x its largest coordinate; of "
          "inters 0.001, of plasm 1e-8]")
      ->check(radius())
      ->type_name("R");
  CLI::Option* against =
      command
          .add_option_function<std::string>(
              "--against", [&](const std::string& name) { arguments.against = file_of(name); },
              "Check this result, made by another program, and not float LAR's: LAR (V, FV, EV) "
              "as JSON; polygons and lines as GeoJSON, WKT, WKB, CSV; what arrange -o and lar "
              "--trace write")
          ->type_name("FILE")
          ->excludes("--radius");
  command
      .add_flag("--some-faces", arguments.some_faces,
                "Of --against: the result has some of the faces, as LAR's chains; each must be one "
                "of the drawing's, and nothing else is compared")
      ->needs(against);
  command
      .add_option("--tolerance", arguments.tolerance,
                  "Vertices match within this distance, in drawing units [default: the radius; "
                  "with --against 1e-9 x the drawing's longer side, at least 2^-46 x its largest "
                  "coordinate]")
      ->check(finite())
      ->type_name("T");
}

void add_check_outputs(CLI::App& command, CheckArguments& arguments) {
  command.option_defaults()->group("Output");
  command
      .add_option("-o,--output", arguments.output,
                  "Write all findings to a JSON file; - is standard output, here and below")
      ->type_name("FILE");
  command
      .add_option("--picture", arguments.picture,
                  "Draw both results, the findings and the numbers of their groups to an SVG file")
      ->type_name("FILE");
  command.add_option("--report", arguments.report, "Write an HTML page with all of it")
      ->type_name("FILE");
  command
      .add_option(
          "--findings", arguments.findings,
          "Write the findings as points: .geojson, .csv, .dxf (a layer for each kind) and the like")
      ->type_name("FILE");
  add_plot(command, arguments.plot);
  command
      .add_option("--list", arguments.listed,
                  "Print so many groups of findings, with the findings of each "
                  "[default: as many groups as fit on a screen]")
      ->check(integer(0))
      ->type_name("N");
}

void add_complex_outputs(CLI::App& command, ArrangeArguments& arguments) {
  command.option_defaults()->group("Output");
  CLI::Option* output =
      add_output(command, arguments.output, arguments.format,
                 "Write the complex to a .json, .svg or .lar.json file (V, FV, EV); its "
                 "edges to a .lines file; what --cells says to " +
                     listed_endings(feature_formats()) +
                     ", and all of it to .obj, proven to be valid in doubles",
                 complex_formats());
  CLI::Option* compact =
      command
          .add_flag("--compact", arguments.compact,
                    "A .json file of a third of the bytes: arrays, without what follows from them")
          ->needs(output);
  command
      .add_flag("--safe", arguments.safe,
                "Write nearest doubles only if they are proven to form the "
                "same complex, else the snap rounded complex, proven too")
      ->needs(output)
      ->excludes(compact);
  command
      .add_option("--decimals", arguments.grid.decimals,
                  "Of --safe and of files of features: N decimals, not doubles")
      ->check(integer(0, Grid::kMaxDecimals))
      ->needs(output)
      ->excludes(compact)
      ->type_name("N");
  command
      .add_option("--cells", arguments.cells,
                  "What files of features hold: faces, edges, vertices, or several, with commas "
                  "[default: edges of .dxf, else faces]; of several, each feature of a .geojson "
                  "file says which it is")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->transform(one_of({"faces", "edges", "vertices"}))
      ->needs(output)
      ->type_name("CELLS");
  command
      .add_option("--certify", arguments.certificate,
                  "Write the complex, and what plumbline-verify needs to check it, to a "
                  ".certificate file")
      ->type_name("FILE");
}

void add_diagnosis(CLI::App& command, InfoArguments& arguments) {
  command.option_defaults()->group("Diagnosis");
  CLI::Option* diagnose = command.add_flag(
      "--diagnose", arguments.diagnose,
      "Name the defects of the line work: duplicates, overlaps, gaps, undershoots, overshoots, "
      "near-misses, dangles, bridges, slivers, short edges, nearly parallel edges, invalid rings; "
      "and what is as wide as a door");
  command
      .add_option_function<std::string>(
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
  command
      .add_option_function<std::string>(
          "--doors", [&](const std::string& range) { arguments.doors = door_range(range); },
          "What is as wide as a door, in drawing units [default: 0.01 to 0.1 x the drawing's "
          "longer "
          "side]")
      ->needs(diagnose)
      ->type_name("LEAST..MOST");
  command
      .add_option("--list", arguments.listed,
                  "Print also at most so many defects of each kind [default: 0]")
      ->check(integer(0))
      ->needs(diagnose)
      ->type_name("N");
  command
      .add_option(
          "--findings", arguments.findings,
          "Write the defects as points: .geojson, .csv, .dxf (a layer for each kind) and the like")
      ->needs(diagnose)
      ->type_name("FILE");
  command
      .add_option("-o,--output", arguments.output,
                  "Write the diagnosis to a JSON file; - is standard output, here and below")
      ->needs(diagnose)
      ->type_name("FILE");
  command.add_option("--picture", arguments.picture, "Draw the defects to an SVG file")
      ->needs(diagnose)
      ->type_name("FILE");
}

}  // namespace

CLI::App* add_command(CLI::App& app, ArrangeArguments& arguments) {
  CLI::App* command =
      app.add_subcommand("arrange", "Exact arrangement of a drawing: faces, holes, nesting");
  command->footer(
      "Examples: plumbline arrange plan.svg -o plan.json\n"
      "          plumbline arrange plan.svg --safe --decimals 3 -o plan.json\n"
      "          plumbline arrange plan.dxf -o rooms.geojson\n"
      "          plumbline arrange plan.lines --certify plan.certificate\n"
      "          plumbline arrange big.lines --tiles 16 --max-memory 2G -o big.tiles");
  add_files(*command, arguments);
  add_complex_outputs(*command, arguments);
  add_tiles(*command, arguments);
  add_drawing(*command, arguments);
  add_old_engine(*command, arguments);
  return command;
}

CLI::App* add_command(CLI::App& app, InfoArguments& arguments) {
  CLI::App* command =
      app.add_subcommand("info", "What a drawing holds: counts, extent, repetitions, feature size");
  command->footer(
      "Examples: plumbline info plan.svg --ladder --plot ladder.svg\n"
      "          plumbline info plan.svg --diagnose --within 0.5 --picture defects.svg");
  add_files(*command, arguments);
  command->option_defaults()->group("The tolerance ladder");
  command->add_flag("--ladder", arguments.ladder,
                    "The tolerance ladder: at which radii merging within the radius would give "
                    "other numbers of vertices, edges or faces");
  add_plot(*command, arguments.plot);
  add_diagnosis(*command, arguments);
  add_drawing(*command, arguments);
  add_old_engine(*command, arguments);
  return command;
}

CLI::App* add_command(CLI::App& app, CheckArguments& arguments) {
  CLI::App* command =
      app.add_subcommand("check", "Hold the float LAR result against the exact one");
  command->footer(
      "Examples: plumbline check plan.svg --radius 0.01 -o report.json --picture check.svg\n"
      "          plumbline check plan.svg --against polygons.geojson\n"
      "          plumbline check plan.svg --engine geos --set configuration=unary-union");
  add_files(*command, arguments);
  add_check_outputs(*command, arguments);
  add_comparison(*command, arguments);
  add_advice(*command, arguments);
  add_engine_options(*command, arguments);
  add_drawing(*command, arguments);
  return command;
}

}  // namespace plumbline::cli
