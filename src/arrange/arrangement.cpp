#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <optional>
#include <thread>
#include <utility>

#include "arrange/bucket/engine.hpp"
#include "arrange/within_limit.hpp"
#include "geometry/stored.hpp"
#include "plumbline/arrange.hpp"

namespace plumbline {

struct Arrangement::Implementation : bucket::Result {
  std::size_t threads = 1;

  /// Calls visit(segment) for the input segments that cover edge e.
  template <class Visit>
  void for_sources(EdgeId e, Visit visit) const {
    const bucket::LineId line = edge_line[e];
    const std::size_t position = static_cast<std::size_t>(e) - bucket::first_edge(chains, line);
    provenance.for_items(line, position, [&](std::uint32_t item) { visit(SegmentId(item)); });
  }
};

namespace {

/// Calls work(), whose parallel loops then use that many threads.
template <class Work>
auto on_threads(std::size_t threads, Work work) {
  const auto usual = static_cast<std::size_t>(tbb::info::default_concurrency());
  // Arenas of its own for each of many calls slow TBB down, more with each one.
  if (threads == 1 || threads == usual) return work();
  // Without this, TBB warns and starts no more threads than there are cores.
  std::optional<tbb::global_control> more;
  if (threads > usual) {
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
  implementation_->for_sources(e, [&](SegmentId s) { result.push_back(s); });
  std::sort(result.begin(), result.end());
  return result;
}

Point Arrangement::point(VertexId v) const {
  const bucket::MeetingId m = implementation_->chains.meeting[v];
  return std::visit(
      [&](const auto& kernel) {
        if (m < 2 * kernel.size()) return lowest(kernel.point(m));
        const bucket::Crossing& c = implementation_->crossings[m - 2 * kernel.size()];
        return lowest(kernel.crossing(c.s, c.o));
      },
      implementation_->kernel);
}

PointD Arrangement::nearest(VertexId v) const { return plumbline::nearest(point(v)); }

namespace {

/// Per vertex make(m) for the meeting that it is.
template <class Make>
auto at_vertices(const bucket::Result& result, bucket::Job& job, Make make) {
  std::vector<decltype(make(bucket::MeetingId{}))> points(result.chains.meeting.size());
  job.for_each(points.size(), [&](std::size_t v) { points[v] = make(result.chains.meeting[v]); });
  return points;
}

/// The points of the vertices: in machine integers where that holds all of them.
template <class Kernel>
PointList points(const Kernel& kernel, const bucket::Result& result, bucket::Job& job) {
  const auto of_meeting = [&](bucket::MeetingId m, auto point, auto crossing) {
    if (m < 2 * kernel.size()) return point(m);
    const bucket::Crossing& c = result.crossings[m - 2 * kernel.size()];
    return crossing(c.s, c.o);
  };
  if constexpr (requires { kernel.has_wide_points(); }) {
    if (kernel.has_wide_points()) {
      return PointList(at_vertices(result, job, [&](bucket::MeetingId m) {
        return of_meeting(
            m, [&](auto end) { return kernel.wide_point(end); },
            [&](auto s, auto o) { return kernel.wide_crossing(s, o); });
      }));
    }
  }
  return PointList(at_vertices(result, job, [&](bucket::MeetingId m) {
    return of_meeting(
        m, [&](auto end) { return kernel.point(end); },
        [&](auto s, auto o) { return kernel.crossing(s, o); });
  }));
}

}  // namespace

ExactComplex Arrangement::complex() const {
  ExactComplex complex;
  bucket::Job job(implementation_->threads, {});
  complex.vertices = on_threads(implementation_->threads, [&] {
    return std::visit([&](const auto& kernel) { return points(kernel, *implementation_, job); },
                      implementation_->kernel);
  });
  complex.edges.reserve(edge_count());
  complex.edge_sources.reserve(edge_count(), edge_count());
  std::vector<SegmentId> covering;
  for (std::size_t e = 0; e < edge_count(); ++e) {
    complex.edges.push_back(edge(EdgeId(e)));
    covering.clear();
    implementation_->for_sources(EdgeId(e), [&](SegmentId s) { covering.push_back(s); });
    complex.edge_sources.push_back(covering);
  }
  complex.cycles.reserve(cycle_count(), 2 * edge_count());
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
