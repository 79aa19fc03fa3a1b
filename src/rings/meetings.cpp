// Each time that a ring passes through a vertex, it comes along one edge and leaves along another.
// Edges that are passed twice are where rings run along each other; of the other passes, those
// through one vertex cross just if their edges alternate around it.

#include <algorithm>
#include <map>

#include "complex/direction.hpp"
#include "geometry/union_find.hpp"
#include "rings/steps.hpp"

namespace plumbline::rings {
namespace {

struct Pass {
  VertexId vertex;
  std::size_t walk;
  EdgeId in, out;

  friend bool operator<(const Pass& p, const Pass& q) {
    return std::tie(p.vertex, p.walk, p.in, p.out) < std::tie(q.vertex, q.walk, q.in, q.out);
  }
};

/// The passes through vertices that have several.
std::vector<Pass> shared_passes(const Shape& shape) {
  std::vector<Pass> passes;
  for (std::size_t w = 0; w < shape.walks.size(); ++w) {
    const Walk& walk = shape.walks[w];
    const std::size_t n = walk.edges.size();
    for (std::size_t i = walk.is_closed ? 0 : 1; i < n; ++i) {
      passes.push_back({walk.vertices[i], w, walk.edges[(i + n - 1) % n], walk.edges[i]});
    }
  }
  std::sort(passes.begin(), passes.end());
  std::vector<Pass> shared;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const auto is_same = [&](std::size_t j) { return passes[j].vertex == passes[i].vertex; };
    if ((i > 0 && is_same(i - 1)) || (i + 1 < passes.size() && is_same(i + 1))) {
      shared.push_back(passes[i]);
    }
  }
  return shared;
}

/// An edge that is passed more than once, and the first and the last walk that do.
struct SharedEdge {
  EdgeId edge;
  std::size_t walk, other;

  friend bool operator<(const SharedEdge& a, const SharedEdge& b) { return a.edge < b.edge; }
};

std::vector<SharedEdge> shared_edges(const Shape& shape) {
  std::vector<std::pair<EdgeId, std::size_t>> uses;
  for (std::size_t w = 0; w < shape.walks.size(); ++w) {
    for (const EdgeId e : shape.walks[w].edges) uses.emplace_back(e, w);
  }
  std::sort(uses.begin(), uses.end());
  std::vector<SharedEdge> shared;
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    while (end < uses.size() && uses[end].first == uses[i].first) ++end;
    if (end - i > 1) shared.push_back({uses[i].first, uses[i].second, uses[end - 1].second});
  }
  return shared;
}

/// What holds rings of a part together, so that a second way between them cuts the interior off.
class Connections {
 public:
  explicit Connections(std::size_t most) : sets_(most) {}

  /// Whether it was connected before.
  bool connect(std::size_t a, std::size_t b) {
    if (sets_.find(a) == sets_.find(b)) return true;
    sets_.unite(a, b);
    return false;
  }

 private:
  UnionFind sets_;
};

class Finder {
 public:
  explicit Finder(const Shape& shape)
      : shape_(shape),
        shared_(shared_edges(shape)),
        passes_(shared_passes(shape)),
        connections_(shape.walks.size() + shared_.size() + 2 * passes_.size()),
        next_connection_(shape.walks.size()) {}

  Meetings find() && {
    find_stretches();
    for (std::size_t i = 0, end = 0; i < passes_.size(); i = end) {
      while (end < passes_.size() && passes_[end].vertex == passes_[i].vertex) ++end;
      look_at(std::span(passes_).subspan(i, end - i));
    }
    return std::move(result_);
  }

 private:
  /// Successive edges that the same two walks share are one stretch.
  void find_stretches() {
    UnionFind sets(shared_.size());
    std::map<std::tuple<std::size_t, std::size_t, VertexId>, std::size_t> at;
    for (std::size_t i = 0; i < shared_.size(); ++i) {
      const Edge& edge = shape_.complex.edges[shared_[i].edge];
      for (const VertexId v : {edge.tail, edge.head}) {
        const auto [found, is_new] = at.try_emplace({shared_[i].walk, shared_[i].other, v}, i);
        if (!is_new) sets.unite(i, found->second);
      }
    }
    std::map<std::size_t, std::vector<EdgeId>> stretches;
    std::map<std::size_t, std::size_t> first;
    for (std::size_t i = 0; i < shared_.size(); ++i) {
      stretches[sets.find(i)].push_back(shared_[i].edge);
      first.try_emplace(sets.find(i), i);
    }
    for (const auto& [set, edges] : stretches) {
      const SharedEdge& one = shared_[first[set]];
      add_stretch(one.walk, one.other, edges);
    }
  }

