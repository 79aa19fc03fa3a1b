// Whole commands: what the tool does between reading and writing files.

#include "contenders.hpp"
#include "plumbline/output.hpp"
#include "plumbline/pipeline.hpp"

namespace plumbline::bench {
namespace {

constexpr std::size_t kThreads = 1;

Drawing exact_drawing(const std::string& text) {
  Drawing drawing;
  drawing.structure = read_lines(text, "text");
  drawing.input = evaluate(drawing.structure);
  drawing.complex = arrange(drawing.input, ExactEngine::Bucket, {kThreads, {}});
  ensure(validate(drawing.complex).empty(), "the complex is valid");
  ensure(validate_coverage(drawing.complex, drawing.input).empty(), "it covers the input");
  return drawing;
}

/// What is printed and written of an `arrange`, and its cells.
template <class Write>
Job arrange_command(const SegmentSet& input, Write write) {
  return [text = to_lines(input), write] {
    const Drawing drawing = exact_drawing(text);
    const ExactComplex& c = drawing.complex;
    const Cells cells{c.vertices.size(), c.edge_count(), c.face_count()};
    return Outcome{std::make_shared<const std::string>(signature(c) + write(drawing)),
                   [cells] { return cells; }};
  };
}

Job check_command(const SegmentSet& input, const Parameters& parameters) {
  return [text = to_lines(input), parameters] {
    Drawing drawing = exact_drawing(text);
    const Engine lar = engine_named("lar", engines());
    Answer answer = answer_of(lar, drawing.input, parameters, kThreads);
    const Check check = checked(std::move(drawing), std::move(answer), {}, kThreads);
    return Outcome{std::make_shared<const std::string>(to_text(check)), [] { return Cells{}; }};
  };
}

}  // namespace

Job prepare_arrange(const SegmentSet& input) {
  return arrange_command(input, [](const Drawing&) { return std::string(); });
}

Job prepare_json(const SegmentSet& input) {
  return arrange_command(input, [](const Drawing& d) { return to_json(d.complex, d.input); });
}

Job prepare_compact(const SegmentSet& input) {
  return arrange_command(input,
                         [](const Drawing& d) { return to_compact_json(d.complex, d.input); });
}

Job prepare_safe(const SegmentSet& input) {
  return arrange_command(input, [](const Drawing& d) {
    const Grid grid{6};
    const Rounding rounding = safely_rounded(d.complex, grid, {kThreads, {}});
    return to_json(d.complex, d.input, grid, rounding);
  });
}

Job prepare_check_fine(const SegmentSet& input) { return check_command(input, {{"radius", 1e-9}}); }

Job prepare_check(const SegmentSet& input) { return check_command(input, {}); }

}  // namespace plumbline::bench
