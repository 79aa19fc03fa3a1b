// The options of arrange in tiles, and the command of a process that arranges one.

#include "cli/options.hpp"

namespace plumbline::cli {

void add_tiles(CLI::App& command, ArrangeArguments& arguments) {
  command.option_defaults()->group("Larger than memory");
  command
      .add_option("--tiles", arguments.tiles,
                  "Arrange so many strips of the drawing one by one, by files in the folder that "
                  "-o names [default: in the folder for temporary files, and removed]: numbers of "
                  "cells and signature2, which is that of the drawing in one piece. --max-memory "
                  "is of each process; a strip that needs more is cut in two")
      ->check(integer(1, kMostTiles))
      ->type_name("N");
  command
      .add_option("--workers", arguments.workers,
                  "So many processes arrange tiles [default: as many as there are cores]")
      ->check(integer(1, kMostWorkers))
      ->type_name("K");
}

CLI::App* add_command(CLI::App& app, TileArguments& arguments) {
  CLI::App* command = app.add_subcommand("tile", "Arrange one tile, for arrange --tiles");
  command->group("");
  command->add_option("FOLDER", arguments.folder, "Of the tiles")->required()->type_name("");
  command->add_option("TILE", arguments.tile, "Its number")->required()->type_name("");
  add_common(*command, arguments);
  return command;
}

}  // namespace plumbline::cli
