#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/commands.hpp"
#include "cli/losses.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "plumbline/plumbline.hpp"

namespace plumbline::cli {
namespace {

/// Exact where that is short, else the nearest doubles.
std::string point_text(const std::vector<Number>& coordinates) {
  constexpr std::size_t kShort = 20;
  std::string text;
  for (const Number& x : coordinates) {
    const std::string exact = exact_text(x.rational());
    text += (text.empty() ? "" : " ") +
            (exact.size() <= kShort ? exact : '~' + shortest_text(nearest_double(x)));
  }
  return text;
}

void print_structure(const Structure& structure, Report& report) {
  const auto is_model = [](const Struct::Item& item) {
    return std::holds_alternative<Model>(item) || std::holds_alternative<LarModel>(item);
  };
  std::size_t models = 0;
  for (const Struct& s : structure.structs) {
    models += static_cast<std::size_t>(std::count_if(s.body.begin(), s.body.end(), is_model));
  }
  report.set("structs", structure.structs.size());
  report.set("models", models);
  report.set("instances", instance_count(structure));
  report.set("dimension", static_cast<std::int64_t>(dimension(structure)));
  report.print("structs      {}\nmodels       {}\ninstances    {}\n", structure.structs.size(),
               models, instance_count(structure));
  report.print("dimension    {}\n", dimension(structure));
  if (const auto found = box(structure)) {
    report.print("box          {} .. {}\n", point_text(found->low), point_text(found->high));
  }
}

void print_model(const LarModel& model, Report& report) {
  report.set("vertices", model.vertex_count());
  std::size_t count = 0;
  for (const Cells& cells : model.cells) count += cells.size();
  report.set("cells", count);
  report.print("vertices     {}\n", model.vertex_count());
  for (const Cells& cells : model.cells) report.print("cells        {}\n", cells.size());
}

}  // namespace

ExitCode run(const EvalArguments& arguments, Report& report) {
  const Output output{arguments.output, {"json", "svg", "lines"}, arguments.format};
  if (check_outputs(arguments.file, {output})) report.leave_standard_output();
  const std::string_view format = output.file ? format_of(output) : "";
  if (arguments.as_structure && format != "json") {
    throw Error(ErrorCode::BadInput, "--structure needs -o with a .json file");
  }
  Structure structure;
  {
    const Progress progress("reading " + arguments.file, arguments);
    structure = read(arguments.file, arguments.reading);
  }
  ensure_all_drawn(arguments, arguments.file, structure.rejected,
                   dimension(structure) == 0 && !structure.rejected.empty());
  if (arguments.category) structure = only(structure, *arguments.category);
  if (arguments.embed != 0) structure = embed(structure, arguments.embed);
  print_structure(structure, report);
  SegmentSet losses;  // nothing but what was refused and replaced
  std::swap(losses.files, structure.files);
  std::swap(losses.rejected, structure.rejected);
  std::swap(losses.remarks, structure.remarks);
  losses.ledger = structure.ledger;
  LarModel model = struct_to_lar(
      structure, {arguments.decimals, arguments.merge_cells, arguments.reading.max_segments});
  for (const Replacement& item : replaced_rotations(structure)) losses.ledger.push_back(item);
  if (arguments.boundary) {
    model = boundary_of_all(model);
    structure = structure_of(model, structure.y_up);
    structure.ledger = losses.ledger;
  }
  print_model(model, report);
  set_losses(report, losses);
  report.print("{} rejected\n{}{}\n", losses.rejected.size(), rejected_lines(losses),
               exactness_line(losses));
  if (!arguments.output) return kAgree;
  if (format == "svg") {
    const SegmentSet lines = drawn(structure);
    if (!lines.rejected.empty()) {
      report.print("{} not drawn\n{}", lines.rejected.size(), rejected_lines(lines));
    }
    write_file(*arguments.output, to_svg(lines));
  } else if (format == "lines") {
    const SegmentSet lines = evaluate(structure);
    report.set("segments", lines.segments.size());
    report.print("{}\n{}", input_line(lines), rejected_lines(lines));
    write_file(*arguments.output, to_lines(lines));
  } else if (arguments.as_structure) {
    std::swap(losses.files, structure.files);
    std::swap(losses.rejected, structure.rejected);
    std::swap(losses.remarks, structure.remarks);
    write_file(*arguments.output, to_json(structure));
  } else {
    write_file(*arguments.output, to_json(model));
  }
  report.say_written(*arguments.output);
  return kAgree;
}

}  // namespace plumbline::cli
