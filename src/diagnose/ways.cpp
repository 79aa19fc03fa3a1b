#include "diagnose/ways.hpp"

#include <cmath>

#include "geometry/point_d.hpp"

namespace plumbline::diagnose_steps {

void Ways::find_within(double longest) {
  while (!is_thicket_ && !queue_.empty() && queue_.top().first <= longest) {
    const auto [length, v] = queue_.top();
    queue_.pop();
    if (!lengths_.emplace(v, length).second) continue;
    is_thicket_ = lengths_.size() + graph_.degree(v) > kMostVertices;
    if (is_thicket_) return;
    for (const EdgeId e : graph_.edges(v)) {
      const VertexId next = graph_.other_end(e, v);
      if (!lengths_.contains(next)) queue_.emplace(length + graph_.approx_length(e), next);
    }
  }
}

bool Ways::lead_to(EdgeId e, const PointD& p, double longest) {
  find_within(longest);
  if (is_thicket_) return true;
  const auto leads = [&](VertexId end) {
    const auto found = lengths_.find(end);
    if (found == lengths_.end()) return false;
    return found->second + distance(graph_.rounded(end), p) <= longest;
  };
  const Edge& edge = graph_.complex().edges[e];
  return leads(edge.tail) || leads(edge.head);
}

}  // namespace plumbline::diagnose_steps
