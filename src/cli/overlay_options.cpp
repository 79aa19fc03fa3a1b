// The commands overlay and select.

#include "cli/options.hpp"
#include "cli/suggestions.hpp"

namespace plumbline::cli {
namespace {

constexpr std::array kRules{FillRule::EvenOdd, FillRule::NonZero, FillRule::Positive,
                            FillRule::Negative};

void add_rule(CLI::App& command, FillRule& rule) {
  std::vector<std::string> names;
  for (const FillRule each : kRules) names.push_back(to_text(each));
  command
      .add_option_function<std::string>(
          "--rule",
          [&rule](const std::string& name) {
            for (const FillRule each : kRules) {
              if (to_text(each) == name) rule = each;
            }
          },
          "What is inside a polygon whose rings overlap or cross: where they wind evenodd, "
          "nonzero, "
          "positive or negative times [default: evenodd]")
      ->transform(one_of(names))
      ->type_name("RULE:evenodd|nonzero|positive|negative");
}

void add_pictures(CLI::App& command, std::optional<std::string>& picture,
                  std::optional<std::size_t>& listed, const std::string& what) {
  command.add_option("--picture", picture, "Draw " + what + " to an SVG file")->type_name("FILE");
  command.add_option("--list", listed, "Print the N largest [default: as many as fit on a screen]")
      ->check(integer(0))
      ->type_name("N");
}

}  // namespace

CLI::App* add_command(CLI::App& app, OverlayArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "overlay", "Two layers of polygons over each other: exact pieces that know their polygons");
  command->footer(
      "Examples: plumbline overlay parcels.geojson zones.geojson -o pieces.geojson\n"
      "          plumbline overlay parcels.geojson lakes.wkt --how difference -o land.geojson\n"
      "          plumbline overlay old.dxf new.dxf --how symmetric_difference --picture new.svg\n"
      "Each piece lies in the same polygons as a whole; what touches in lines or points alone is "
      "none. Areas are exact.");
  add_file(*command, arguments, "The first layer, in any format that is read; - is standard input");
  command
      ->add_option_function<std::string>(
          "SECOND", [&](const std::string& name) { arguments.second = file_of(name); },
          "The second one")
      ->required()
      ->type_name("");
  command->option_defaults()->group("Overlay");
  command
      ->add_option_function<std::string>(
          "--how", [&](const std::string& word) { arguments.how = overlay_how(word); },
          "intersection: what is in both; union: in either; difference: in the first alone; "
          "symmetric_difference: in one alone; identity: the first, parted by the second "
          "[default: intersection]")
      ->transform(one_of({std::begin(kOverlayHows), std::end(kOverlayHows)}))
      ->type_name("HOW:intersection|union|difference|symmetric_difference|identity");
  add_rule(*command, arguments.rule);
  command->option_defaults()->group("Output");
  add_output(*command, arguments.output, arguments.format,
             "Write the pieces, as valid polygons with the elements that they lie in",
             feature_formats());
  add_pictures(*command, arguments.picture, arguments.listed, "the pieces");
  add_reading(*command, arguments);
  add_threads(*command, arguments.threads);
  return command;
}

CLI::App* add_command(CLI::App& app, SelectArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "select", "What an expression of layers encloses, such as \"WALLS - (DOORS | WINDOWS)\"");
  command->footer(
      "Examples: plumbline select plan.dxf \"WALLS - (DOORS | WINDOWS)\" -o walls.geojson\n"
      "          plumbline select plan.svg \"count >= 2\" --picture overlaps.svg\n"
      "          plumbline select plan.dxf \"'A-WALL*' & !'A-VOID'\" --json\n"
      "Operators: ! not, & and, | or, ^ either, - without; count, or count(NAME), compared by "
      "< <= = != >= > with a number. A name is that of a layer, in quotes where it has other "
      "characters than letters, digits and _ . : * ?. A layer has its polygons, and what its other "
      "lines close.");
  add_file(*command, arguments);
  command->add_option("EXPRESSION", arguments.expression, "Of names of layers")
      ->required()
      ->type_name("");
  command->option_defaults()->group("Output");
  add_output(*command, arguments.output, arguments.format,
             "Write what is selected, as valid polygons", feature_formats());
  add_pictures(*command, arguments.picture, arguments.listed, "the drawing with what is selected");
  command->option_defaults()->group("Selection");
  add_rule(*command, arguments.rule);
  add_drawing(*command, arguments);
  return command;
}

}  // namespace plumbline::cli
