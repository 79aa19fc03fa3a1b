#include "check/without_drift.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "compare/wrong_cells.hpp"
#include "plumbline/arrange.hpp"

namespace plumbline::check_steps {
namespace {

class Straightening {
 public:
  Straightening(const SegmentSet& input, const ExactComplex& complex, const Drift& drift)
      : input_(input), complex_(complex), drift_(drift), is_kept_(complex.vertices.size()) {
    find_kept();
    find_ways();
  }

  ExactComplex arranged(std::size_t threads) && {
    for (std::size_t s = 0; s < input_.segments.size(); ++s) {
      const auto way = ways_.find(s);
      if (way == ways_.end()) {
        const Segment segment = input_.segments[s];
        add(segment.a, segment.b, SegmentId(s));
      } else {
        add(way->second, SegmentId(s));
      }
    }
    result_.points = input_.points;
    ArrangeOptions options;
    options.threads = threads;
    ExactComplex complex = arrange(result_, ExactEngine::Bucket, options);
    Lists<SegmentId> sources;
    for (std::size_t e = 0; e < complex.edge_count(); ++e) {
      std::vector<SegmentId> list;
      for (const SegmentId piece : complex.edge_sources[e]) list.push_back(origins_[piece]);
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      sources.push_back(list);
    }
    complex.edge_sources = std::move(sources);
    return complex;
  }

 private:
  VertexId place(VertexId v) const { return drift_.stands_for[v]; }

  /// What stays a vertex of each segment that it is on: ends of segments, and all of a place.
  void find_kept() {
    std::vector<VertexId> low(input_.segments.size()), high(input_.segments.size());
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      const auto [tail, head] = complex_.edges[e];
      for (const SegmentId s : complex_.edge_sources[e]) {
        low[s] = low[s].valid() ? std::min(low[s], tail) : tail;
        high[s] = high[s].valid() ? std::max(high[s], head) : head;
      }
    }
    for (const auto& ends : {low, high}) {
      for (const VertexId v : ends) is_kept_[v] = true;
    }
    for (std::size_t v = 0; v < is_kept_.size(); ++v) {
      if (place(VertexId(v)) != v) is_kept_[v] = is_kept_[place(VertexId(v))] = true;
    }
  }

  /// Of the segments that change the vertices that they are to go through, in no order.
  void find_ways() {
    for (const auto& [e, v] : drift_.beside) {
      for (const SegmentId s : complex_.edge_sources[e]) ways_[s].push_back(v);
    }
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      const auto [tail, head] = complex_.edges[e];
      if (place(tail) == tail && place(head) == head) continue;
      for (const SegmentId s : complex_.edge_sources[e]) ways_[s];
    }
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      for (const SegmentId s : complex_.edge_sources[e]) {
        const auto way = ways_.find(s);
        if (way == ways_.end()) continue;
        for (const VertexId v : {complex_.edges[e].tail, complex_.edges[e].head}) {
          if (is_kept_[v]) way->second.push_back(v);
        }
      }
    }
  }

  void add(const Point& a, const Point& b, SegmentId origin) {
    result_.segments.push_back({a, b});
    origins_.push_back(origin);
  }

  void add(const std::vector<VertexId>& way, SegmentId origin) {
    const auto [a, b] = input_.segments[origin];
    const Rational x = b.x - a.x, y = b.y - a.y;
    std::vector<std::pair<Rational, VertexId>> along;
    along.reserve(way.size());
    for (const VertexId v : way) {
      const Point p = complex_.vertices[v];
      along.emplace_back(p.x * x + p.y * y, v);
    }
    std::sort(along.begin(), along.end());
    VertexId last;
    for (const auto& [parameter, v] : along) {
      const VertexId next = place(v);
      if (last.valid() && next != last) {
        add(complex_.vertices[last], complex_.vertices[next], origin);
      }
      last = next;
    }
  }

  const SegmentSet& input_;
  const ExactComplex& complex_;
  const Drift& drift_;
  std::vector<bool> is_kept_;
  std::unordered_map<std::size_t, std::vector<VertexId>> ways_;  ///< by segment
  SegmentSet result_;
  std::vector<SegmentId> origins_;  ///< per segment of the result
};

Cause of_drawing(const Drift& drift) {
  Cause cause;
  cause.stage = kDrawing;
  cause.rule = "below-the-digits";
  cause.explanation = fmt::format(
      "the file's own digits leave open whether points nearer than {:.2g} are one, and this hangs "
      "on "
      "it",
      drift.bound);
  cause.advice = "--shortest-decimals, if a program printed short numbers with an error";
  cause.confirmed = true;
  return cause;
}

/// Whether the findings that it follows from are the drawing's own, and it is there, all of it (of
/// a face, that something is), without the drift.
bool is_of_drift(const Finding& finding, const std::vector<bool>& is_own,
                 const compare_steps::WrongCells& wrong, const Drift& drift) {
  const bool is_far = finding.distance && *finding.distance > drift.bound;
  if (finding.disagreement == Disagreement::Invalid || is_far) return false;
  const auto is_known = [&](std::size_t number) { return is_own[number - 1]; };
  if (!std::all_of(finding.because.begin(), finding.because.end(), is_known)) return false;
  const bool is_of_faces = finding.kind == CellKind::Face || finding.kind == CellKind::Hole;
  return (is_of_faces && !finding.because.empty()) || wrong.extent(finding) == wrong.whole(finding);
}

/// Requires: as many causes as findings, or none.
void take_findings(const std::vector<Finding>& findings, std::vector<Cause>& causes,
                   const compare_steps::WrongCells& wrong, const Drift& drift) {
  std::vector<bool> is_own(causes.size());
  for (std::size_t i = 0; i < causes.size(); ++i) {
    is_own[i] = is_of_drift(findings[i], is_own, wrong, drift);
    if (is_own[i]) causes[i] = of_drawing(drift);
  }
}

}  // namespace

std::size_t vertices_in_drift(const Drift& drift) {
  std::size_t count = 0;
  for (std::size_t v = 0; v < drift.stands_for.size(); ++v) {
    if (drift.stands_for[v] != v) ++count;
  }
  return count;
}

std::size_t findings_beside_drift(const Comparison& comparison, const ExactComplex& exact_complex,
                                  const ExactComplex& without, const Drift& drift) {
  const Comparison now =
      compare_steps::compare_cells(exact_complex, without, comparison.tolerance, true);
  std::vector<Cause> causes(comparison.findings.size());
  take_findings(comparison.findings, causes, compare_steps::WrongCells(now, exact_complex), drift);
  return static_cast<std::size_t>(std::count_if(
      causes.begin(), causes.end(), [](const Cause& cause) { return cause.stage != kDrawing; }));
}

void take_from_drawing(Check& check, std::size_t threads) {
  if (check.drift.places == 0 || (check.causes.empty() && check.conversion_causes.empty())) return;
  const Comparison now = compare_steps::compare_cells(
      check.exact_complex, without_drift(check.input, check.exact_complex, check.drift, threads),
      check.comparison.tolerance, true);
  const compare_steps::WrongCells wrong(now, check.exact_complex);
  take_findings(check.comparison.findings, check.causes, wrong, check.drift);
  take_findings(check.conversion.findings, check.conversion_causes, wrong, check.drift);
}

}  // namespace plumbline::check_steps

namespace plumbline {

ExactComplex without_drift(const SegmentSet& input, const ExactComplex& complex, const Drift& drift,
                           std::size_t threads) {
  return check_steps::Straightening(input, complex, drift).arranged(threads);
}

}  // namespace plumbline
