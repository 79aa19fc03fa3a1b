// The commands coverage and validity.

#include "cli/options.hpp"
#include "cli/suggestions.hpp"

namespace plumbline::cli {
namespace {

void add_list(CLI::App& command, std::optional<std::size_t>& listed, const std::string& what) {
  command.add_option("--list", listed, what + " [default: as many as fit on a screen]")
      ->check(integer(0))
      ->type_name("N");
}

void add_limits(CLI::App& command, CoverageArguments& arguments) {
  command.option_defaults()->group("What counts");
  add_size(command, "--width", arguments.width,
           "Only gaps and overlaps into which no circle fits that is wider than this, in drawing "
           "units; the others are meant to be, as lakes are [default: all]");
  add_size(command, "--area", arguments.area,
           "Only those that are not larger, in drawing units squared [default: all]");
  command.add_flag("--all-overlaps", arguments.all_overlaps,
                   "Overlaps of any size; the limits are for gaps alone");
}

}  // namespace

CLI::App* add_command(CLI::App& app, CoverageArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "coverage", "Overlaps and gaps between polygons that should be neighbours, exactly");
  command->footer(
      "Examples: plumbline coverage parcels.geojson\n"
      "          plumbline coverage parcels.geojson --clean -o clean.geojson\n"
      "          plumbline coverage zones.geojson --clean --width 0.5 --all-overlaps --policy "
      "smallest -o clean.geojson\n"
      "No vertex moves: faces go to other polygons, and neighbours get each other's vertices. A "
      "GeoJSON file keeps its features and their properties. The exit code is 1 where faults are "
      "found, with --clean where some are left.");
  add_files(*command, arguments);
  command->option_defaults()->group("Coverage");
  CLI::Option* check =
      command->add_flag("--check", arguments.check,
                        "Tell overlaps, gaps and corners that a neighbour's side lacks [default]");
  command->add_flag("--clean", arguments.clean, "Give each overlap and gap to one polygon")
      ->excludes(check);
  command
      ->add_option_function<std::string>(
          "--policy", [&](const std::string& word) { arguments.policy = coverage_policy(word); },
          "To which one: longest-border: with which it has the longest border; largest: of the "
          "largest area; smallest; first: in the file [default: longest-border]")
      ->transform(one_of({std::begin(kCoveragePolicies), std::end(kCoveragePolicies)}))
      ->type_name("POLICY:longest-border|largest|smallest|first");
  add_limits(*command, arguments);
  command->option_defaults()->group("Output");
  add_output(*command, arguments.output, arguments.format,
             "Write the clean polygons; .geojson of a GeoJSON file keeps all that is not changed",
             feature_formats());
  add_list(*command, arguments.listed, "Print the N largest of each kind");
  add_drawing(*command, arguments);
  return command;
}

CLI::App* add_command(CLI::App& app, ValidityArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "validity", "Which polygons are valid, why not and where; valid ones in their place");
  command->footer(
      "Examples: plumbline validity parcels.geojson\n"
      "          plumbline validity parcels.geojson --make-valid structure -o valid.geojson\n"
      "          plumbline validity parcels.wkt --json\n"
      "Reasons are those of JTS and GEOS (OGC Simple Features), all of them, in exact places. A "
      "GeoJSON file keeps its features and their properties. The exit code is 1 where a polygon "
      "is not valid.");
  add_files(*command, arguments);
  command->option_defaults()->group("Valid polygons");
  command
      ->add_option_function<std::string>(
          "--make-valid", [&](const std::string& word) { arguments.meaning = valid_meaning(word); },
          "What an invalid polygon covers. linework: what is within an odd number of rings; "
          "structure: what its outer rings go around, without what their holes do; nonzero: what "
          "all rings, as they run, go around more often one way than the other")
      ->transform(one_of({std::begin(kValidMeanings), std::end(kValidMeanings)}))
      ->type_name("MEANING:linework|structure|nonzero");
  command->option_defaults()->group("Output");
  add_output(*command, arguments.output, arguments.format,
             "Write all polygons, valid; .geojson of a GeoJSON file keeps all that is not changed",
             feature_formats());
  add_list(*command, arguments.listed, "Print the first N polygons that are not valid");
  add_drawing(*command, arguments);
  return command;
}

}  // namespace plumbline::cli
