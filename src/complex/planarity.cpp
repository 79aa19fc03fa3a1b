// A line sweeps over the vertices from left to right (from the bottom up where x is equal) and
// keeps the edges that it meets, from the bottom up. At each vertex the edges that end there must
// be next to each other, the edges just below and above must pass strictly below and above it, and
// the edges that begin there are put in their place. Two edges that met elsewhere would be
// neighbours before they met and out of order after it, so the next vertex that touches one of
// them, or lies between them, fails its test (Shamos and Hoey, "Geometric intersection problems",
// 1976; here no crossing is computed or looked for).
//
// The order of edges around each vertex falls out, and what lies below the least vertex of each
// component. Cycles that turn clockwise at every vertex are the boundaries of the faces; the one
// that passes a component's least vertex on the left runs clockwise around it, all others run
// counter-clockwise: so neither areas nor points inside are needed.

#include "complex/planarity.hpp"

#include <algorithm>
#include <boost/intrusive/set.hpp>
#include <iterator>
#include <optional>

#include "complex/scan_line.hpp"
#include "geometry/filtered_points.hpp"

namespace plumbline {
namespace {

namespace intrusive = boost::intrusive;

/// An edge as an item of the sweep's status. It stands where it was put: items are never compared.
struct StatusEdge : intrusive::set_base_hook<intrusive::optimize_size<true>> {
  EdgeId edge;
};
/// The edges that the line meets, from the bottom up.
using Status = intrusive::set<StatusEdge, intrusive::constant_time_size<false>>;

class Certifier {
 public:
  explicit Certifier(const ExactComplex& complex)
      : c_(complex), points_(complex.vertices), status_edges_(complex.edge_count()) {}

  bool run() {
    if (!prepare()) return false;
    follow_cycles();
    for (std::size_t v = 0; v < c_.vertices.size(); ++v) {
      if (!enter(VertexId(v))) return false;
    }
    return has_right_cycles();
  }

  std::optional<std::vector<EdgesBeside>> beside_vertices() {
    if (!prepare()) return std::nullopt;
    std::vector<EdgesBeside> beside;
    beside.reserve(c_.vertices.size());
    for (std::size_t v = 0; v < c_.vertices.size(); ++v) {
      if (!reach(VertexId(v))) return std::nullopt;
      const EdgeId above = above_ == status_.end() ? EdgeId() : above_->edge;
      beside.push_back({below().value_or(EdgeId()), above});
      if (!take_beginning(VertexId(v))) return std::nullopt;
    }
    return beside;
  }

 private:
  bool prepare();
  void follow_cycles();
  bool reach(VertexId v);
  bool enter(VertexId v);
  bool take_ending(VertexId v);
  bool take_beginning(VertexId v);
  bool turns_clockwise() const;
  bool lies_in_parent(VertexId v) const;
  bool has_right_cycles() const;

  /// Where the vertex lies: 1 above the edge, -1 below it, 0 on it.
  int side(const StatusEdge& item, VertexId v) const {
    return points_.orientation(c_.edges[item.edge].tail, c_.edges[item.edge].head, v);
  }

  /// The edge just below the vertex that was reached.
  std::optional<EdgeId> below() const {
    if (above_ == status_.begin()) return std::nullopt;
    return std::prev(above_)->edge;
  }

  const ExactComplex& c_;
  const FilteredPoints points_;
  std::vector<StatusEdge> status_edges_;  ///< per edge
  Status status_;                         ///< destroyed before the edges that it links

  std::vector<std::uint32_t> ending_count_;  ///< per vertex, of the edges that end there
  std::vector<EdgeId> some_ending_;          ///< per vertex, one of them
  std::vector<HalfedgeId> next_;             ///< along cycles
  std::vector<CycleId> cycle_of_;            ///< per halfedge
  std::vector<CycleId> outline_;  ///< per component so far, the cycle around it; none for a vertex
  std::size_t next_edge_ = 0;     ///< the first one that did not begin yet

