// The bucket engine, step by step. Exact throughout: doubles only choose what is decided exactly.

#include "arrange/bucket/engine.hpp"

#include <utility>

#include "arrange/bucket/meet.hpp"

namespace plumbline::bucket {
namespace {

template <class Kernel>
std::vector<Approx> approximations(const Kernel& kernel, Job& job) {
  std::vector<Approx> approx(kernel.size());
  job.for_each(approx.size(),
               [&](std::size_t s) { approx[s] = kernel.approx(static_cast<LineId>(s)); });
  return approx;
}

/// The largest absolute value of a coordinate.
double reach_of(std::span<const Approx> approx) {
  double reach = 0;
  for (const Approx& l : approx) {
    reach = std::max({reach, std::abs(l.ax), std::abs(l.ay), std::abs(l.bx), std::abs(l.by)});
  }
  return reach;
}

/// Points known to within the errors of a parameter and of rounded coordinates are this close to
/// where they are computed to be, and so are the borders of buckets. With u = 2^-53 and r the
/// reach: a point a + t (b - a) is off by 2 r times the error of t, which is at most 4
/// kRelativeError, and by 8 u r for rounded ends and operations; the border of a cell, computed in
/// two ways, by 9 u r; a coordinate widened by the margin, its rounded line and the projection onto
/// a normal by 6 u r.
template <class Kernel>
double margin_of(double reach) {
  return (8 * Kernel::kRelativeError + 32 * 0x1p-53) * reach;
}

template <class Kernel>
Result arrange_lines(Kernel kernel, Job& job) {
  Result result;
  const std::size_t item_count = kernel.size();
  job.begin_step(0.05);
  Merged merged = CollinearMerge<Kernel>(kernel, job).merge();
  result.provenance = sort_lines(kernel, item_count, std::move(merged), job);
  const std::vector<Approx> approx = approximations(kernel, job);
  const double reach = reach_of(approx);
  job.begin_step(0.1);
  const Buckets buckets(approx, margin_of<Kernel>(reach), job);

  job.begin_step(0.25);
  const Scene<Kernel> scene{kernel, approx, reach, buckets};
  const std::vector<EndId> same_end = same_ends(scene, job);
  std::vector<Meetings> found = find_meetings(scene, job);
  job.begin_step(0.2);
  result.crossings = gather_crossings(found, job);
  Grouped<Hit> hits = collect_hits(kernel.size(), found, job);
  found = {};
  SortedHits sorted = sort_hits(scene, same_end, result.crossings, std::move(hits), job);
  result.chains = make_chains(sorted, job);
  result.provenance.place(result.chains.vertices);
  const UnionFind connected = connect_lines(result.crossings, same_end, sorted.hits, job);
  sorted = {};

  job.begin_step(0.2);
  Halfedges halfedges = make_halfedges(kernel, result.chains, result.crossings, job);
  result.cycles = walk_cycles(halfedges.next);
  job.begin_step(0.15);
  std::vector<Component> components =
      find_components(kernel, connected, result.chains, halfedges, result.cycles);
  const Rays<Kernel> rays(kernel, approx, buckets, result.chains, result.crossings);
  job.for_blocks(components.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) components[c].below = rays.below(components[c].least);
  });
  result.faces = make_faces(result.cycles, components);
  result.component_count = components.size();
  result.edge_line = std::move(halfedges.edge_line);
  result.next = std::move(halfedges.next);
  result.kernel = std::move(kernel);
  return result;
}

/// The narrowest that holds the input.
AnyKernel make_kernel(const SegmentSet& input, Job& job) {
  const auto grid = GridInput::from(input, job);
  if (!grid) return RationalKernel(input, job);
  if (GridKernel<std::int32_t>::fits(*grid)) return GridKernel<std::int32_t>(*grid);
  return GridKernel<std::int64_t>(*grid);
}

}  // namespace

Result arrange(const SegmentSet& input, Job& job) {
  // Each item may make a carrier and two breaks, of two ends each; crossings are counted later.
  if (input.segments.size() + input.points.size() > kMostItems / 8) throw_too_many();
  job.begin_step(0.05);
  return std::visit([&](auto kernel) { return arrange_lines(std::move(kernel), job); },
                    make_kernel(input, job));
}

}  // namespace plumbline::bucket
