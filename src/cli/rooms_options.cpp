// The options of rooms.

#include "cli/options.hpp"

namespace plumbline::cli {
CLI::App* add_command(CLI::App& app, RoomsArguments& arguments) {
  arguments.joins_drift = true;
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
      ->add_option("--doors", arguments.rooms.doors,
                   "Layers whose lines are doors, with commas; * and ? stand for any characters "
                   "[default: *door*]")
      ->delimiter(',')
      ->type_name("LAYERS");
  add_drawing(*command, arguments);
  return command;
}

}  // namespace plumbline::cli
