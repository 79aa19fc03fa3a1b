// The bucket engine, step by step. Exact throughout: doubles only choose what is decided exactly.

#include "arrange/bucket/engine.hpp"

#include <utility>

#include "arrange/bucket/meet.hpp"
#include "arrange/bucket/paths.hpp"

namespace plumbline::bucket {
namespace {

template <class Kernel>
std::vector<Approx> approximations(const Kernel& kernel, Job& job) {
  std::vector<Approx> approx(kernel.size());
  job.for_each(approx.size(),
               [&](std::size_t s) { approx[s] = kernel.approx(static_cast<LineId>(s)); });
  return approx;
}

template <class Kernel>
Result arrange_lines(Kernel kernel, Job& job) {
  Result result;
  const std::size_t item_count = kernel.size();
  job.begin_step(0.05);
  Merged merged = CollinearMerge<Kernel>(kernel, job).merge();
  result.provenance = sort_lines(kernel, item_count, std::move(merged), job);
  const std::vector<Approx> approx = approximations(kernel, job);
  job.begin_step(0.1);
  const Buckets buckets(approx, Kernel::kParameterError, job);

  job.begin_step(0.25);
  const Scene<Kernel> scene{kernel, approx, buckets};
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
  look_before(kernel, approx, buckets, result.chains, halfedges, result.crossings, components, job);
  result.faces = make_faces(result.cycles, components);
  result.component_count = components.size();
  result.edge_line = std::move(halfedges.edge_line);
  result.next = std::move(halfedges.next);
  result.kernel = std::move(kernel);
  return result;
}

/// The simplest that holds the input.
AnyKernel make_kernel(const SegmentSet& input, Job& job) {
  std::optional<GridInput> grid = GridInput::from(input, job);
  if (!grid) return FilteredKernel(input, job);
  if (GridKernel::fits(*grid)) return GridKernel(*grid);
  return FilteredKernel(std::move(*grid), job);
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
