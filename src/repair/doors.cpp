// Openings of the walls, closed by virtual lines, but for those that would have the same face on
// both sides.

#include <algorithm>

#include "diagnose/steps.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/geometry/layers.hpp"
#include "repair/steps.hpp"

namespace plumbline::repair_steps {
namespace {

/// What closes an opening: a line, or the two sides of a wall.
struct Closing {
  Point where;
  Rational squared_width;
  std::vector<Line> lines;  ///< virtual
};

std::vector<Closing> closings_of(const ExactComplex& walls, const Range& doors) {
  const diagnose_steps::LineGraph graph(walls);
  std::vector<VertexId> loose_ends;
  for (std::size_t v = 0; v < walls.vertices.size(); ++v) {
    if (graph.is_tip(VertexId(v))) loose_ends.emplace_back(v);
  }
  std::vector<Closing> result;
  for (const Opening& opening : diagnose_steps::openings(graph, loose_ends, doors)) {
    Closing closing{opening.where, opening.squared_width, {}};
    for (const Edge& across : opening.across) {
      closing.lines.push_back({walls.vertices[across.tail], walls.vertices[across.head], {}});
    }
    result.push_back(std::move(closing));
  }
  std::ranges::sort(result, [](const Closing& c, const Closing& d) { return c.where < d.where; });
  return result;
}

/// Whether each closing parts two faces. Its lines are the last segments of the arrangement.
std::vector<char> parting(const ExactComplex& complex, std::size_t first_line,
                          const std::vector<Closing>& closings) {
  std::vector<std::size_t> closing_of;
  for (std::size_t i = 0; i < closings.size(); ++i) {
    closing_of.insert(closing_of.end(), closings[i].lines.size(), i);
  }
  // Faces on the sides of its lines; with two lines the one between them is on both.
  std::vector<std::vector<FaceId>> sides(closings.size());
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const SegmentId last = complex.edge_sources[e].back();
    if (last < first_line) continue;
    for (const bool reversed : {false, true}) {
      sides[closing_of[last - first_line]].push_back(
          complex.halfedge_face[halfedge(EdgeId(e), reversed)]);
    }
  }
  std::vector<char> result;
  for (std::size_t i = 0; i < closings.size(); ++i) {
    std::ranges::sort(sides[i]);
    sides[i].erase(std::unique(sides[i].begin(), sides[i].end()), sides[i].end());
    result.push_back(sides[i].size() > closings[i].lines.size() ? 1 : 0);
  }
  return result;
}

}  // namespace

void close_doors(Work& work, const Range& doors, const std::vector<std::string>& wall_layers) {
  std::vector<LineId> lines = work.lines();
  if (!wall_layers.empty()) {
    const std::vector<bool> is_wall = sources_on_layers(work.input(), wall_layers);
    std::erase_if(lines, [&](LineId id) {
      // Lines that closed openings before are part of the walls.
      return !work.is_virtual(id) && !is_wall[work.source(id)];
    });
  }
  SegmentSet walls = work.drawing(lines);
  const std::vector<Closing> closings = closings_of(arrange(walls), doors);
  if (closings.empty()) return;
  const std::size_t first_line = walls.segments.size();
  const SourceId source = walls.add_source({});
  for (const Closing& closing : closings) {
    for (const Line& line : closing.lines) walls.add(Segment{line.a, line.b}, source);
  }
  const std::vector<char> is_parting = parting(arrange(walls), first_line, closings);
  for (std::size_t i = 0; i < closings.size(); ++i) {
    if (is_parting[i] == 0) continue;
    work.apply(EditKind::Door, closings[i].where, closings[i].squared_width, {}, closings[i].lines);
  }
}

}  // namespace plumbline::repair_steps
