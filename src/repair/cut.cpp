#include "repair/cut.hpp"

#include <algorithm>
#include <map>

namespace plumbline::repair_steps {

void cut(Work& work, const Arranged& arranged, std::span<const EdgeId> edges, EditKind kind,
         const Point& where, const Rational& squared_size) {
  const ExactComplex& complex = arranged.complex;
  std::map<LineId, std::vector<Edge>> gone;
  for (const EdgeId e : edges) {
    const Edge edge = complex.edges[e];
    for (const LineId id : arranged.lines(e)) {
      gone[work.piece(id, complex.vertices[edge.tail], complex.vertices[edge.head])].push_back(
          edge);
    }
  }
  std::vector<LineId> before;
  std::vector<Line> after;
  for (auto& [id, parts] : gone) {
    std::ranges::sort(parts, {}, &Edge::tail);
    Line rest = work.line(id);
    for (const Edge& part : parts) {
      Line left{rest.a, complex.vertices[part.tail], rest.segments};
      if (!(left.a == left.b)) after.push_back(std::move(left));
      rest.a = complex.vertices[part.head];
    }
    if (!(rest.a == rest.b)) after.push_back(std::move(rest));
    before.push_back(id);
  }
  work.apply(kind, where, squared_size, before, std::move(after));
}

bool is_fixed(const Work& work, const Arranged& arranged, std::span<const EdgeId> edges) {
  return std::ranges::any_of(edges, [&](EdgeId e) {
    return std::ranges::any_of(
        arranged.lines(e), [&](LineId id) { return work.is_anchored(id) || work.is_virtual(id); });
  });
}

}  // namespace plumbline::repair_steps
