#include "ladder/near_pairs.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <tuple>

namespace plumbline {
namespace {

// More proposals at a time than this are not decided: 64 MB, and some seconds.
constexpr std::size_t kMostProposals = std::size_t{1} << 21U;
// So many times the pairs that are wanted are proposed before the farther ones are given up.
constexpr std::size_t kRoom = 4;
constexpr std::size_t kSample = 512;

/// The value below which `count` of the population are, by an evenly taken sample of it.
double quantile(std::vector<double> sample, std::size_t count, std::size_t population) {
  if (sample.empty()) return std::numeric_limits<double>::infinity();
  const std::size_t rank = std::min(count * sample.size() / population, sample.size() - 1);
  std::nth_element(sample.begin(), sample.begin() + rank, sample.end());
  return sample[rank];
}

}  // namespace

NearPairs::NearPairs(const ExactComplex& complex)
    : complex_(complex), tree_(complex), is_behind_(complex.edge_count()) {}

/// Vertices within reach that the edge may be led through, by rounded distances.
template <class Visit>
void NearPairs::for_vertices_along(EdgeId e, const double& reach, bool without_labels,
                                   const Visit& visit) const {
  tree_.visit_between(complex_.edges[e].tail, complex_.edges[e].head, reach, without_labels, visit);
}

std::vector<double> NearPairs::nearest_of_vertices() const {
  std::vector<double> sample;
  const std::size_t step = complex_.vertices.size() / kSample + 1;
  for (std::size_t v = 0; v < complex_.vertices.size(); v += step) {
    double reach = std::numeric_limits<double>::infinity();
    tree_.visit(VertexId(v), VertexId(v), reach, [&](VertexId w, double distance) {
      if (w != v) reach = distance;
    });
    sample.push_back(reach);
  }
  return sample;
}

std::vector<double> NearPairs::nearest_of_edges() const {
  std::vector<double> sample;
  const std::size_t step = complex_.edge_count() / kSample + 1;
  for (std::size_t e = 0; e < complex_.edge_count(); e += step) {
    double reach = tree_.length(complex_.edges[e].tail, complex_.edges[e].head);
    for_vertices_along(EdgeId(e), reach, false,
                       [&](VertexId, double distance) { reach = distance; });
    sample.push_back(reach);
  }
  return sample;
}

double NearPairs::radius_of(std::size_t count) const {
  const double radius = std::min(
      quantile(nearest_of_vertices(), count, complex_.vertices.size()),
      quantile(nearest_of_edges(), count, std::max<std::size_t>(complex_.edge_count(), 1)));
  return tree_.above(radius);
}

/// Makes the window end where `count` proposals are nearer, those as near as makes no difference
/// aside.
void NearPairs::narrow(Window& window, std::size_t count) const {
  std::vector<Proposal>& proposals = window.proposals;
  if (proposals.size() <= count) return;
  std::nth_element(proposals.begin(), proposals.begin() + count, proposals.end(),
                   [](const Proposal& p, const Proposal& q) { return p.distance < q.distance; });
  window.end = std::min(window.end, tree_.above(tree_.above(proposals[count].distance)));
  std::erase_if(proposals, [&](const Proposal& p) { return p.distance > tree_.above(window.end); });
  window.most = std::max(window.most, 2 * proposals.size());
}

std::optional<NearPairs::Window> NearPairs::propose(double end, std::size_t count,
                                                    const Quotient& quotient) {
  Window window{end, kRoom * count, {}};
  const double least = tree_.below(reached_);
  const auto is_small = [&] {
    if (window.proposals.size() > window.most) narrow(window, count);
    return window.proposals.size() <= kMostProposals;
  };
  for (std::size_t i = 0; i < complex_.vertices.size(); ++i) {
    const VertexId v(i);
    tree_.visit(v, v, tree_.above(window.end), quotient.cluster(v), [&](VertexId w, double d) {
      if (v < w && d >= least) {
        window.proposals.push_back({d, v, static_cast<std::uint32_t>(w), false});
      }
    });
    if (!is_small()) return std::nullopt;
  }
  for (std::size_t i = 0; i < complex_.edge_count(); ++i) {
    const EdgeId e(i);
    // What an edge is led through is nearer to it than its ends are to each other.
    const double length = tree_.above(tree_.length(complex_.edges[e].tail, complex_.edges[e].head));
    if (length < least) continue;
    const double reach = std::min(tree_.above(window.end), tree_.above(length));
    if (!quotient.is_led_through_others(e) && !is_near_others(e, reach)) {
      is_behind_[e] = true;
      continue;
    }
    propose_along(e, least, reach, window.proposals);
    if (!is_small()) return std::nullopt;
  }
  narrow(window, count);
  return window;
}

/// Whether the edge may be led through a vertex that is not merged with an end of it.
bool NearPairs::is_near_others(EdgeId e, double reach) const {
  bool is_near = false;
  for_vertices_along(e, reach, true, [&](VertexId, double) {
    is_near = true;
    reach = -std::numeric_limits<double>::infinity();  // the first one is enough
  });
  return is_near;
}

void NearPairs::propose_along(EdgeId e, double least, double most,
                              std::vector<Proposal>& proposals) const {
  for_vertices_along(e, most, false, [&](VertexId v, double distance) {
    if (distance >= least) proposals.push_back({distance, v, static_cast<std::uint32_t>(e), true});
  });
}

/// The pairs of earlier windows for edges that are behind and now led through vertices; not all
/// where they are too many.
std::vector<NearPairs::Proposal> NearPairs::left_out_before(
    const std::vector<Proposal>& proposals) {
  std::vector<Proposal> left_out;
  for (const Proposal& p : proposals) {
    if (!p.is_edge || !is_behind_[p.other]) continue;
    if (left_out.size() > kMostProposals) break;
    is_behind_[p.other] = false;
    propose_along(EdgeId(p.other), 0, tree_.above(reached_), left_out);
  }
  return left_out;
}

bool NearPairs::leads_through(EdgeId e, VertexId v) const {
  const Point& a = complex_.vertices[complex_.edges[e].tail];
  const Point& b = complex_.vertices[complex_.edges[e].head];
  const Rational squared_length = squared_distance(a, b);
  return squared_distance(a, complex_.vertices[v]) < squared_length &&
         squared_distance(complex_.vertices[v], b) < squared_length;
}

std::vector<NearPair> NearPairs::decided(const std::vector<Proposal>& proposals, double beyond,
                                         double end) const {
  const Rational first = rational_from(beyond), last = rational_from(end);
  const Rational squared_first = first * first, squared_last = last * last;
  std::vector<NearPair> pairs;
  pairs.reserve(proposals.size());
  for (const Proposal& p : proposals) {
    const Point& point = complex_.vertices[p.vertex];
    NearPair pair{0, p.vertex, {}, {}};
    if (p.is_edge) {
      pair.edge = EdgeId(p.other);
      const auto [tail, head] = complex_.edges[pair.edge];
      pair.squared_distance =
          squared_distance(point, complex_.vertices[tail], complex_.vertices[head]);
    } else {
      pair.other_vertex = VertexId(p.other);
      pair.squared_distance = squared_distance(point, complex_.vertices[pair.other_vertex]);
    }
    if (pair.squared_distance <= squared_first || pair.squared_distance > squared_last) continue;
    if (!p.is_edge || leads_through(pair.edge, p.vertex)) pairs.push_back(std::move(pair));
  }
  std::sort(pairs.begin(), pairs.end(), [](const NearPair& p, const NearPair& q) {
    const int order = cmp(p.squared_distance, q.squared_distance);
    if (order != 0) return order < 0;
    return std::tuple(p.edge.valid(), p.vertex, p.other_vertex, p.edge) <
           std::tuple(q.edge.valid(), q.vertex, q.other_vertex, q.edge);
  });
  return pairs;
}

std::optional<std::vector<NearPair>> NearPairs::next(double end, std::size_t count,
                                                     const Quotient& quotient) {
  std::vector<std::uint32_t> labels;
  labels.reserve(complex_.vertices.size());
  for (std::size_t v = 0; v < complex_.vertices.size(); ++v) {
    labels.push_back(quotient.cluster(VertexId(v)));
  }
  tree_.set_labels(labels);
  const std::optional<Window> window = propose(end, count, quotient);
  if (!window) return std::nullopt;
  const std::vector<Proposal> left_out = left_out_before(window->proposals);
  if (left_out.size() > kMostProposals) return std::nullopt;
  std::vector<NearPair> pairs = decided(left_out, 0, reached_);
  std::vector<NearPair> others = decided(window->proposals, reached_, window->end);
  std::move(others.begin(), others.end(), std::back_inserter(pairs));
  reached_ = window->end;
  return pairs;
}

}  // namespace plumbline
