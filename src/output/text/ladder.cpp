// Advice for a terminal: the smallest features, the radii that are right, the first steps of the
// tolerance ladder.

#include <fmt/format.h>

#include <algorithm>

#include "output/text/ladder.hpp"
#include "output/text/terminal.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

// Longer exact texts say less than the rounded number beside them.
constexpr std::size_t kMostExactDigits = 24;

std::string at(const ExactComplex& complex, VertexId v) {
  const PointD p = nearest(complex.vertices[v]);
  return fmt::format("({}, {})", short_number(p.x), short_number(p.y));
}

std::string pair_text(const ExactComplex& complex, const LadderStep& step) {
  if (!step.edge.valid()) {
    return fmt::format("vertices {} and {}", at(complex, step.vertex),
                       at(complex, step.other_vertex));
  }
  const Edge& edge = complex.edges[step.edge];
  return fmt::format("vertex {}, edge {} - {}", at(complex, step.vertex), at(complex, edge.tail),
                     at(complex, edge.head));
}

void append_row(std::string& text, const std::string& radius, std::size_t vertices,
                std::size_t edges, std::size_t faces, const std::string& near) {
  text += fmt::format("  {:>12}{:>10}{:>10}{:>10}{}{}\n", radius, vertices, edges, faces,
                      near.empty() ? "" : "  ", near);
}

void append_right_radii(std::string& text, const RightRadii& radii) {
  if (radii.empty()) {
    text += fmt::format("  no radius is right for float LAR, of {} tried from {} to {}\n",
                        radii.tried.size(), short_number(radii.tried.front().radius),
                        short_number(radii.tried.back().radius));
    return;
  }
  const auto tried_right = std::count_if(
      radii.tried.begin(), radii.tried.end(),
      [&](const TriedRadius& t) { return t.radius >= radii.least && t.radius <= radii.largest; });
  text += fmt::format("  float LAR is right with every radius tried from {} to {} ({} tried",
                      short_number(radii.least), short_number(radii.largest), tried_right);
  for (std::size_t i = 0; i < radii.tried.size(); ++i) {
    const TriedRadius& t = radii.tried[i];
    const bool below = t.radius < radii.least && radii.tried[i + 1].radius == radii.least;
    const bool above = t.radius > radii.largest && radii.tried[i - 1].radius == radii.largest;
    if (below || above) text += fmt::format("; wrong with {}", short_number(t.radius));
  }
  text += ")\n";
}

}  // namespace

std::string distance_text(const Rational& squared) {
  const double rounded = nearest_sqrt(squared);
  const std::string nearly = rounded > 0 ? short_number(rounded) : "less than 5e-324";
  const bool is_square = mpz_perfect_square_p(squared.get_num_mpz_t()) != 0 &&
                         mpz_perfect_square_p(squared.get_den_mpz_t()) != 0;
  const Rational root = is_square ? Rational(sqrt(squared.get_num()), sqrt(squared.get_den())) : 0;
  const std::string exact =
      is_square ? exact_text(root) : fmt::format("sqrt({})", exact_text(squared));
  if (exact.size() > kMostExactDigits) return nearly;
  return exact == nearly ? exact : fmt::format("{} = {}", exact, nearly);
}

std::string to_text(const ToleranceLadder& ladder, const ExactComplex& complex, std::size_t limit) {
  std::string text = "tolerance ladder: what is no further apart than the radius counts as one\n";
  text += fmt::format("  {:>12}{:>10}{:>10}{:>10}  {}\n", "radius", "vertices", "edges", "faces",
                      "what is that near");
  append_row(text, "0", ladder.vertices, ladder.edges, ladder.faces, "");
  const std::size_t shown = std::min(ladder.steps.size(), limit);
  for (std::size_t i = 0; i < shown; ++i) {
    const LadderStep& step = ladder.steps[i];
    append_row(text, short_number(nearest_sqrt(step.squared_radius)), step.vertices, step.edges,
               step.faces, pair_text(complex, step));
  }
  if (shown < ladder.steps.size()) {
    text += fmt::format("  ... and {} more steps\n", ladder.steps.size() - shown);
  }
  if (!ladder.is_complete && shown == ladder.steps.size()) {
    text += "  ... and more beyond the last radius looked at\n";
  }
  return text;
}

std::string advice_text(const Check& check, std::size_t limit) {
  if (!check.ladder) return "";
  const ExactComplex& complex = check.exact_complex;
  std::string text = "\nadvice\n";
  if (const auto& size = check.feature_size) {
    text += fmt::format("  nearest vertices {} apart: {} and {}\n",
                        distance_text(size->squared_vertex_vertex), at(complex, size->v),
                        at(complex, size->w));
    if (size->edge.valid()) {
      text += fmt::format("  nearest vertex and edge {} apart: {} and {} - {}\n",
                          distance_text(size->squared_vertex_edge), at(complex, size->vertex),
                          at(complex, complex.edges[size->edge].tail),
                          at(complex, complex.edges[size->edge].head));
    }
  }
  if (check.right_radii) append_right_radii(text, *check.right_radii);
  return text + to_text(*check.ladder, complex, limit);
}

}  // namespace plumbline
