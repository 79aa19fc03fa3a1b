// No number is computed here: what meets in a vertex is known from the sources of its edges.

#include "output/certificate/reasons.hpp"

#include <algorithm>
#include <utility>

namespace plumbline::certificate_steps {
namespace {

/// The lexicographically first and last vertex of a segment.
struct Ends {
  VertexId first;
  VertexId last;
};

/// Per segment. Edges ascend by their tails, so its first and last piece are those of the segment.
std::vector<Ends> segment_ends(const ExactComplex& complex, std::size_t segments) {
  std::vector<Ends> ends(segments);
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    for (const SegmentId s : complex.edge_sources[e]) {
      Ends& of = ends.at(s);
      if (!of.first.valid()) of.first = complex.edges[e].tail;
      of.last = complex.edges[e].head;
    }
  }
  return ends;
}

void name_ends(const ExactComplex& complex, const SegmentSet& input,
               std::vector<std::string>& names) {
  const std::vector<Ends> ends = segment_ends(complex, input.segments.size());
  for (std::size_t s = 0; s < ends.size(); ++s) {
    ensure(ends[s].first.valid(), "every segment is covered by edges");
    const Segment segment = input.segments[s];
    const bool runs_forward = segment.a < segment.b;
    const std::string begin = "end " + std::to_string(s);
    std::string& first = names[ends[s].first];
    std::string& last = names[ends[s].last];
    if (first.empty()) first = begin + (runs_forward ? " 0" : " 1");
    if (last.empty()) last = begin + (runs_forward ? " 1" : " 0");
  }
}

/// The two least segments through a vertex that are not parallel. Its edges that the least segment
/// does not cover run along other lines, as no segment ends here.
class Crossing {
 public:
  void add_least(SegmentId s) { least_ = std::min(least_, s); }
  void add_other(std::span<const SegmentId> sources) {
    if (!std::binary_search(sources.begin(), sources.end(), least_)) {
      other_ = std::min(other_, sources.front());
    }
  }
  /// Empty where only one line passes.
  std::string name() const {
    if (!other_.valid()) return "";
    return "cross " + std::to_string(static_cast<std::size_t>(least_)) + ' ' +
           std::to_string(static_cast<std::size_t>(other_));
  }

 private:
  SegmentId least_;  // invalid ids are the greatest
  SegmentId other_;
};

void name_crossings(const ExactComplex& complex, std::vector<std::string>& names) {
  std::vector<Crossing> crossings(complex.vertices.size());
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    for (const VertexId v : {complex.edges[e].tail, complex.edges[e].head}) {
      crossings[v].add_least(complex.edge_sources[e].front());
    }
  }
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    for (const VertexId v : {complex.edges[e].tail, complex.edges[e].head}) {
      crossings[v].add_other(complex.edge_sources[e]);
    }
  }
  for (std::size_t v = 0; v < names.size(); ++v) {
    if (names[v].empty()) names[v] = crossings[v].name();
  }
}

void name_points(const ExactComplex& complex, const SegmentSet& input,
                 std::vector<std::string>& names) {
  for (std::size_t p = 0; p < input.points.size(); ++p) {
    const std::size_t v = complex.vertices.count_before(input.points[p]);
    ensure(v < names.size() && complex.vertices[v] == input.points[p],
           "every point of the input is a vertex");
    std::string& name = names[v];
    if (name.empty()) name = "point " + std::to_string(p);
  }
}

}  // namespace

std::vector<std::string> reasons(const ExactComplex& complex, const SegmentSet& input) {
  std::vector<std::string> names(complex.vertices.size());
  name_ends(complex, input, names);
  name_crossings(complex, names);
  name_points(complex, input, names);
  ensure(std::none_of(names.begin(), names.end(), [](const auto& name) { return name.empty(); }),
         "every vertex has a reason");
  return names;
}

}  // namespace plumbline::certificate_steps
