// Defects from classified tips.

#include <algorithm>

#include "diagnose/steps.hpp"

namespace plumbline::diagnose_steps {
namespace {

Defect near_end(const Subject& subject, const Tip& tip) {
  const LineGraph& graph = subject.graph;
  Defect defect;
  defect.kind = tip.kind;
  defect.where = graph.complex().vertices[tip.vertex];
  defect.vertices = {tip.vertex};
  defect.edges = {graph.edges(tip.vertex)[0], tip.edge};
  if (tip.kind == DefectKind::Gap) {
    defect.where = midpoint(defect.where, graph.complex().vertices[tip.partner]);
    defect.vertices.push_back(tip.partner);
    std::sort(defect.vertices.begin(), defect.vertices.end());
    std::sort(defect.edges.begin(), defect.edges.end());
  }
  defect.squared_size = tip.squared_distance;
  defect.size = nearest_sqrt(tip.squared_distance);
  defect.proposed_tolerance = root_rounded_up(tip.squared_distance);
  defect.segments = graph.segments(defect.edges);
  return defect;
}

Defect dangling(const Subject& subject, const Tip& tip, const Chain& line) {
  const LineGraph& graph = subject.graph;
  const Roots length = graph.length(line);
  Defect defect;
  defect.kind = tip.kind;
  defect.where = graph.complex().vertices[tip.vertex];
  defect.vertices = {tip.vertex};
  if (line.edges.size() == 1) defect.squared_size = graph.squared_length(line.edges[0]);
  defect.size = length.rounded();
  if (graph.is_within(line, subject.within)) defect.proposed_tolerance = length.rounded_up();
  defect.segments = graph.segments(line.edges);
  defect.edges = line.edges;
  return defect;
}

/// Where both ends of a line dangle, or both tips of a gap have each other: whether the other one
/// speaks for both.
bool is_told_by_other(const Subject& subject, const Tips& tips, const Tip& tip) {
  VertexId other;
  if (tip.kind == DefectKind::Gap) other = tip.partner;
  if (tip.kind == DefectKind::Dangle) {
    other = subject.graph.chain(tip.vertex, subject.graph.edges(tip.vertex)[0]).last;
  }
  if (!other.valid() || !(other < tip.vertex) || !subject.graph.is_tip(other)) return false;
  const Tip& second = tips.at(other);
  return second.kind == tip.kind &&
         (tip.kind == DefectKind::Dangle || second.partner == tip.vertex);
}

}  // namespace

Defects dangling_lines(const Subject& subject, const Tips& tips) {
  Defects result(subject.most_listed);
  for (const Tip& tip : tips.tips) {
    const Chain line = subject.graph.chain(tip.vertex, subject.graph.edges(tip.vertex)[0]);
    if (subject.graph.is_within(line, subject.within)) {
      for (const EdgeId e : line.edges) result.add_accident(e);
    }
    if (is_told_by_other(subject, tips, tip)) continue;
    if (tip.kind == DefectKind::Gap || tip.kind == DefectKind::Undershoot) {
      result.add(near_end(subject, tip));
      continue;
    }
    Defect defect = dangling(subject, tip, line);
    if (tip.kind == DefectKind::Dangle && subject.graph.is_tip(line.last) &&
        tips.at(line.last).kind == DefectKind::Dangle) {
      defect.vertices.push_back(line.last);
    }
    result.add(std::move(defect));
  }
  for (std::size_t i = 0; i < tips.cut_short; ++i) result.add_cut_short();
  return result;
}

}  // namespace plumbline::diagnose_steps
