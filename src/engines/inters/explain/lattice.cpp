// Compares every entry of the lattice with where the cycle's vertices lie.

#include "engines/inters/explain/lattice.hpp"

#include <algorithm>
#include <optional>

#include "plumbline/engines/inters_stages.hpp"
#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::inters {
namespace {

using lar::Position;
using Fault = Lattice::Fault;

int entry(Position position) {
  return position == Position::In ? 1 : position == Position::On ? -1 : 0;
}
int entry(Classification where) {
  return where == Classification::In ? 1 : where == Classification::On ? -1 : 0;
}

std::vector<PointD> corners(const Trace& trace, std::size_t component) {
  std::vector<PointD> result;
  for (const VertexId v : ring(trace.components[component])) {
    result.push_back(trace.lar.vertices[v]);
  }
  return result;
}

/// Of cycle h in polygon k.
std::optional<Fault> fault(const Trace& trace, std::size_t k, std::size_t h) {
  const Vcode vcode(trace.options.decimals);
  const int found = (*trace.lattice)[k][h];
  const PointD& looked_at = trace.lar.vertices[trace.components[h].front()[0]];
  const std::vector<PointD> polygon = corners(trace, k);
  const int right = entry(lar::classify_points(polygon, {&looked_at, 1}).front());
  if (found == right) return right == -1 ? std::optional(Fault::OnBoundary) : std::nullopt;
  if (right == -1) return Fault::Unrounded;
  const auto polylines = boundary_polylines(trace.lar.vertices, trace.components[k], vcode);
  const std::vector<PointD> cycle = corners(trace, h);
  const std::vector<Position> positions = lar::classify_points(polygon, cycle);
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    if (entry(classify(polylines, cycle[i])) == entry(positions[i])) return Fault::OneVertex;
  }
  return Fault::Crossings;
}

}  // namespace

std::vector<VertexId> ring(std::span<const lar::VertexPair> cycle) {
  std::map<VertexId, std::vector<VertexId>> neighbours;
  for (const auto& [v, w] : cycle) {
    neighbours[v].push_back(w);
    neighbours[w].push_back(v);
  }
  const VertexId start = cycle.front()[0];
  std::vector<VertexId> result{start};
  VertexId before = start;
  for (VertexId v = cycle.front()[1]; v != start && result.size() < cycle.size();) {
    result.push_back(v);
    const std::vector<VertexId>& next = neighbours.at(v);
    const VertexId after = next.front() == before ? next.back() : next.front();
    before = v;
    v = after;
  }
  return result;
}

Lattice::Lattice(const Trace& trace, Result result, const EdgeSources& sources) {
  if (result != Result::CellsFromCycles || !trace.lattice) return;
  const std::size_t n = trace.components.size();
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t h = 0; h < n; ++h) {
      if (h == k) continue;
      if (const auto wrong = fault(trace, k, h)) {
        faults_.emplace(k, *wrong);
        faults_.emplace(h, *wrong);
      }
    }
    for (const lar::VertexPair& edge : trace.components[k]) {
      for (const SegmentId s :
           sources.at({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])})) {
        components_of_.emplace(s, k);
      }
    }
  }
}

Fault Lattice::fault_at(std::span<const SegmentId> segments) const {
  for (const SegmentId s : segments) {
    const auto [begin, end] = components_of_.equal_range(s);
    for (auto it = begin; it != end; ++it) {
      if (const auto found = faults_.find(it->second); found != faults_.end()) return found->second;
    }
  }
  return Fault::Alternates;
}

}  // namespace plumbline::inters
