#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/commands.hpp"
#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"
#include "plumbline/plumbline.hpp"

namespace plumbline::cli {
namespace {

std::string point_text(const std::vector<Number>& coordinates) {
  std::string text;
  for (const Number& x : coordinates) {
    text += (text.empty() ? "" : " ") + exact_text(x.rational());
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

/// A structure of one model.
Structure structure_of(LarModel model, bool y_up) {
  Structure structure;
  structure.y_up = y_up;
  structure.structs.push_back({"", "", {std::move(model)}});
  structure.root = StructId(0);
  return structure;
}

/// The boundary of the chain of all cells. Cells of the plane without edges get them first.
LarModel boundary(const LarModel& model) {
  const bool needs_edges = model.dimension == 2 && model.cells.size() == 1;
  if (!needs_edges && model.cells.size() < 2) {
    throw Error(ErrorCode::BadInput, "the boundary of cells without facets, (V, CV), is not known");
  }
  return boundary_model(needs_edges ? with_edges(model) : model);
}

/// The structure as lines of the plane; one of space in an oblique view, (x + y/2, z + y/4).
SegmentSet drawn(const Structure& structure) {
  constexpr std::size_t kSpace = 3;
  if (dimension(structure) != kSpace) return evaluate(structure);
  Affine view(kSpace);
  view(0, 1) = Number(Rational(1, 2));
  view(1, 1) = Number(Rational(1, 4));
  view(1, 2) = Number(Rational(1));
  LarModel model = struct_to_lar(structure, {std::nullopt, true});
  return evaluate(structure_of(embed(apply(view, std::move(model)), -1), structure.y_up));
}

}  // namespace

ExitCode run(const EvalArguments& arguments) {
  check_outputs(arguments.file, {{arguments.output, {".json", ".svg"}}});
  Structure structure;
  {
    const Progress progress("reading " + arguments.file);
    structure = read(arguments.file, arguments.reading);
  }
  if (arguments.category) structure = filter(structure, *arguments.category);
  if (arguments.embed != 0) structure = embed(structure, arguments.embed);
  print_structure(structure);
  SegmentSet report;  // nothing but what was refused and replaced
  std::swap(report.files, structure.files);
  std::swap(report.rejected, structure.rejected);
  std::swap(report.ledger, structure.ledger);
  LarModel model = struct_to_lar(structure, {arguments.decimals, arguments.merge_cells});
  if (arguments.boundary) {
    model = boundary(model);
    structure = structure_of(model, structure.y_up);
  }
  print_model(model);
  fmt::print("{} rejected\n{}{}\n", report.rejected.size(), rejected_lines(report),
             exactness_line(report));
  if (!arguments.output) return kAgree;
  if (ending(*arguments.output) == ".svg") {
    write_file(*arguments.output, to_svg(drawn(structure)));
  } else if (arguments.as_structure) {
    std::swap(report.files, structure.files);
    std::swap(report.rejected, structure.rejected);
    std::swap(report.ledger, structure.ledger);
    write_file(*arguments.output, to_json(structure));
  } else {
    write_file(*arguments.output, to_json(model));
  }
  fmt::print("wrote {}\n", *arguments.output);
  return kAgree;
}

}  // namespace plumbline::cli
