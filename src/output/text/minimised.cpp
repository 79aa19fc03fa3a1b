// The minimised drawing on a screen.

#include "output/text/minimised.hpp"

#include <fmt/format.h>

#include "output/text/terminal.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kShownRows = 24;
constexpr std::size_t kShortDigits = 20;  ///< characters of an exact coordinate that need no double

std::string headline(const Minimised& m) {
  const std::string whole = counted(m.segments_before, "segment");
  if (m.outcome.outcome_class == OutcomeClass::Right) {
    const std::size_t own = m.check.own_findings();
    return fmt::format("agree{}: {} is right about the drawing, {}, its numbers as doubles\n",
                       own > 0 ? " but for the file's own drift" : "", line_text(m.engine), whole);
  }
  return fmt::format("disagree: {}, in {} of {}\n", line_text(m.outcome.kind),
                     m.drawing.segments.size(), whole);
}

std::string how_small(const Minimised& m) {
  if (!m.is_one_minimal) {
    return fmt::format("not the least: it ended after {}\n", counted(m.runs, "run"));
  }
  return fmt::format("none can be left out{}; {}\n",
                     m.has_simple_numbers ? ", nor a number be simpler" : "",
                     counted(m.runs, "run"));
}

std::string shown_rows(const SegmentSet& drawing) {
  const std::string rows = rows_of(drawing);
  std::size_t end = 0, count = 0;
  for (; count < kShownRows && end < rows.size(); ++count) end = rows.find('\n', end) + 1;
  std::string text = "\n" + rows.substr(0, end);
  if (count < drawing.segments.size()) {
    text += fmt::format("... and {} more\n", drawing.segments.size() - count);
  }
  return text + '\n';
}

std::string gravest(const Minimised& m) {
  if (m.outcome.finding == 0) return {};
  const Finding& finding = m.check.comparison.findings[m.outcome.finding - 1];
  std::string text = fmt::format("\n{}: {}\n", m.outcome.kind.substr(0, m.outcome.kind.find(": ")),
                                 line_text(finding.message));
  if (finding.kind != CellKind::Complex) text += "  at " + exact_place(finding.where) + '\n';
  if (m.outcome.finding <= m.check.causes.size()) {
    const Cause& cause = m.check.causes[m.outcome.finding - 1];
    text += fmt::format("  {}, {}: {}\n", cause.stage, cause.rule, line_text(cause.explanation));
  }
  const std::size_t more = m.check.comparison.findings.size() - 1;
  if (more > 0) text += fmt::format("  and {}\n", counted(more, "further finding"));
  return text;
}

}  // namespace

std::string value_text(const ParameterValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return shortest_text(*number);
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
  return std::get<std::string>(value);
}

std::string version_line(const Minimised& m) {
  const Answer& answer = m.check.answer;
  std::string text = fmt::format("engine {} {} ({})", m.engine, answer.version, answer.title);
  for (const auto& [name, value] : answer.parameters) {
    text += fmt::format(", {} {}", name, value_text(value));
  }
  return line_text(text + ", tolerance " + short_number(m.check.comparison.tolerance));
}

std::string count_table(const Minimised& m) {
  const Counts &exact = m.check.comparison.exact_counts, &answer = m.check.comparison.float_counts;
  const bool has_faces = m.check.comparison.compared != Compared::Graph;
  const std::string faces = has_faces ? std::to_string(answer.faces) : "-";
  return fmt::format("{:<10}{:>8}{:>14}\n{:<10}{:>8}{:>14}\n{:<10}{:>8}{:>14}\n{:<10}{:>8}{:>14}\n",
                     "", "exact", m.check.answer.short_title, "vertices", exact.vertices,
                     answer.vertices, "edges", exact.edges, answer.edges, "faces", exact.faces,
                     faces);
}

std::string rows_of(const SegmentSet& drawing) {
  std::vector<SegmentD> rows;
  for (const Segment& s : drawing.segments) rows.push_back({nearest(s.a), nearest(s.b)});
  return to_lines(rows);
}

std::string exact_place(const Point& place) {
  const std::string x = exact_text(place.x), y = exact_text(place.y);
  const std::string text = fmt::format("({}, {})", x, y);
  const bool is_short = x.find('/') == std::string::npos && y.find('/') == std::string::npos &&
                        std::max(x.size(), y.size()) <= kShortDigits;
  if (is_short) return text;
  const PointD near = nearest(place);
  return fmt::format("{}, about ({}, {})", text, shortest_text(near.x), shortest_text(near.y));
}

std::string constants_text(const Minimised& m) {
  std::string text = m.is_representable
                         ? "Rounded to doubles the exact answer keeps its incidences: doubles can "
                           "hold a right answer.\n"
                         : "Rounded to doubles the exact answer has other incidences: doubles hold "
                           "no wholly right answer.\n";
  if (m.radius_before) {
    text += fmt::format(
        "The engine takes its radius from the drawing: {} here, {} in the whole drawing.\n",
        m.check.answer.radius ? short_number(*m.check.answer.radius) : "none",
        short_number(*m.radius_before));
  }
  return text;
}

std::string to_lines(const Minimised& m) {
  return m.holds_in_decimals ? rows_of(m.drawing) : to_lines(m.drawing);
}

std::string to_text(const Minimised& m) {
  if (m.outcome.outcome_class == OutcomeClass::Right) return headline(m) + version_line(m) + '\n';
  return headline(m) + how_small(m) + shown_rows(m.drawing) + count_table(m) + gravest(m) + '\n' +
         version_line(m) + '\n' + constants_text(m);
}

}  // namespace plumbline
