#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/commands.hpp"
#include "cli/losses.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"
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

void print_structure(const Structure& structure) {
  const auto is_model = [](const Struct::Item& item) {
    return std::holds_alternative<Model>(item) || std::holds_alternative<LarModel>(item);
  };
  std::size_t models = 0;
  for (const Struct& s : structure.structs) {
    models += static_cast<std::size_t>(std::count_if(s.body.begin(), s.body.end(), is_model));
  }
  fmt::print("structs      {}\nmodels       {}\ninstances    {}\n", structure.structs.size(),
             models, instance_count(structure));
  fmt::print("dimension    {}\n", dimension(structure));
  if (const auto found = box(structure)) {
    fmt::print("box          {} .. {}\n", point_text(found->low), point_text(found->high));
  }
}

void print_model(const LarModel& model) {
  fmt::print("vertices     {}\n", model.vertex_count());
  for (const Cells& cells : model.cells) fmt::print("cells        {}\n", cells.size());
}

}  // namespace

ExitCode run(const EvalArguments& arguments) {
  check_outputs(arguments.file, {{arguments.output, {".json", ".svg", ".lines"}}});
  if (arguments.as_structure && (!arguments.output || ending(*arguments.output) != ".json")) {
    throw Error(ErrorCode::BadInput, "--structure needs -o with a .json file");
  }
  Structure structure;
  {
    const Progress progress("reading " + arguments.file);
    structure = read(arguments.file, arguments.reading);
  }
  ensure_all_drawn(arguments, arguments.file, structure.rejected,
                   dimension(structure) == 0 && !structure.rejected.empty());
  if (arguments.category) structure = only(structure, *arguments.category);
  if (arguments.embed != 0) structure = embed(structure, arguments.embed);
  print_structure(structure);
  SegmentSet report;  // nothing but what was refused and replaced
  std::swap(report.files, structure.files);
  std::swap(report.rejected, structure.rejected);
  std::swap(report.remarks, structure.remarks);
  report.ledger = structure.ledger;
  LarModel model = struct_to_lar(
      structure, {arguments.decimals, arguments.merge_cells, arguments.reading.max_segments});
  for (const Replacement& item : replaced_rotations(structure)) report.ledger.push_back(item);
  if (arguments.boundary) {
    model = boundary_of_all(model);
    structure = structure_of(model, structure.y_up);
    structure.ledger = report.ledger;
  }
  print_model(model);
  fmt::print("{} rejected\n{}{}\n", report.rejected.size(), rejected_lines(report),
             exactness_line(report));
  if (!arguments.output) return kAgree;
  if (ending(*arguments.output) == ".svg") {
    const SegmentSet lines = drawn(structure);
    if (!lines.rejected.empty()) {
      fmt::print("{} not drawn\n{}", lines.rejected.size(), rejected_lines(lines));
    }
    write_file(*arguments.output, to_svg(lines));
  } else if (ending(*arguments.output) == ".lines") {
    const SegmentSet lines = evaluate(structure);
    fmt::print("{}\n{}", input_line(lines), rejected_lines(lines));
    write_file(*arguments.output, to_lines(lines));
  } else if (arguments.as_structure) {
    std::swap(report.files, structure.files);
    std::swap(report.rejected, structure.rejected);
    std::swap(report.remarks, structure.remarks);
    write_file(*arguments.output, to_json(structure));
  } else {
    write_file(*arguments.output, to_json(model));
  }
  print_written(*arguments.output);
  return kAgree;
}

}  // namespace plumbline::cli
