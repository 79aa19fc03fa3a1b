#pragma once

#include <map>
#include <vector>

#include "plumbline/engine.hpp"
#include "plumbline/engines/inters.hpp"

namespace plumbline::inters {

/// Per edge of a model, lesser vertex first, the input segments that it is part of, ascending.
using EdgeSources = std::map<lar::VertexPair, std::vector<SegmentId>>;

/// The input segments as the published pipeline quantises them, with what each came from.
LineWork quantised_work(const Trace& trace);

/// The sources of the edges of `trace.raw`.
EdgeSources raw_sources(const Trace& trace);
/// The sources of the edges of `trace.lar`: of all raw edges that merging puts there. Edges of one
/// vertex have theirs too.
EdgeSources lar_sources(const Trace& trace, const EdgeSources& raw);

/// The edges of the model as line work; vertices of no edge, or of edges of one vertex only, are
/// points.
LineWork work_of(const Model& model, const EdgeSources& sources);

/// Whether the pipeline got as far as this result; if not, all there is is `trace.lar`.
bool has_result(const Trace& trace, Result result);

/// The edges that go into the faces of this result, as it has them; none of a component where there
/// is none.
LineWork kept_work(const Trace& trace, Result result, const EdgeSources& sources);

/// The result as a complex, right or wrong, edges with their sources; where it fails the vertices
/// and edges of `trace.lar`, without faces. In canonical order.
FloatComplex result_complex(const Trace& trace, Result result, const EdgeSources& sources);

}  // namespace plumbline::inters
