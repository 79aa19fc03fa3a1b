// Loose ends that are near something and meet nothing straight ahead.

#include <algorithm>

#include "diagnose/edge_tree.hpp"
#include "diagnose/line_graph.hpp"
#include "repair/steps.hpp"
#include "repair/tips.hpp"

namespace plumbline::repair_steps {

void refuse_open_ends(Work& work, const Arranged& arranged, const Rational& reach) {
  const std::vector<Tip> tips = growing_tips(work, arranged);
  if (tips.empty()) return;
  const ExactComplex& complex = arranged.complex;
  const diagnose_steps::LineGraph graph(complex);
  const diagnose_steps::EdgeTree tree(complex.edges, graph.rounded());
  const double radius = nearest_double(reach) + 2 * graph.slack();
  for (const Tip& tip : tips) {
    const diagnose_steps::Chain chain = graph.chain(tip.vertex, graph.edges(tip.vertex).front());
    // What the loose chain belongs to is near it anyway.
    std::vector<LineId> own;
    for (const EdgeId e : chain.edges) std::ranges::copy(arranged.lines(e), back_inserter(own));
    for (const EdgeId e : graph.edges(chain.last)) {
      std::ranges::copy(arranged.lines(e), back_inserter(own));
    }
    std::optional<Rational> nearest;
    LineId beside;
    double limit = radius;
    tree.visit(graph.rounded(tip.vertex), limit, [&](EdgeId e, const auto& /*foot*/) {
      const LineId id = arranged.lines(e).front();
      if (std::ranges::find(own, id) != own.end()) return;
      Rational found = squared_distance(tip.point, complex.vertices[complex.edges[e].tail],
                                        complex.vertices[complex.edges[e].head]);
      if (found > reach * reach ||
          (nearest && std::pair(*nearest, beside) <= std::pair(found, id))) {
        return;
      }
      nearest = std::move(found);
      beside = id;
    });
    if (!nearest) continue;
    work.refuse(EditKind::Grow, tip.point, std::move(*nearest),
                "a loose end is near a line, but meets nothing straight ahead", {tip.line, beside});
  }
}

}  // namespace plumbline::repair_steps
