#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/complex_file.hpp"
#include "cli/formats.hpp"
#include "cli/load.hpp"
#include "cli/losses.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output.hpp"

namespace plumbline::cli {
namespace {

std::string content(std::string_view format, const RoomsArguments& arguments,
                    const Drawing& drawing, const Rooms& found) {
  if (format == "json") return to_json(found, drawing.input);
  if (format == "svg") return to_svg(found, drawing.input, drawing.complex);
  if (format == "html") return to_html(found, drawing.input, drawing.complex);
  const Progress progress(fmt::format("rounding {} vertices", drawing.complex.vertices.size()),
                          arguments);
  const Rounding rounding = safely_rounded(drawing.complex, {}, {arguments.threads, {}});
  return feature_file(format, {{room_layer(found, rounding)},
                               drawing.input.crs,
                               note_of(rounding),
                               drawing.input.layers,
                               found.unit ? found.unit : drawing.input.unit});
}

Summary summary_of(const Room& room, std::size_t number) {
  Summary summary;
  summary.set("room", number);
  summary.set("names", room.names);
  summary.set("layers", room.layers);
  summary.set("area", nearest_double(room.area));
  summary.set("area_exact", exact_text(room.area));
  summary.set("perimeter", room.perimeter);
  summary.set("depth", room.depth);
  return summary;
}

/// Where lines of many layers bound rooms, furniture does, too.
std::string layers_hint(const RoomsArguments& arguments, const SegmentSet& input) {
  const std::size_t layers = layers_of(input).size();
  if (!arguments.walls.empty() || !arguments.reading.layers.empty() || layers < 2) return "";
  return fmt::format(
      "lines of all {} layers bound rooms, furniture, too: --walls LAYERS chooses "
      "(plumbline info lists them)\n",
      layers);
}

void set_rooms(Report& report, const Rooms& found) {
  std::vector<Summary> all;
  for (const Room& room : found.rooms) {
    all.push_back(summary_of(room, all.size() + 1));
    if (!found.unit) continue;
    const Rational square = found.unit->metres * found.unit->metres;
    all.back().set("area_m2", nearest_double(room.area * square));
  }
  if (found.unit) report.set("metres", nearest_double(found.unit->metres));
  report.set("narrow", found.narrow);
  report.set("small", found.small);
  report.set("texts_outside", found.outside.size());
  report.set("rooms", all);
}

}  // namespace

ExitCode run(const RoomsArguments& arguments, Report& report) {
  const Output output{arguments.output, rooms_formats(), arguments.format};
  if (check_outputs(arguments.file,
                    {output, {arguments.picture, {"svg"}}, {arguments.report, {"html"}}})) {
    report.leave_standard_output();
  }
  const Drawing drawing = load(arguments);
  ensure_all_drawn(arguments, drawing.input);
  const Rooms found = [&] {
    const Progress progress("looking for rooms", arguments);
    RoomOptions options = arguments.rooms;
    options.unit = arguments.unit;
    return rooms(drawing.input, drawing.complex, options);
  }();
  report.set_headline(
      fmt::format("{} room{}", found.rooms.size(), found.rooms.size() == 1 ? "" : "s"));
  set_losses(report, drawing.input);
  set_rooms(report, found);
  report.print("{}{}", to_text(found, drawing.input, arguments.listed),
               layers_hint(arguments, drawing.input));
  if (const std::size_t places = drawing.joined.places; places > 0) {
    report.set("joined", places);
    report.print("joined {}\n", to_text(drawing.joined));
  }
  const auto write = [&](const std::string& file, const std::string& text) {
    write_file(file, text);
    report.say_written(file);
  };
  if (output.file) {
    write(*output.file, content(format_of(output), arguments, drawing, found));
  }
  if (arguments.picture) {
    write(*arguments.picture, to_svg(found, drawing.input, drawing.complex));
  }
  if (arguments.report) {
    write(*arguments.report, to_html(found, drawing.input, drawing.complex));
  }
  return kAgree;
}

}  // namespace plumbline::cli
