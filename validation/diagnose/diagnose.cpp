// What the diagnosis counts on one drawing, as authored and over the doubles, in the terms of an
// index of the files. Usage: plumbline_diagnose FILE. Prints a JSON object; exit code 2 if FILE is
// not readable.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <set>

#include "plumbline/plumbline.hpp"

using namespace plumbline;

namespace {

SegmentSet over_doubles(const SegmentSet& input) {
  SegmentSet result;
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const auto n = input.segments.numbers(s);
    const PointD a = nearest(NumberPoint{n[0], n[1]}), b = nearest(NumberPoint{n[2], n[3]});
    if (!(a == b)) result.add(a, b, SourceId());
  }
  return result;
}

/// Loose ends where just one of the distinct segments ends: overlapping ones can end together.
std::size_t dangling_ends(const SegmentSet& input, const ExactComplex& complex) {
  std::vector<std::size_t> degree(complex.vertices.size());
  std::vector<EdgeId> edge_at(complex.vertices.size());
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    for (const VertexId v : {complex.edges[e].tail, complex.edges[e].head}) {
      ++degree[v];
      edge_at[v] = EdgeId(e);
    }
  }
  std::size_t count = 0;
  for (std::size_t v = 0; v < degree.size(); ++v) {
    if (degree[v] != 1) continue;
    const Point& p = complex.vertices[v];
    std::set<Point> other_ends;
    for (const SegmentId s : complex.edge_sources[edge_at[v]]) {
      const Segment segment = input.segments[s];
      if (segment.a == p) other_ends.insert(segment.b);
      if (segment.b == p) other_ends.insert(segment.a);
    }
    count += other_ends.size() == 1 ? 1 : 0;
  }
  return count;
}

double diagonal(const ExactComplex& complex) {
  double low_x = INFINITY, low_y = INFINITY, high_x = -INFINITY, high_y = -INFINITY;
  for (const Point& exact_point : complex.vertices) {
    const PointD p = nearest(exact_point);
    low_x = std::min(low_x, p.x);
    high_x = std::max(high_x, p.x);
    low_y = std::min(low_y, p.y);
    high_y = std::max(high_y, p.y);
  }
  return complex.vertices.empty() ? 0 : std::hypot(high_x - low_x, high_y - low_y);
}

/// "{...}": counts as the index has them; `near`: what a tolerance of 1e-9 of the
/// diagonal mends at an end of a segment.
std::string counts(const SegmentSet& input) {
  constexpr double kNear = 1e-9;
  const ExactComplex complex = arrange(input);
  const Diagnosis result =
      diagnose(input, complex, {rational_from(kNear * diagonal(complex)), 1'000'000});
  std::size_t duplicates = 0;
  for (const Defect& defect : result.defects) {
    if (defect.kind == DefectKind::Duplicate) duplicates += defect.segments.size() - 1;
  }
  std::set<Point> ends;
  for (const Segment& segment : input.segments) {
    ends.insert(segment.a);
    ends.insert(segment.b);
  }
  const auto is_at_end = [&](const Defect& defect) {
    return std::any_of(defect.vertices.begin(), defect.vertices.end(),
                       [&](VertexId v) { return ends.contains(complex.vertices[v]); });
  };
  std::size_t near = 0;
  for (const Defect& defect : result.defects) {
    near += defect.proposed_tolerance.value_or(0) > 0 && is_at_end(defect) ? 1 : 0;
  }
  return fmt::format(
      "{{\"segments\": {}, \"duplicates\": {}, \"overlaps\": {}, \"dangling_ends\": {}, \"near\": "
      "{}}}",
      input.segments.size(), duplicates, result.count(DefectKind::Overlap),
      dangling_ends(input, complex), near);
}

/// "{...}": the kinds at the default distance, and seconds.
std::string kinds(const SegmentSet& input) {
  using Clock = std::chrono::steady_clock;
  const ExactComplex complex = arrange(input);
  const auto start = Clock::now();
  const Diagnosis result = diagnose(input, complex);
  const std::chrono::duration<double> seconds = Clock::now() - start;
  std::string text = "{";
  for (std::size_t kind = 0; kind < kDefectKinds; ++kind) {
    text += fmt::format("\"{}\": {}, ", to_text(static_cast<DefectKind>(kind)), result.found[kind]);
  }
  return text +
         fmt::format("\"cut short\": {}, \"seconds\": {:.3f}}}", result.cut_short, seconds.count());
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: plumbline_diagnose FILE\n";
    return 2;
  }
  SegmentSet input = evaluate(read(argv[1]));
  const std::string found = kinds(input);
  input.rings.clear();  // the index knows no neighbours
  fmt::print("{{\"authored\": {}, \"doubles\": {}, \"kinds\": {}}}\n", counts(input),
             counts(over_doubles(input)), found);
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