  void add_stretch(std::size_t walk, std::size_t other, const std::vector<EdgeId>& edges) {
    VertexId least = shape_.complex.edges[edges.front()].tail, greatest = least;
    for (const EdgeId e : edges) {
      least = std::min(least, shape_.complex.edges[e].tail);
      greatest = std::max(greatest, shape_.complex.edges[e].head);
    }
    RingProblem& problem = add(RingFault::RunsAlong, walk, other, least, edges);
    problem.until = shape_.complex.vertices[greatest];
    if (walk == other || shape_.parts[walk] != shape_.parts[other]) return;
    const std::size_t connection = next_connection_++;
    connections_.connect(walk, connection);
    if (connections_.connect(other, connection)) {
      add(RingFault::Disconnected, walk, other, least, edges);
    }
  }

  bool is_shared(EdgeId e) const {
    return std::binary_search(shared_.begin(), shared_.end(), SharedEdge{e, 0, 0});
  }

  /// All passes through a vertex.
  void look_at(std::span<const Pass> all) {
    std::vector<Pass> passes;
    std::copy_if(all.begin(), all.end(), std::back_inserter(passes),
                 [&](const Pass& pass) { return !is_shared(pass.in) && !is_shared(pass.out); });
    if (passes.empty()) return;
    if (find_crossing(passes)) return;
    for (std::size_t i = 1; i < passes.size(); ++i) {
      if (passes[i].walk != passes[i - 1].walk) continue;
      add(RingFault::Touches, passes[i].walk, passes[i].walk, passes[i].vertex, edges_of(passes));
      break;
    }
    connect(passes);
  }

  /// Goes around the vertex: the edges of passes that do not cross are nested like parentheses.
  bool find_crossing(const std::vector<Pass>& passes) {
    struct End {
      Direction direction;
      std::size_t pass;
    };
    const ExactComplex& complex = shape_.complex;
    std::vector<End> ends;
    for (std::size_t i = 0; i < passes.size(); ++i) {
      const VertexId v = passes[i].vertex;
      for (const EdgeId e : {passes[i].in, passes[i].out}) {
        const VertexId w =
            complex.edges[e].tail == v ? complex.edges[e].head : complex.edges[e].tail;
        ends.push_back({Direction(complex.vertices[v], complex.vertices[w]), i});
      }
    }
    std::sort(ends.begin(), ends.end(),
              [](const End& a, const End& b) { return a.direction < b.direction; });
    std::vector<std::size_t> open;
    std::vector<bool> is_open(passes.size());
    for (const End& end : ends) {
      if (!is_open[end.pass]) {
        is_open[end.pass] = true;
        open.push_back(end.pass);
      } else if (open.back() == end.pass) {
        open.pop_back();
      } else {
        const auto [walk, other] = std::minmax(passes[end.pass].walk, passes[open.back()].walk);
        result_.crossing.emplace(walk, other);
        add(RingFault::Crosses, walk, other, passes[0].vertex, edges_of(passes));
        return true;
      }
    }
    return false;
  }

  /// The walks of a part that meet in a vertex: another way between them would go around something.
  void connect(const std::vector<Pass>& passes) {
    std::map<std::size_t, std::size_t> connection_of;  // by part
    for (std::size_t i = 0; i < passes.size(); ++i) {
      const std::size_t walk = passes[i].walk;
      if (i > 0 && passes[i - 1].walk == walk) continue;
      const auto [found, is_new] = connection_of.try_emplace(shape_.parts[walk], next_connection_);
      if (is_new) ++next_connection_;
      if (connections_.connect(walk, found->second)) {
        add(RingFault::Disconnected, passes[0].walk, walk, passes[0].vertex, edges_of(passes));
      }
    }
  }

  static std::vector<EdgeId> edges_of(const std::vector<Pass>& passes) {
    std::vector<EdgeId> edges;
    for (const Pass& pass : passes) edges.insert(edges.end(), {pass.in, pass.out});
    return edges;
  }

  RingProblem& add(RingFault fault, std::size_t walk, std::size_t other, VertexId v,
                   const std::vector<EdgeId>& edges) {
    // Of two rings a hole comes first, or the later part.
    const std::size_t a = shape_.walks[other].ring, b = shape_.walks[walk].ring;
    result_.problems.push_back(
        {fault, a, b, shape_.complex.vertices[v], std::nullopt, segments_of(shape_, a, b, edges)});
    return result_.problems.back();
  }

  const Shape& shape_;
  std::vector<SharedEdge> shared_;  ///< by edge
  std::vector<Pass> passes_;
  Meetings result_;
  Connections connections_;  ///< of walks, then of what they meet in
  std::size_t next_connection_;
};

}  // namespace

Meetings meetings(const Shape& shape) { return Finder(shape).find(); }

}  // namespace plumbline::rings
