// The commands lar, eval and random.

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/options.hpp"
#include "cli/suggestions.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

constexpr const char* kLarExamples =
    "Examples: plumbline lar plan.svg --variant published --trace plan.json\n"
    "          plumbline lar plan.svg --show polylines -o polylines.svg\n"
    "          plumbline lar plan.svg --show boundary --faces 0,3 -o boundary.svg";

struct NamedPicture {
  const char* name;
  LarShow show;
};
constexpr std::array kPictures{
    NamedPicture{"buckets", LarShow::Buckets},   NamedPicture{"components", LarShow::Components},
    NamedPicture{"faces", LarShow::Faces},       NamedPicture{"explode", LarShow::Explode},
    NamedPicture{"numbers", LarShow::Numbers},   NamedPicture{"pruning", LarShow::Pruning},
    NamedPicture{"filled", LarShow::Filled},     NamedPicture{"polylines", LarShow::Polylines},
    NamedPicture{"boundary", LarShow::Boundary},
};

void add_lar_outputs(CLI::App& command, LarArguments& arguments) {
  std::vector<std::string> pictures;
  for (const NamedPicture& picture : kPictures) pictures.emplace_back(picture.name);
  command
      .add_option("-o,--output", arguments.output,
                  "Write a picture to an SVG file; - is standard output")
      ->type_name("FILE");
  command
      .add_option_function<std::string>(
          "--show",
          [&](const std::string& name) {
            arguments.picture.show = std::ranges::find(kPictures, name, [](const auto& p) {
                                       return std::string(p.name);
                                     })->show;
          },
          "What -o draws: buckets, components, faces (the default), explode, numbers, pruning, "
          "filled (triangulated faces), polylines (boundaries joined by bridge edges), boundary "
          "(of "
          "the chain of --faces)")
      ->transform(one_of(pictures))
      ->type_name("WHAT");
  command.add_option("--factor", arguments.picture.explode, "Of --show explode [default: 1.2]")
      ->check(finite())
      ->type_name("F");
  command
      .add_option("--faces", arguments.picture.faces,
                  "Of --show boundary: faces by the numbers that it shows [default: all]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(integer(0))
      ->type_name("F,F,...");
  command.add_option("--trace", arguments.trace, "Write the output of every stage to a JSON file")
      ->type_name("FILE");
}

}  // namespace

CLI::App* add_command(CLI::App& app, LarArguments& arguments) {
  CLI::App* command =
      app.add_subcommand("lar", "The float LAR pipeline, stage by stage, as published or repaired");
  command->footer(kLarExamples);
  add_file(*command, arguments);
  command->option_defaults()->group("Pictures and traces");
  add_lar_outputs(*command, arguments);
  command->option_defaults()->group("The pipeline");
  command
      ->add_option_function<std::string>(
          "--variant",
          [&](const std::string& variant) { arguments.is_published = variant == "published"; },
          "repaired (the default) or published")
      ->transform(one_of({"repaired", "published"}))
      ->type_name("VARIANT");
  command
      ->add_option("--decimals", arguments.decimals,
                   "Decimals of the published variant's coordinates and parameters [default: 4]")
      ->check(integer(0))
      ->type_name("N");
  command
      ->add_option_function<std::string>(
          "--radius",
          [&](const std::string& text) {
            if (!is_preset(text) && !std::isfinite(nearest_double(parse_decimal(text)))) {
              throw Error(ErrorCode::BadInput, "the radius is not finite", {}, text);
            }
            arguments.radius = text;
          },
          "Vertices no further apart than this are merged: a number in drawing units; "
          "larlib, 0.001 x the longer side; plasm, 1e-8; drawing, the default [default: "
          "published 0.001, repaired 0.001 x the drawing's longer side]")
      ->check(radius())
      ->type_name("R");
  command->add_flag("--unit-square", arguments.unit_square,
                    "Map the drawing to the unit square first, y upwards, as published for SVG");
  add_threads(*command, arguments.threads);
  add_reading(*command, arguments);
  return command;
}

CLI::App* add_command(CLI::App& app, EvalArguments& arguments) {
  CLI::App* command =
      app.add_subcommand("eval", "Evaluate a hierarchical structure to one LAR model or a picture");
  command->footer(
      "Examples: plumbline eval table.json -o table.svg\n"
      "          plumbline eval plan.svg --structure -o plan.json\n"
      "          plumbline eval plan.svg -o plan.lines\n");
  add_file(*command, arguments, "A structure (.json), or any drawing; - is standard input");
  command->option_defaults()->group("Output");
  add_output(*command, arguments.output, arguments.format,
             "Write the LAR model to a .json file, its segments to a .lines file or a picture of "
             "them to an .svg file",
             {"json", "svg", "lines"});
  command->add_flag("--structure", arguments.as_structure,
                    "Write the hierarchy itself to the .json file, not the LAR model");
  command->option_defaults()->group("Evaluation");
  command
      ->add_option("--decimals", arguments.decimals,
                   "Identify vertices that are equal after rounding to N decimals [default: exact]")
      ->check(integer(0, Number::kMaxDigits))
      ->type_name("N");
  command->add_flag("--merge-cells", arguments.merge_cells, "Keep repeated cells once");
  command->add_flag("--boundary", arguments.boundary,
                    "The boundary of all cells: facets that an odd number of them hold");
  command
      ->add_option("--embed", arguments.embed, "Add N dimensions (-N: drop the last N coordinates)")
      ->check(integer())
      ->type_name("N");
  command
      ->add_option("--category", arguments.category,
                   "Only what stands within structures of this category (layer, block, ...)")
      ->type_name("NAME");
  add_reading(*command, arguments);
  return command;
}

CLI::App* add_command(CLI::App& app, RandomArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "random", "Random segments, the same for the same seed: LAR's randomLines");
  command->footer(
      "Example: plumbline random 5000 --scaling 0.1 -o random.lines\n"
      "Each is the difference of two random points of the unit square, scaled, about a third.");
  command->option_defaults()->group("Options");
  command->add_option("N", arguments.count, "How many")
      ->required()
      ->check(integer(0, kMostRandomSegments))
      ->type_name("");
  command->add_option("--scaling", arguments.scaling, "Of their lengths [default: 0.1]")
      ->check(finite())
      ->type_name("S");
  command->add_option("--seed", arguments.seed, "Determines the segments [default: 1]")
      ->check(integer(0))
      ->type_name("K");
  command
      ->add_option("-o,--output", arguments.output,
                   "Write them to a .lines file [default: to standard output]")
      ->type_name("FILE");
  add_common(*command, arguments);
  return command;
}

}  // namespace plumbline::cli
