#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <optional>
#include <thread>
#include <utility>

#include "arrange/bucket/engine.hpp"
#include "arrange/within_limit.hpp"
#include "plumbline/arrange.hpp"

namespace plumbline {

struct Arrangement::Implementation : bucket::Result {
  std::size_t threads = 1;
};

namespace {

/// Calls work(), whose parallel loops then use that many threads.
template <class Work>
auto on_threads(std::size_t threads, Work work) {
  if (threads == 1) return work();
  // Without this, TBB warns and starts no more threads than there are cores.
  std::optional<tbb::global_control> more;
  if (threads > static_cast<std::size_t>(tbb::info::default_concurrency())) {
    more.emplace(tbb::global_control::max_allowed_parallelism, threads);
  }
  return tbb::task_arena(static_cast<int>(threads)).execute(work);
}

}  // namespace

Arrangement::Arrangement(const SegmentSet& input, const ArrangeOptions& options)
    : implementation_(std::make_unique<Implementation>()) {
  ensure_within_limit(input);
  constexpr std::size_t kMostThreads = 1024;
  // Only where it is needed: asking for the number of cores opens a file.
  const std::size_t asked =
      options.threads == 0 ? std::thread::hardware_concurrency() : options.threads;
  const std::size_t threads = std::clamp(asked, std::size_t{1}, kMostThreads);
  bucket::Job job(threads, options.progress);
  static_cast<bucket::Result&>(*implementation_) =
      on_threads(threads, [&] { return bucket::arrange(input, job); });
  implementation_->threads = threads;
}

Arrangement::Arrangement(Arrangement&&) noexcept = default;
Arrangement& Arrangement::operator=(Arrangement&&) noexcept = default;
Arrangement::~Arrangement() = default;

std::size_t Arrangement::vertex_count() const { return implementation_->chains.meeting.size(); }
std::size_t Arrangement::edge_count() const { return implementation_->edge_line.size(); }
std::size_t Arrangement::face_count() const { return implementation_->faces.outer.size(); }
std::size_t Arrangement::component_count() const { return implementation_->component_count; }
std::size_t Arrangement::cycle_count() const { return implementation_->cycles.first.size(); }

Edge Arrangement::edge(EdgeId e) const {
  return bucket::edge_at(implementation_->chains, implementation_->edge_line[e], e);
}
HalfedgeId Arrangement::next(HalfedgeId h) const { return implementation_->next[h]; }
CycleId Arrangement::cycle(HalfedgeId h) const { return implementation_->cycles.of_halfedge[h]; }
HalfedgeId Arrangement::first_halfedge(CycleId c) const { return implementation_->cycles.first[c]; }
FaceId Arrangement::face(CycleId c) const { return implementation_->faces.of_cycle[c]; }
CycleId Arrangement::outer_boundary(FaceId f) const { return implementation_->faces.outer[f]; }
std::span<const CycleId> Arrangement::holes(FaceId f) const {
  return implementation_->faces.holes[f];
}
std::span<const VertexId> Arrangement::isolated_vertices(FaceId f) const {
  return implementation_->faces.isolated_vertices[f];
}

std::vector<SegmentId> Arrangement::sources(EdgeId e) const {
  std::vector<SegmentId> result;
  const bucket::LineId line = implementation_->edge_line[e];
  const std::size_t position =
      static_cast<std::size_t>(e) - bucket::first_edge(implementation_->chains, line);
  implementation_->provenance.for_items(line, position,
                                        [&](std::uint32_t item) { result.emplace_back(item); });
  std::sort(result.begin(), result.end());
  return result;
}

Point Arrangement::point(VertexId v) const {
  const bucket::MeetingId m = implementation_->chains.meeting[v];
  return std::visit(
      [&](const auto& kernel) {
        if (m < 2 * kernel.size()) return kernel.point(m);
        const bucket::Crossing& c = implementation_->crossings[m - 2 * kernel.size()];
        return kernel.crossing(c.s, c.o);
      },
      implementation_->kernel);
}

PointD Arrangement::nearest(VertexId v) const { return plumbline::nearest(point(v)); }

ExactComplex Arrangement::complex() const {
  ExactComplex complex;
  complex.vertices.resize(vertex_count());
  bucket::Job job(implementation_->threads, {});
  on_threads(implementation_->threads, [&] {
    job.for_each(vertex_count(), [&](std::size_t v) { complex.vertices[v] = point(VertexId(v)); });
  });
  complex.edges.reserve(edge_count());
  for (std::size_t e = 0; e < edge_count(); ++e) {
    complex.edges.push_back(edge(EdgeId(e)));
    complex.edge_sources.push_back(sources(EdgeId(e)));
  }
  std::vector<HalfedgeId> walk;
  for (std::size_t c = 0; c < cycle_count(); ++c) {
    walk.clear();
    const HalfedgeId first = first_halfedge(CycleId(c));
    HalfedgeId h = first;
    do {
      walk.push_back(h);
      h = next(h);
    } while (h != first);
    complex.cycles.push_back(walk);
  }
  for (std::size_t f = 0; f < face_count(); ++f) {
    complex.face_outer.push_back(outer_boundary(FaceId(f)));
    complex.face_holes.push_back(holes(FaceId(f)));
    complex.face_isolated_vertices.push_back(isolated_vertices(FaceId(f)));
  }
  return canonical(std::move(complex));
}

}  // namespace plumbline
