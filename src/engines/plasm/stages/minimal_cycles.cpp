// TGW in the plane: the boundary of a face grows from one edge, at all its loose ends at once, by
// the edge next in angle, until it has no end.

#include <algorithm>
#include <cmath>
#include <map>

#include "plumbline/engines/plasm_stages.hpp"

namespace plumbline::plasm {
namespace {

int sign_at(const Graph& graph, EdgeId e, VertexId v) { return graph.edges[e][0] == v ? -1 : 1; }

class Growth {
 public:
  Growth(const Graph& graph, std::span<const EdgeId> edges) : graph_(graph), edges_(edges) {
    for (const EdgeId e : edges) {
      for (const VertexId v : graph.edges[e]) around_[v].push_back(e);
    }
    for (auto& [v, list] : around_) sort_by_angle(v, list);
  }

  std::vector<Chain> all() {
    std::vector<Chain> faces;
    for (EdgeId seed = next_seed(); seed.valid(); seed = next_seed()) {
      const auto used = last_sign_.find(seed);
      faces.push_back(grown(seed, used == last_sign_.end() ? 1 : -used->second));
    }
    return faces;
  }

 private:
  void sort_by_angle(VertexId v, std::vector<EdgeId>& list) const {
    std::vector<std::pair<double, EdgeId>> by_angle;
    for (const EdgeId e : list) {
      const auto [a, b] = graph_.edges[e];
      const PointD& p = graph_.vertices[v];
      const PointD& q = graph_.vertices[a == v ? b : a];
      by_angle.push_back({std::atan2(q.y - p.y, q.x - p.x), e});
    }
    std::stable_sort(by_angle.begin(), by_angle.end(),
                     [](const auto& s, const auto& t) { return s.first < t.first; });
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = by_angle[i].second;
  }

  /// The first edge in no face, else the first in one face only.
  EdgeId next_seed() {
    while (first_unused_ < edges_.size() && faces_of(edges_[first_unused_]) > 0) ++first_unused_;
    if (first_unused_ < edges_.size()) return edges_[first_unused_];
    while (first_half_ < edges_.size() && faces_of(edges_[first_half_]) > 1) ++first_half_;
    return first_half_ < edges_.size() ? edges_[first_half_] : EdgeId();
  }

  int faces_of(EdgeId e) const {
    const auto found = faces_of_.find(e);
    return found == faces_of_.end() ? 0 : found->second;
  }

  EdgeId beside(VertexId v, EdgeId pivot, bool next) const {
    const std::vector<EdgeId>& list = around_.at(v);
    const auto found = std::find(list.begin(), list.end(), pivot);
    const std::size_t n = list.size();
    auto at = static_cast<std::size_t>(found - list.begin());
    do {
      at = next ? (at + 1) % n : (at + n - 1) % n;
    } while (faces_of(list[at]) > 1);
    return list[at];
  }

  EdgeId pivot(VertexId v, const std::map<EdgeId, int>& chain) const {
    EdgeId least;
    for (const EdgeId e : around_.at(v)) {
      if (chain.contains(e) && (!least.valid() || e < least)) least = e;
    }
    return least;
  }

  Chain grown(EdgeId seed, int sign) {
    std::map<EdgeId, int> chain;
    std::map<VertexId, int> ends;
    const auto add = [&](EdgeId e, int s) {
      if ((chain[e] += s) == 0) chain.erase(e);
      for (const VertexId v : graph_.edges[e]) {
        if ((ends[v] += s * sign_at(graph_, e, v)) == 0) ends.erase(v);
      }
    };
    add(seed, sign);
    // A simple cycle needs half as many steps as it has edges.
    for (std::size_t left = 8 * edges_.size() + 64; !ends.empty(); --left) {
      std::map<EdgeId, int> corolla;
      for (const auto& [v, end] : ends) {
        const EdgeId from = pivot(v, chain);
        if (left == 0 || !from.valid()) break;
        const EdgeId to = beside(v, from, end < 0);
        const bool both_lead_there = sign_at(graph_, from, v) == sign_at(graph_, to, v);
        corolla[to] = both_lead_there ? -chain[from] : chain[from];
      }
      if (corolla.empty()) break;
      for (const auto& [e, s] : corolla) add(e, s);
    }
    if (!ends.empty() || chain.empty()) {
      throw Failure{Failure::Kind::EndlessWalk,
                    "minimal_2d_cycles runs for ever: a boundary that grew from an edge does not "
                    "close"};
    }
    Chain result;
    for (const auto& [e, s] : chain) {
      ++faces_of_[e];
      last_sign_[e] = s;
      result.push_back({e, s});
    }
    return result;
  }

  const Graph& graph_;
  const std::span<const EdgeId> edges_;
  std::map<VertexId, std::vector<EdgeId>> around_;  ///< by angle from -pi
  std::map<EdgeId, int> faces_of_, last_sign_;
  std::size_t first_unused_ = 0, first_half_ = 0;
};

}  // namespace

std::vector<Chain> minimal_cycles(const Graph& graph, std::span<const EdgeId> edges) {
  return Growth(graph, edges).all();
}

}  // namespace plumbline::plasm
