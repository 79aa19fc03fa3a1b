// The radii that are right and the tolerance ladder for a terminal.

#include <fmt/format.h>

#include <algorithm>

#include "output/text/ladder.hpp"
#include "output/text/terminal.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

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

}  // namespace

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

std::string right_radii_text(const RightRadii& radii, const std::string& engine) {
  if (radii.empty()) {
    std::string text = fmt::format("No radius is right for {}, of {} tried from {} to {}", engine,
                                   radii.tried.size(), short_number(radii.tried.front().radius),
                                   short_number(radii.tried.back().radius));
    const TriedRadius* best = nullptr;
    for (const TriedRadius& trial : radii.tried) {
      if (trial.findings && (!best || *trial.findings < *best->findings)) best = &trial;
    }
    if (best) {
      text += fmt::format("; {} leaves fewest, {}, besides the file's own drift",
                          shortest_text(best->radius), *best->findings);
    }
    return text + ".\n";
  }
  const auto tried_right = std::count_if(
      radii.tried.begin(), radii.tried.end(),
      [&](const TriedRadius& t) { return t.radius >= radii.least && t.radius <= radii.largest; });
  return fmt::format("{} is right with --radius {}, and with all tried from {} to {} ({}).\n",
                     engine, shortest_text(radii.advised.value_or(radii.largest)),
                     short_number(radii.least), short_number(radii.largest), tried_right);
}

}  // namespace plumbline
