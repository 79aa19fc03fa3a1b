// The bucket engine, step by step. Exact throughout: doubles only choose what is decided exactly.

#include <utility>

#include "arrange/bucket/grid_kernel.hpp"
#include "arrange/bucket/nest.hpp"
#include "arrange/bucket/rational_kernel.hpp"
#include "arrange/bucket_engine.hpp"

namespace plumbline {
namespace bucket {
namespace {

template <class Kernel>
std::vector<Approx> approximations(const Kernel& kernel) {
  std::vector<Approx> approx;
  approx.reserve(kernel.size());
  for (LineId s = 0; s < kernel.size(); ++s) approx.push_back(kernel.approx(s));
  return approx;
}

double extent_of(std::span<const Approx> approx) {
  double extent = 0;
  for (const Approx& l : approx) {
    extent = std::max({extent, std::abs(l.ax), std::abs(l.ay), std::abs(l.bx), std::abs(l.by)});
  }
  return extent;
}

/// Points known to within the errors of a parameter and of rounded coordinates are this close to
/// where they are computed to be.
template <class Kernel>
double margin_of(double extent) {
  return (8 * Kernel::kRelativeError + 16 * 0x1p-53) * extent;
}

template <class Kernel>
Meetings find_meetings(const Kernel& kernel, std::span<const Approx> approx, const Ends& ends,
                       const Buckets& buckets) {
  BucketMeetings<Kernel> meetings(kernel, approx, ends.vertex, buckets);
  for (std::size_t b = 0; b < buckets.size(); ++b) meetings.find(b);
  return meetings.take();
}

/// Faces from cycles: every cycle is the outer boundary of a face, save the one around a component,
/// which is a hole of the face that the component lies in.
template <class Kernel>
void make_faces(ExactComplex& complex, const Cycles& cycles,
                const std::vector<Component>& components, const Rays<Kernel>& rays) {
  std::vector<FaceId> face_of_cycle(cycles.list.size());
  std::vector<bool> is_hole(cycles.list.size(), false);
  for (const Component& c : components) {
    if (c.hole.valid()) is_hole[c.hole] = true;
  }
  complex.face_outer.emplace_back();
  for (std::size_t c = 0; c < cycles.list.size(); ++c) {
    if (is_hole[c]) continue;
    face_of_cycle[c] = FaceId(complex.face_outer.size());
    complex.face_outer.emplace_back(c);
  }
  std::vector<std::vector<CycleId>> holes(complex.face_outer.size());
  std::vector<std::vector<VertexId>> isolated(complex.face_outer.size());
  for (const Component& c : components) {
    // Components come from left to right, so the one below has its face already.
    const auto below = rays.below(c.least);
    const FaceId face = below ? face_of_cycle[cycles.of_halfedge[*below]] : kUnbounded;
    if (c.hole.valid()) {
      face_of_cycle[c.hole] = face;
      holes[face].push_back(c.hole);
    } else {
      isolated[face].emplace_back(c.vertex);
    }
  }
  for (const auto& list : holes) complex.face_holes.push_back(list);
  for (const auto& list : isolated) complex.face_isolated_vertices.push_back(list);
}

void add_sources(ExactComplex& complex, const Graph& g, const Parents& parents,
                 std::size_t segment_count) {
  auto shared = g.shared.begin();
  std::vector<SegmentId> list;
  for (std::size_t e = 0; e < g.edges.size(); ++e) {
    list.clear();
    const auto add = [&](LineId line) {
      for (const std::uint32_t item : parents[line]) {
        if (item < segment_count) list.emplace_back(item);
      }
    };
    if (shared != g.shared.end() && shared->first == e) {
      for (; shared != g.shared.end() && shared->first == e; ++shared) add(shared->second);
    } else {
      add(g.edge_line[e]);
    }
    complex.edge_sources.push_back(list);
  }
}

template <class Kernel>
ExactComplex arrange_lines(Kernel kernel, std::size_t segment_count) {
  const Parents parents = sort_lines(kernel);
  const std::vector<Approx> approx = approximations(kernel);
  const double extent = extent_of(approx);
  const Ends ends = distinct_ends(kernel);
  const Buckets buckets(approx, margin_of<Kernel>(extent));
  const Meetings found = find_meetings(kernel, approx, ends, buckets);
  const Chains chains = make_chains(kernel, approx, extent, ends, found);
  Graph graph = make_edges(chains, approx.size(), found.overlapping);
  order_around(graph, kernel, chains.meeting.size());
  Cycles cycles = walk_cycles(graph);
  const std::vector<Component> components =
      find_components(kernel, approx, ends, chains, graph, cycles);

  ExactComplex complex;
  const Along<Kernel> along(kernel, ends, found.crossings);
  make_faces(complex, cycles, components,
             Rays<Kernel>(kernel, approx, buckets, chains, graph, along));
  add_sources(complex, graph, parents, segment_count);
  for (const MeetingId m : chains.meeting) {
    complex.vertices.push_back(along.is_end(m)
                                   ? kernel.point(along.end(m))
                                   : kernel.crossing(along.crossing(m).s, along.crossing(m).o));
  }
  complex.edges = std::move(graph.edges);
  complex.cycles = std::move(cycles.list);
  return canonical(std::move(complex));
}

}  // namespace
}  // namespace bucket

ExactComplex bucket_engine(const SegmentSet& input) {
  if (auto grid = bucket::GridKernel::from(input)) {
    return bucket::arrange_lines(std::move(*grid), input.segments.size());
  }
  return bucket::arrange_lines(bucket::RationalKernel::from(input), input.segments.size());
}

}  // namespace plumbline
