// Defects from classified tips. Three ends and more that lead to one point are one gap.

#include <algorithm>
#include <map>

#include "diagnose/closings.hpp"
#include "diagnose/steps.hpp"
#include "geometry/union_find.hpp"

namespace plumbline::diagnose_steps {
namespace {

Defect near_end(const Subject& subject, const Tip& tip) {
  const LineGraph& graph = subject.graph;
  Defect defect;
  defect.kind = tip.kind;
  defect.where = graph.complex().vertices[tip.vertex];
  defect.vertices = {tip.vertex};
  defect.edges = {graph.edges(tip.vertex)[0], tip.edge};
  if (tip.kind == DefectKind::Overshoot) defect.vertices.push_back(tip.partner);
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

/// The tips of gaps that lead to one point, in groups of three and more.
std::vector<std::vector<const Tip*>> junctions(const Tips& tips) {
  UnionFind sets(tips.tips.size());
  const auto index = [&](const Tip& tip) {
    return static_cast<std::size_t>(&tip - tips.tips.data());
  };
  for (const Tip& tip : tips.tips) {
    for (const VertexId v : tip.meets) {
      const Tip& other = tips.at(v);
      const bool is_mutual = std::binary_search(other.meets.begin(), other.meets.end(), tip.vertex);
      if (is_mutual) sets.unite(index(tip), index(other));
    }
  }
  std::map<std::size_t, std::vector<const Tip*>> groups;
  for (const Tip& tip : tips.tips) {
    if (!tip.meets.empty()) groups[sets.find(index(tip))].push_back(&tip);
  }
  std::vector<std::vector<const Tip*>> result;
  for (auto& [set, group] : groups) {
    if (group.size() > 2) result.push_back(std::move(group));
  }
  return result;
}

/// Of the points where two of the lines meet the one that is nearest to all ends.
class MeetingPoint {
 public:
  MeetingPoint(const LineGraph& graph, const std::vector<const Tip*>& tips) {
    constexpr std::size_t kMostTips = 32;  // of which pairs are looked at
    for (const Tip* tip : tips) {
      ends_.push_back(graph.complex().vertices[tip->vertex]);
      from_.push_back(
          graph.complex().vertices[graph.other_end(graph.edges(tip->vertex)[0], tip->vertex)]);
    }
    for (std::size_t i = 0; i < tips.size() && tips.size() <= kMostTips; ++i) {
      for (std::size_t j = i + 1; j < tips.size(); ++j) look_at(i, j);
    }
    if (!is_found_) offer(mean());
  }

  const Point& point() const { return best_; }
  const Rational& squared_distance() const { return squared_; }

 private:
  void look_at(std::size_t i, std::size_t j) {
    const Point &a = ends_[i], &b = ends_[j];
    const Rational ux = a.x - from_[i].x, uy = a.y - from_[i].y;
    const Rational wx = b.x - from_[j].x, wy = b.y - from_[j].y;
    const Rational turn = ux * wy - uy * wx;
    if (sgn(turn) == 0) return;
    const Rational along = Rational((b.x - a.x) * wy - (b.y - a.y) * wx) / turn;
    offer({a.x + along * ux, a.y + along * uy});
  }

  Point mean() const {
    Point sum;
    for (const Point& end : ends_) sum = {sum.x + end.x, sum.y + end.y};
    const auto count = static_cast<unsigned long>(ends_.size());
    return {sum.x / count, sum.y / count};
  }

  void offer(Point p) {
    Rational farthest = 0;
    for (const Point& end : ends_) {
      farthest = std::max(farthest, plumbline::squared_distance(p, end));
    }
    if (is_found_ && (farthest > squared_ || (farthest == squared_ && !(p < best_)))) return;
    is_found_ = true;
    best_ = std::move(p);
    squared_ = std::move(farthest);
  }

  std::vector<Point> ends_, from_;  ///< of the lines, from where to where
  bool is_found_ = false;
  Point best_;
  Rational squared_;
};

Defect junction(const Subject& subject, const std::vector<const Tip*>& tips) {
  const MeetingPoint meeting(subject.graph, tips);
  Defect defect;
  defect.kind = DefectKind::Gap;
  defect.where = meeting.point();
  for (const Tip* tip : tips) {
    defect.vertices.push_back(tip->vertex);
    defect.edges.push_back(subject.graph.edges(tip->vertex)[0]);
  }
  std::sort(defect.edges.begin(), defect.edges.end());
  defect.squared_size = meeting.squared_distance();
  defect.size = nearest_sqrt(meeting.squared_distance());
  defect.proposed_tolerance = root_rounded_up(meeting.squared_distance());
  defect.segments = subject.graph.segments(defect.edges);
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

/// Defects of ends that joining mends, until it is known what it would part.
class NearEnds {
 public:
  explicit NearEnds(const Subject& subject) : subject_(subject) {}

  void add(const Tip& tip) {
    const auto& vertices = subject_.graph.complex().vertices;
    defects_.push_back(near_end(subject_, tip));
    if (tip.kind == DefectKind::Gap) {
      close(vertices[tip.vertex], vertices[tip.partner]);
    } else if (tip.kind == DefectKind::Undershoot) {
      close(vertices[tip.vertex],
            nearest_on_edge(subject_.graph.complex(), tip.vertex, tip.edge).foot);
    }
  }
  void add(const std::vector<const Tip*>& tips) {
    defects_.push_back(junction(subject_, tips));
    for (const Tip* tip : tips) {
      close(subject_.graph.complex().vertices[tip->vertex], defects_.back().where);
    }
  }

  void move_to(Defects& result) && {
    const auto areas = open_areas(subject_.input, closings_, defects_.size());
    for (std::size_t i = 0; i < defects_.size(); ++i) {
      defects_[i].open_area = areas[i];
      result.add(std::move(defects_[i]));
    }
  }

 private:
  /// Of the last defect.
  void close(Point a, Point b) {
    if (a != b) closings_.push_back({defects_.size() - 1, std::move(a), std::move(b)});
  }

  const Subject& subject_;
  std::vector<Defect> defects_;
  std::vector<Closing> closings_;
};

}  // namespace

Defects dangling_lines(const Subject& subject, const Tips& tips) {
  Defects result(subject.most_listed);
  NearEnds near_ends(subject);
  std::vector<VertexId> joined;
  for (const std::vector<const Tip*>& group : junctions(tips)) {
    near_ends.add(group);
    for (const Tip* tip : group) joined.push_back(tip->vertex);
  }
  std::sort(joined.begin(), joined.end());
  for (const Tip& tip : tips.tips) {
    const Chain line = subject.graph.chain(tip.vertex, subject.graph.edges(tip.vertex)[0]);
    if (subject.graph.is_within(line, subject.within)) {
      for (const EdgeId e : line.edges) result.add_accident(e);
    }
    if (std::binary_search(joined.begin(), joined.end(), tip.vertex)) continue;
    if (is_told_by_other(subject, tips, tip)) continue;
    if (tip.kind != DefectKind::Dangle && tip.edge.valid()) {
      near_ends.add(tip);
      continue;
    }
    Defect defect = dangling(subject, tip, line);
    if (tip.kind == DefectKind::Dangle && subject.graph.is_tip(line.last) &&
        tips.at(line.last).kind == DefectKind::Dangle) {
      defect.vertices.push_back(line.last);
    }
    result.add(std::move(defect));
  }
  std::move(near_ends).move_to(result);
  for (std::size_t i = 0; i < tips.cut_short; ++i) result.add_cut_short();
  return result;
}

}  // namespace plumbline::diagnose_steps
