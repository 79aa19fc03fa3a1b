// Which input segments are behind the cells of the published pipeline: the original does not say,
// so its steps are followed once more.

#include "engines/inters/explain/work.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>

#include "engines/inters/explain/lattice.hpp"
#include "plumbline/engine/cell_lists.hpp"
#include "plumbline/engines/inters_stages.hpp"

namespace plumbline::inters {
namespace {

using lar::VertexPair;

VertexPair sorted(const VertexPair& pair) {
  return {std::min(pair[0], pair[1]), std::max(pair[0], pair[1])};
}

void merge(std::vector<SegmentId>& sources, std::span<const SegmentId> more) {
  sources.insert(sources.end(), more.begin(), more.end());
  std::sort(sources.begin(), sources.end());
  sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
}

/// The edges of `trace.lar` that go into the faces of this result, not of CellsFromCycles; none
/// where it fails.
std::vector<VertexPair> kept_edges(const Trace& trace, Result result) {
  std::set<VertexPair> kept;
  if (trace.components.empty()) return {};
  if (result == Result::LarFromLines) {
    // The first of those with most edges.
    const auto largest =
        std::max_element(trace.components.begin(), trace.components.end(),
                         [](const auto& a, const auto& b) { return a.size() < b.size(); });
    for (const VertexPair& edge : *largest) kept.insert(sorted(edge));
  } else {
    for (const auto& component : trace.components) {
      for (const VertexPair& edge : component) kept.insert(sorted(edge));
    }
  }
  return {kept.begin(), kept.end()};
}

std::vector<Polygon> cells_as_polygons(const Trace& trace) {
  std::vector<Polygon> result;
  for (const std::vector<std::size_t>& cell : *trace.cells) {
    Polygon polygon;
    polygon.outer = ring(trace.components[cell.front()]);
    for (std::size_t i = 1; i < cell.size(); ++i) {
      polygon.holes.push_back(ring(trace.components[cell[i]]));
    }
    result.push_back(std::move(polygon));
  }
  return result;
}

std::vector<Polygon> as_polygons(const Lists<VertexId>& faces, std::span<const std::size_t> these) {
  std::vector<Polygon> result;
  for (const std::size_t f : these) result.push_back({{faces[f].begin(), faces[f].end()}, {}});
  return result;
}

CellLists cell_lists(const Trace& trace, Result result) {
  CellLists lists;
  lists.lists_all_edges = true;
  const auto take = [&](const Model& model) {
    lists.vertices = model.vertices;
    lists.edges = model.edges;
  };
  if (!has_result(trace, result)) {
    take(trace.lar);
  } else if (result == Result::LarFromLines) {
    take(*trace.lar_from_lines);
    std::vector<std::size_t> all(trace.lar_from_lines->faces.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    lists.faces = as_polygons(trace.lar_from_lines->faces, all);
  } else if (result == Result::AllComponents) {
    take(trace.all_components->faces.model);
    lists.faces =
        as_polygons(trace.all_components->faces.model.faces, trace.all_components->interior);
  } else {
    take(trace.lar);
    lists.faces = cells_as_polygons(trace);
  }
  return lists;
}

}  // namespace

LineWork quantised_work(const Trace& trace) {
  const Vcode vcode(trace.options.decimals);
  LineWork result;
  for (std::size_t i = 0; i < trace.lines.size(); ++i) {
    result.segments.push_back(vcode.quantised(trace.lines[i]));
    result.sources.push_back(std::array{SegmentId(i)});
  }
  return result;
}

EdgeSources raw_sources(const Trace& trace) {
  const Vcode vcode(trace.options.decimals);
  std::map<std::pair<PointD, PointD>, std::vector<SegmentId>> segments_of;
  for (std::size_t i = 0; i < trace.lines.size(); ++i) {
    const auto [a, b] = vcode.quantised(trace.lines[i]);
    segments_of[{a, b}].emplace_back(i);
  }
  std::map<PointD, VertexId> vertex_at;
  for (std::size_t v = 0; v < trace.raw.vertices.size(); ++v) {
    vertex_at[trace.raw.vertices[v]] = VertexId(v);
  }
  EdgeSources result;
  for (const Fragment& fragment : trace.fragments) {
    const auto& sources = segments_of[{fragment.segment.a, fragment.segment.b}];
    const Model pieces = split({&fragment, 1}, vcode).model;
    for (const auto& [v, w] : pieces.edges) {
      merge(result[sorted({vertex_at.at(pieces.vertices[v]), vertex_at.at(pieces.vertices[w])})],
            sources);
    }
  }
  return result;
}

EdgeSources lar_sources(const Trace& trace, const EdgeSources& raw) {
  EdgeSources result;
  for (const auto& [edge, sources] : raw) {
    merge(result[sorted({trace.prune.vertex_map[edge[0]], trace.prune.vertex_map[edge[1]]})],
          sources);
  }
  return result;
}

LineWork work_of(const Model& model, const EdgeSources& sources) {
  LineWork result;
  std::vector<bool> is_used(model.vertices.size());
  for (const VertexPair& edge : model.edges) {
    if (edge[0] != edge[1]) is_used[edge[0]] = is_used[edge[1]] = true;
    result.segments.push_back({model.vertices[edge[0]], model.vertices[edge[1]]});
    result.sources.push_back(sources.at(sorted(edge)));
  }
  for (std::size_t v = 0; v < is_used.size(); ++v) {
    if (!is_used[v]) result.points.push_back(model.vertices[v]);
  }
  return result;
}

bool has_result(const Trace& trace, Result result) {
  switch (result) {
    case Result::LarFromLines:
      return trace.lar_from_lines.has_value();
    case Result::AllComponents:
      return trace.all_components.has_value();
    case Result::CellsFromCycles:
      return trace.cells.has_value();
  }
  return false;
}

LineWork kept_work(const Trace& trace, Result result, const EdgeSources& sources) {
  if (result == Result::CellsFromCycles) return work_of(trace.lar, sources);
  const Vcode vcode(trace.options.decimals);
  LineWork work;
  for (const VertexPair& edge : kept_edges(trace, result)) {
    work.segments.push_back(
        vcode.quantised(SegmentD{trace.lar.vertices[edge[0]], trace.lar.vertices[edge[1]]}));
    work.sources.push_back(sources.at(edge));
  }
  return work;
}

FloatComplex result_complex(const Trace& trace, Result result, const EdgeSources& sources) {
  FloatComplex complex = complex_from_faces(cell_lists(trace, result));
  const LineWork work =
      has_result(trace, result) ? kept_work(trace, result, sources) : work_of(trace.lar, sources);
  std::map<std::pair<PointD, PointD>, std::vector<SegmentId>> sources_of;
  for (std::size_t i = 0; i < work.segments.size(); ++i) {
    const auto& [a, b] = work.segments[i];
    merge(sources_of[std::minmax(a, b)], work.sources[i]);
  }
  Lists<SegmentId> edge_sources;
  for (const Edge& edge : complex.edges) {
    edge_sources.push_back(
        sources_of[std::minmax(complex.vertices[edge.tail], complex.vertices[edge.head])]);
  }
  complex.edge_sources = std::move(edge_sources);
  return complex;
}

}  // namespace plumbline::inters
