// Which engine, which advice.

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include "plumbline/engines/files.hpp"
#include "plumbline/engines/inters.hpp"
#include "plumbline/engines/lar.hpp"
#include "plumbline/engines/plasm.hpp"
#include "plumbline/engines/programs.hpp"
#include "plumbline/error.hpp"
#include "plumbline/pipeline.hpp"

namespace plumbline {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

int decimals_of(const Parameters& parameters) {
  const auto found = parameters.find("decimals");
  return found == parameters.end() ? inters::kDecimals
                                   : static_cast<int>(std::get<std::int64_t>(found->second));
}

}  // namespace

std::vector<Engine> engines() {
  return {lar::engine(), inters::engine(), plasm::engine(), files::engine()};
}

Engine engine_named(const std::string& name, const std::vector<Engine>& engines,
                    std::span<const std::filesystem::path> folders) {
  if (name.find('/') != std::string::npos) return programs::engine(name);
  std::string known;
  for (const Engine& engine : engines) {
    if (engine.name == name) return engine;
    known += (known.empty() ? "" : ", ") + engine.name;
  }
  std::string found;
  for (const programs::Program& program : programs::found_in(folders)) {
    if (program.name == name) return programs::engine(program.path, name);
    found += (found.empty() ? "; programs found are " : ", ") + program.name;
  }
  throw Error(ErrorCode::BadInput, "unknown engine; there are " + known + found, {}, name);
}

Engine engine_for(Engine engine, const Drawing& drawing, const Parameters& parameters) {
  if (engine.name != "inters" || !drawing.unit_square) return engine;
  inters::Original original;
  original.lines =
      inters::lines_on_unit_square(evaluate(drawing.structure), decimals_of(parameters));
  return inters::engine(std::move(original));
}

Engine inters_with_svg2lines(const Drawing& drawing) {
  if (drawing.unit_square) {
    throw Error(ErrorCode::BadInput, "svg2lines is told of the drawing as it is in the file");
  }
  if (drawing.file.extension() != ".svg" || !std::filesystem::is_regular_file(drawing.file)) {
    throw Error(ErrorCode::BadInput, "svg2lines reads .svg files", {drawing.file.string(), 0, 0});
  }
  return inters::engine({{}, text_of(drawing.file)});
}

std::optional<double> preset_radius(std::string_view preset, const SegmentSet& input) {
  if (preset == "drawing") return std::nullopt;
  if (preset == "plasm") return plasm::kRadius;
  std::optional<PointD> low, high;
  const auto include = [&](const NumberPoint& point) {
    const PointD p = nearest(point);
    low = low ? PointD{std::min(low->x, p.x), std::min(low->y, p.y)} : p;
    high = high ? PointD{std::max(high->x, p.x), std::max(high->y, p.y)} : p;
  };
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const auto n = input.segments.numbers(s);
    include({n[0], n[1]});
    include({n[2], n[3]});
  }
  if (!low) return 0;
  return lar::kDefaultRelativeRadius * std::max(high->x - low->x, high->y - low->y);
}

Check checked(Drawing drawing, Answer answer, std::optional<double> tolerance, std::size_t threads,
              std::function<void(const std::string&)> begins) {
  CheckOptions options{tolerance, {}, threads, std::move(begins)};
  options.parsed = [&] {
    const SegmentSet input = evaluate_rounded(drawing.structure);
    return drawing.unit_square ? lar::to_unit_square(input) : input;
  };
  return check(std::move(drawing.input), std::move(drawing.complex), std::move(answer), options);
}

Check with_advice(Check check, const AdvicePolicy& policy, const AdviceOptions& options) {
  const bool is_small = check.exact_complex.edge_count() <= kMostEdgesForAdvice;
  const bool wants_radii = check.answer.with_radius && policy.right_radii.value_or(is_small);
  if (!wants_radii && !policy.ladder) return check;
  AdviceOptions wanted = options;
  if (!wants_radii) wanted.max_runs = 0;
  return advised(std::move(check), wanted);
}

}  // namespace plumbline