  Status::iterator above_;            ///< the first edge above the vertex
  std::vector<HalfedgeId> around_;    ///< leaving the vertex, counter-clockwise from straight down
  std::vector<HalfedgeId> leftward_;  ///< those of them that run leftwards, from the bottom up
};

bool Certifier::prepare() {
  for (std::size_t v = 1; v < c_.vertices.size(); ++v) {
    if (!points_.is_before(v - 1, v)) return false;
  }
  for (std::size_t e = 0; e < c_.edge_count(); ++e) {
    if (c_.edges[e].head <= c_.edges[e].tail) return false;
    if (e > 0 && c_.edges[e].tail < c_.edges[e - 1].tail) return false;
  }
  ending_count_.assign(c_.vertices.size(), 0);
  some_ending_.resize(c_.vertices.size());
  for (std::size_t e = 0; e < status_edges_.size(); ++e) {
    status_edges_[e].edge = EdgeId(e);
    ++ending_count_[c_.edges[e].head];
    some_ending_[c_.edges[e].head] = EdgeId(e);
  }
  return true;
}

void Certifier::follow_cycles() {
  next_.resize(2 * c_.edge_count());
  cycle_of_.resize(2 * c_.edge_count());
  for (std::size_t i = 0; i < c_.cycles.size(); ++i) {
    const auto cycle = c_.cycles[i];
    for (std::size_t k = 0; k < cycle.size(); ++k) {
      next_[cycle[k]] = cycle[k + 1 < cycle.size() ? k + 1 : 0];
      cycle_of_[cycle[k]] = CycleId(i);
    }
  }
}

/// Whether v is where the line lets it be: between two edges, and at the end of neighbours.
bool Certifier::reach(VertexId v) {
  around_.clear();
  if (!take_ending(v)) return false;
  const bool is_above_clear = above_ == status_.end() || side(*above_, v) < 0;
  const bool is_below_clear = above_ == status_.begin() || side(*std::prev(above_), v) > 0;
  return is_above_clear && is_below_clear;
}

bool Certifier::enter(VertexId v) {
  if (!reach(v)) return false;
  const bool is_least = c_.vertex_component[v] == outline_.size();  // numbered by least vertices
  if (is_least && !lies_in_parent(v)) return false;
  if (!take_beginning(v) || !turns_clockwise()) return false;
  // Left of a least vertex, a cycle comes along the lowest edge and goes on along the highest.
  if (is_least) outline_.push_back(around_.empty() ? CycleId() : cycle_of_[around_.back()]);
  return true;
}

/// Takes the edges that end at v out, if they are neighbours; finds the place of v.
bool Certifier::take_ending(VertexId v) {
  leftward_.clear();
  if (!some_ending_[v].valid()) {
    above_ = status_.lower_bound(
        v, [&](const StatusEdge& item, VertexId w) { return side(item, w) > 0; });
    return true;
  }
  const auto ends_here = [&](const StatusEdge& item) { return c_.edges[item.edge].head == v; };
  auto first = status_.iterator_to(status_edges_[some_ending_[v]]);
  while (first != status_.begin() && ends_here(*std::prev(first))) --first;
  for (above_ = first; above_ != status_.end() && ends_here(*above_);) {
    leftward_.push_back(halfedge(above_->edge, true));
    above_ = status_.erase(above_);
  }
  return leftward_.size() == ending_count_[v];
}

/// Puts the edges that begin at v into their place, if no two have the same direction.
bool Certifier::take_beginning(VertexId v) {
  for (; next_edge_ < status_edges_.size() && c_.edges[next_edge_].tail == v; ++next_edge_) {
    around_.push_back(halfedge(EdgeId(next_edge_), false));
  }
  const auto turn = [&](HalfedgeId g, HalfedgeId h) {
    return points_.orientation(v, c_.target(g), c_.target(h));
  };
  std::sort(around_.begin(), around_.end(),
            [&](HalfedgeId g, HalfedgeId h) { return turn(g, h) > 0; });
  for (std::size_t i = 0; i < around_.size(); ++i) {
    if (i > 0 && turn(around_[i - 1], around_[i]) <= 0) return false;
    status_.insert_before(above_, status_edges_[edge_of(around_[i])]);
  }
  around_.insert(around_.end(), leftward_.rbegin(), leftward_.rend());
  return true;
}

/// Whether every cycle turns from the edge on which it comes to the next one clockwise.
bool Certifier::turns_clockwise() const {
  for (std::size_t i = 0; i < around_.size(); ++i) {
    const HalfedgeId clockwise = around_[i], h = around_[i + 1 < around_.size() ? i + 1 : 0];
    if (next_[twin(h)] != clockwise) return false;
  }
  return true;
}

/// Whether the component of its least vertex v lies in the face that it is a hole of.
bool Certifier::lies_in_parent(VertexId v) const {
  return c_.component_parent[c_.vertex_component[v]] == face_above(c_, below());
}

/// Whether each component is a hole once, by the cycle around it, and all other cycles are outer
/// boundaries, each of one face.
bool Certifier::has_right_cycles() const {
  std::vector<bool> is_seen(c_.cycles.size());
  std::vector<bool> is_placed(c_.component_count());
  const auto place = [&](VertexId v) {
    const ComponentId k = c_.vertex_component[v];
    const bool is_new = !is_placed[k];
    is_placed[k] = true;
    return is_new;
  };
  const auto see = [&](CycleId cycle) {
    const bool is_new = !is_seen[cycle];
    is_seen[cycle] = true;
    return is_new;
  };
  const auto component = [&](CycleId cycle) {
    return c_.vertex_component[c_.origin(c_.cycles[cycle].front())];
  };
  for (const CycleId hole : c_.face_holes.flat()) {
    const bool is_outline = outline_[component(hole)] == hole;
    if (!is_outline || !see(hole) || !place(c_.origin(c_.cycles[hole].front()))) return false;
  }
  for (const VertexId v : c_.face_isolated_vertices.flat()) {
    if (outline_[c_.vertex_component[v]].valid() || !place(v)) return false;
  }
  for (std::size_t f = 1; f < c_.face_count(); ++f) {
    if (!see(c_.face_outer[f]) || outline_[component(c_.face_outer[f])] == c_.face_outer[f]) {
      return false;
    }
  }
  const auto is_true = [](bool b) { return b; };
  return std::all_of(is_seen.begin(), is_seen.end(), is_true) &&
         std::all_of(is_placed.begin(), is_placed.end(), is_true);
}

}  // namespace

bool is_certified(const ExactComplex& complex) { return Certifier(complex).run(); }

std::optional<std::vector<EdgesBeside>> edges_beside_vertices(const ExactComplex& complex) {
  return Certifier(complex).beside_vertices();
}

std::optional<std::vector<std::optional<EdgeId>>> edges_below_components(
    const ExactComplex& complex) {
  const auto beside = edges_beside_vertices(complex);
  if (!beside) return std::nullopt;
  std::vector<std::optional<EdgeId>> below(complex.component_count());
  for (std::size_t v = beside->size(); v-- > 0;) {
    const EdgeId e = (*beside)[v].below;
    below[complex.vertex_component[v]] = e.valid() ? std::optional(e) : std::nullopt;
  }
  return below;
}

}  // namespace plumbline
