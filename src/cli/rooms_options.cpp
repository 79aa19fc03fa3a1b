// The options of rooms.

#include <algorithm>
#include <array>

#include "cli/options.hpp"
#include "cli/suggestions.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

struct NamedUnit {
  const char* name;
  long numerator, denominator;  ///< of metres
};
constexpr std::array kUnits{NamedUnit{"mm", 1, 1000},    NamedUnit{"cm", 1, 100},
                            NamedUnit{"dm", 1, 10},      NamedUnit{"m", 1, 1},
                            NamedUnit{"km", 1000, 1},    NamedUnit{"in", 254, 10000},
                            NamedUnit{"ft", 3048, 10000}};

std::vector<std::string> unit_names() {
  std::vector<std::string> names;
  for (const NamedUnit& unit : kUnits) names.emplace_back(unit.name);
  return names;
}

LengthUnit unit_named(const std::string& name) {
  const auto found = std::ranges::find(kUnits, name, &NamedUnit::name);
  ensure(found != kUnits.end(), "the unit is one of those that the option takes");
  Rational metres(found->numerator, found->denominator);
  metres.canonicalize();
  return {name, metres};
}

void add_size(CLI::App& command, const std::string& name, std::optional<Rational>& size,
              const std::string& what) {
  command
      .add_option_function<std::string>(
          name, [&size](const std::string& text) { size = parse_decimal(text); }, what)
      ->type_name("SIZE");
}

}  // namespace

CLI::App* add_command(CLI::App& app, RoomsArguments& arguments) {
  CLI::App* command =
      app.add_subcommand("rooms", "The rooms of a plan: polygons with names, areas, neighbours");
  command->footer(
      "Examples: plumbline rooms plan.dxf\n"
      "          plumbline rooms plan.dxf -o rooms.geojson --picture rooms.svg\n"
      "          plumbline rooms plan.svg --unit cm --min-width 40 -o rooms.csv");
  add_files(*command, arguments);
  command->option_defaults()->group("Output");
  add_output(*command, arguments.output, arguments.format,
             "Write the rooms, as valid polygons with what is known of them", rooms_formats());
  command->add_option("--picture", arguments.picture, "Draw a plan of the rooms to an SVG file")
      ->type_name("FILE");
  command->add_option("--report", arguments.report, "Write an HTML page: the plan and a list")
      ->type_name("FILE");
  command
      ->add_option("--list", arguments.listed,
                   "Print the N largest rooms [default: as many as fit on a screen]")
      ->check(integer(0))
      ->type_name("N");
  command->option_defaults()->group("Rooms");
  command
      ->add_option("--walls", arguments.walls,
                   "Layers whose lines bound rooms, with commas; * and ? stand for any characters; "
                   "texts of all layers are read [default: all layers]")
      ->delimiter(',')
      ->type_name("LAYERS");
  add_size(*command, "--min-width", arguments.rooms.min_width,
           "A room is so wide that a circle of this diameter fits in, in drawing units [default: "
           "0.5 m; without a unit, what parts walls from rooms best]");
  add_size(*command, "--min-area", arguments.rooms.min_area,
           "A room is so large, in drawing units squared [default: 0.5 m2; without a unit, 2.25 x "
           "the least width squared]");
  command
      ->add_option_function<std::string>(
          "--unit", [&](const std::string& name) { arguments.rooms.unit = unit_named(name); },
          "What a drawing unit is, whatever the file says")
      ->transform(one_of(unit_names()))
      ->type_name("UNIT");
  command
      ->add_option("--doors", arguments.rooms.doors,
                   "Layers whose lines are doors, with commas; * and ? stand for any characters "
                   "[default: *door*]")
      ->delimiter(',')
      ->type_name("LAYERS");
  add_drawing(*command, arguments);
  return command;
}

}  // namespace plumbline::cli
