#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

#include "cli/commands.hpp"
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

/// The categories that there are, for who asked for another.
std::string categories(const Structure& structure) {
  std::set<std::string> names;
  for (const Struct& s : structure.structs) names.insert(s.category);
  names.erase("");
  if (names.empty()) return "there are none";
  return fmt::format("there are {}", fmt::join(names, ", "));
}

Structure only(const Structure& structure, const std::string& category) {
  const auto is_of = [&](const Struct& s) { return s.category == category; };
  if (std::none_of(structure.structs.begin(), structure.structs.end(), is_of)) {
    throw Error(ErrorCode::BadInput, "no structure of this category; " + categories(structure), {},
                category);
  }
  return filter(structure, category);
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

/// The boundary of the chain of all cells; in the plane by the sides of its polygons, elsewhere by
/// the facets that its cells hold.
LarModel boundary(const LarModel& model) {
  if (model.dimension == 2) return polygon_boundary(model);
  if (model.cells.size() < 2) {
    throw Error(ErrorCode::BadInput, "the boundary of cells without facets, (V, CV), is not known");
  }
  return boundary_model(model);
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
  check_outputs(arguments.file, {{arguments.output, {".json", ".svg", ".lines"}}});
  if (arguments.as_structure && (!arguments.output || ending(*arguments.output) != ".json")) {
    throw Error(ErrorCode::BadInput, "--structure needs -o with a .json file");
  }
  Structure structure;
  {
    const Progress progress("reading " + arguments.file);
    structure = read(arguments.file, arguments.reading);
  }
  if (arguments.category) structure = only(structure, *arguments.category);
  if (arguments.embed != 0) structure = embed(structure, arguments.embed);
  print_structure(structure);
  SegmentSet report;  // nothing but what was refused and replaced
  std::swap(report.files, structure.files);
  std::swap(report.rejected, structure.rejected);
  std::swap(report.ledger, structure.ledger);
  LarModel model = struct_to_lar(
      structure, {arguments.decimals, arguments.merge_cells, arguments.reading.max_segments});
  if (arguments.boundary) {
    model = boundary(model);
    structure = structure_of(model, structure.y_up);
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
    fmt::print("{} segments, {} rejected\n{}", lines.segments.size(), lines.rejected.size(),
               rejected_lines(lines));
    write_file(*arguments.output, to_lines(lines));
  } else if (arguments.as_structure) {
    std::swap(report.files, structure.files);
    std::swap(report.rejected, structure.rejected);
    std::swap(report.ledger, structure.ledger);
    write_file(*arguments.output, to_json(structure));
  } else {
    write_file(*arguments.output, to_json(model));
  }
  print_written(*arguments.output);
  return kAgree;
}

}  // namespace plumbline::cli
