// An issue text for the maintainers of an engine. It says what they can check by hand: exact
// coordinates, numbers of cells, one difference.

#include <fmt/format.h>

#include <algorithm>

#include "output/text/minimised.hpp"
#include "output/text/terminal.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kMostListed = 24;  ///< cells, findings

std::string fenced(const std::string& text, const char* language = "") {
  return fmt::format("```{}\n{}```\n\n", language, text);
}

std::string wkt(const SegmentSet& drawing) {
  std::string text;
  for (const Segment& s : drawing.segments) {
    const PointD a = nearest(s.a), b = nearest(s.b);
    text += fmt::format("{}({} {}, {} {})", text.empty() ? "" : ", ", shortest_text(a.x),
                        shortest_text(a.y), shortest_text(b.x), shortest_text(b.y));
  }
  return fmt::format("MULTILINESTRING({})\n", text);
}

/// "1/3, about 0.3333333333333333".
std::string exact_number(const Rational& value) {
  const std::string text = exact_text(value);
  const bool is_decimal = text.find('/') == std::string::npos;
  return is_decimal ? text : text + ", about " + shortest_text(nearest_double(value));
}

/// The rows, or the first of them and how many more there are.
std::string listed(const std::vector<std::string>& rows) {
  std::string text;
  for (std::size_t i = 0; i < std::min(rows.size(), kMostListed); ++i) text += rows[i] + '\n';
  if (rows.size() > kMostListed) {
    text += fmt::format("... and {} more\n", rows.size() - kMostListed);
  }
  return text;
}

/// Vertices, edges and faces by number, with exact coordinates and areas.
std::string cells(const ExactComplex& complex, bool has_faces) {
  std::vector<std::string> vertices, edges, faces;
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    vertices.push_back(fmt::format("v{} {}", v, exact_place(complex.vertices[v])));
  }
  for (const auto& [tail, head] : complex.edges) {
    edges.push_back(
        fmt::format("v{} - v{}", static_cast<std::size_t>(tail), static_cast<std::size_t>(head)));
  }
  const std::vector<Rational> areas = face_areas(complex);
  for (std::size_t f = 1; has_faces && f < complex.face_count(); ++f) {
    std::string row;
    for (const HalfedgeId h : complex.cycles[complex.face_outer[f]]) {
      row +=
          fmt::format("{}v{}", row.empty() ? "" : " ", static_cast<std::size_t>(complex.origin(h)));
    }
    if (const std::size_t holes = complex.face_holes[f].size(); holes > 0) {
      row += ", " + counted(holes, "hole");
    }
    faces.push_back(fmt::format("{}, area {}", row, exact_number(areas[f])));
  }
  std::string text = "vertices\n" + listed(vertices) + "edges\n" + listed(edges);
  if (has_faces) text += faces.empty() ? "no bounded face\n" : "bounded faces\n" + listed(faces);
  return text;
}

std::string expected(const Minimised& m) {
  std::string text =
      "## Expected\n\nThe doubles above, taken as the numbers that they are, and cut where they "
      "meet, in exact rational arithmetic (fractions are exact, \"about\" is the nearest "
      "doubles):\n\n";
  text += fenced(cells(m.check.exact_complex, true));
  return text + constants_text(m) + '\n';
}

/// "finding 2: an exact edge is missing ..., at (1, 0)"; the gravest one first.
std::string finding_rows(const Minimised& m) {
  const std::vector<Finding>& findings = m.check.comparison.findings;
  const bool is_loud = m.outcome.outcome_class == OutcomeClass::Loud;
  std::vector<std::string> rows;
  const auto add = [&](std::size_t number) {
    const Finding& finding = findings[number - 1];
    const std::string place =
        finding.kind == CellKind::Complex ? "" : ", at " + exact_place(finding.where);
    rows.push_back(fmt::format("- finding {}: {}{}", number, line_text(finding.message), place));
  };
  if (m.outcome.finding > 0) add(m.outcome.finding);
  // Without a result all cells are missing, which says nothing.
  for (std::size_t number = 1; !is_loud && number <= findings.size(); ++number) {
    if (number != m.outcome.finding) add(number);
  }
  return listed(rows) + '\n';
}

std::string comes_out(const Minimised& m) {
  const Check& check = m.check;
  std::string text = "## What comes out\n\n";
  const bool is_empty = check.answer.complex.vertices.empty();
  if (!is_empty) {
    text += "Numbers of cells, faces with the unbounded one:\n\n" + fenced(count_table(m));
  }
  text += finding_rows(m);
  if (is_empty) return text;
  const bool has_faces = check.comparison.compared != Compared::Graph;
  return text + "The answer, its doubles taken as they are:\n\n" +
         fenced(cells(exact(check.answer.complex), has_faces && check.comparison.float_valid));
}

std::string command(const Minimised& m, const IssueFiles& files) {
  std::string text = fmt::format("plumbline check {} --engine {}",
                                 files.lines.empty() ? "input.lines" : files.lines, m.engine);
  for (const auto& [name, value] : m.parameters) {
    text += fmt::format(" --set {}={}", name, value_text(value));
  }
  return text + '\n';
}

std::string pictures(const IssueFiles& files) {
  if (files.picture.empty()) return {};
  return fmt::format("![exact, and the answer beside it]({})\n\n", files.picture);
}

}  // namespace

std::string to_issue(const Minimised& m, const IssueFiles& files) {
  const std::string count = counted(m.drawing.segments.size(), "segment");
  std::string text = fmt::format("# {}: {} with {}\n\n", line_text(m.check.answer.title),
                                 line_text(m.outcome.kind), count);
  text += fmt::format("## Versions\n\n{}; reduced from {} by plumbline.\n\n", version_line(m),
                      counted(m.segments_before, "segment"));
  text += fmt::format(
      "## Input\n\n{}, in the shortest decimals that read back as the same doubles. As WKT:\n\n{}"
      "The same as rows x1,y1,x2,y2{}:\n\n{}",
      count, fenced(wkt(m.drawing), "wkt"), files.lines.empty() ? "" : " (" + files.lines + ")",
      fenced(rows_of(m.drawing)));
  text += expected(m) + comes_out(m) + pictures(files);
  text += "## How to reproduce\n\nGive the engine the WKT above, or\n\n";
  return text + fenced(command(m, files), "sh");
}

}  // namespace plumbline
