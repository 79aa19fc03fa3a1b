// Matches vertices one to one and says what became of the others.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "compare/moved_vertices.hpp"
#include "compare/near_vertices.hpp"
#include "compare/sole_neighbours.hpp"
#include "compare/steps.hpp"
#include "geometry/point_d.hpp"

namespace plumbline::compare_steps {
namespace {

/// A pair of vertices that may be one; `distance` is off by at most the slack of both lists.
struct Candidate {
  VertexId exact_vertex, float_vertex;
  double distance;
};

/// Distances of the exact from the float vertices.
class Distances {
 public:
  explicit Distances(const Sides& sides)
      : sides_(sides), slack_(distance_slack(sides.points[Exact], sides.points[Float])) {}

  double rough(VertexId v, VertexId w) const {
    return distance(sides_.points[Exact].rough(v), sides_.points[Float].rough(w));
  }
  Rational squared(VertexId v, VertexId w) const {
    return squared_distance(sides_.point(Exact, v), sides_.point(Float, w));
  }
  bool are_within_tolerance(const Candidate& c) const {
    if (c.distance + 2 * slack_ < sides_.tolerance) return true;
    if (c.distance > sides_.tolerance + 2 * slack_) return false;
    return squared(c.exact_vertex, c.float_vertex) <= sides_.squared_tolerance;
  }
  /// Whether doubles tell which of the two is less.
  bool are_apart(double a, double b) const { return std::abs(a - b) > 2 * slack_; }
  /// The largest squared distance; 0 for none.
  Rational largest_squared(const std::vector<Candidate>& pairs) const;

 private:
  const Sides& sides_;
  const double slack_;
};

Rational Distances::largest_squared(const std::vector<Candidate>& pairs) const {
  double farthest = 0;
  for (const Candidate& pair : pairs) farthest = std::max(farthest, pair.distance);
  Rational result = 0;
  for (const Candidate& pair : pairs) {
    if (!are_apart(pair.distance, farthest)) {
      result = std::max(result, squared(pair.exact_vertex, pair.float_vertex));
    }
  }
  return result;
}

VertexMatch nothing_matched(const Sides& sides) {
  VertexMatch result;
  for (const Side side : kBothSides) {
    result.match[side].resize(sides[side].vertices.size());
    result.number[side].resize(sides[side].vertices.size());
  }
  return result;
}

void match(VertexMatch& result, VertexId exact_vertex, VertexId float_vertex) {
  result.match[Exact][exact_vertex] = float_vertex;
  result.match[Float][float_vertex] = exact_vertex;
}

/// Matches equal vertices: nothing is nearer. Both lists are ascending.
void match_equal(VertexMatch& result, const Sides& sides) {
  const FilteredPoints &exacts = sides.points[Exact], &floats = sides.points[Float];
  for (std::size_t v = 0, w = 0; v < exacts.size() && w < floats.size();) {
    const PointD &p = exacts.rough(v), &q = floats.rough(w);
    const int order =
        p.x != q.x ? (p.x < q.x ? -1 : 1) : PointList::compare(exacts.list(), v, floats.list(), w);
    if (order == 0) {
      match(result, VertexId(v++), VertexId(w++));
    } else {
      ++(order < 0 ? v : w);
    }
  }
}

/// Matches the vertices that have no choice; returns whether each exact vertex is done with.
std::vector<bool> match_sole_pairs(VertexMatch& result, const Sides& sides,
                                   const Distances& distances) {
  std::vector<bool> is_done(sides[Exact].vertices.size());
  for (std::size_t v = 0; v < is_done.size(); ++v) is_done[v] = result.match[Exact][v].valid();
  std::vector<Candidate> matched;
  for (const SolePair& pair :
       sole_pairs(sides.points[Exact], sides.points[Float], sides.tolerance)) {
    if (is_done[pair.exact]) continue;
    is_done[pair.exact] = true;
    const Candidate candidate{VertexId(pair.exact), VertexId(pair.other), pair.distance};
    if (!distances.are_within_tolerance(candidate)) continue;
    match(result, candidate.exact_vertex, candidate.float_vertex);
    matched.push_back(candidate);
  }
  result.largest_squared = distances.largest_squared(matched);
  return is_done;
}

/// The pairs of vertices without a match that lie within the tolerance, by rough distance.
std::vector<Candidate> candidates_by_distance(const VertexMatch& matched, const Sides& sides,
                                              const Distances& distances,
                                              const NearVertices& floats,
                                              const std::vector<bool>& is_done) {
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < is_done.size(); ++i) {
    if (is_done[i]) continue;
    const VertexId v(i);
    for (const VertexId w : floats.proposals(sides.points[Exact].rough(v), sides.tolerance)) {
      if (matched.match[Float][w].valid()) continue;
      const Candidate candidate{v, w, distances.rough(v, w)};
      if (distances.are_within_tolerance(candidate)) candidates.push_back(candidate);
    }
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  return candidates;
}

/// Candidates whose rough distances do not tell them apart: nearest first, then by index.
std::vector<Candidate> nearest_first(const std::vector<Candidate>& candidates,
                                     const Distances& distances) {
  if (candidates.size() < 2) return candidates;
  std::vector<std::pair<Rational, Candidate>> exact;
  for (const Candidate& c : candidates) {
    exact.emplace_back(distances.squared(c.exact_vertex, c.float_vertex), c);
  }
  std::sort(exact.begin(), exact.end(), [](const auto& a, const auto& b) {
    if (const int order = cmp(a.first, b.first); order != 0) return order < 0;
    return std::pair(a.second.exact_vertex, a.second.float_vertex) <
           std::pair(b.second.exact_vertex, b.second.float_vertex);
  });
  std::vector<Candidate> result;
  for (const auto& entry : exact) result.push_back(entry.second);
  return result;
}

/// Matches the nearest of all candidates, the nearest of those left, and so on; returns the pairs.
std::vector<Candidate> match_nearest_first(VertexMatch& result,
                                           const std::vector<Candidate>& candidates,
                                           const Distances& distances) {
  const auto is_open = [&](const Candidate& c) {
    return !result.match[Exact][c.exact_vertex].valid() &&
           !result.match[Float][c.float_vertex].valid();
  };
  std::vector<Candidate> matched;
  for (auto first = candidates.begin(); first != candidates.end();) {
    std::vector<Candidate> open;
    auto last = first;
    do {
      if (is_open(*last)) open.push_back(*last);
      ++last;
    } while (last != candidates.end() &&
             !distances.are_apart(std::prev(last)->distance, last->distance));
    for (const Candidate& candidate : nearest_first(open, distances)) {
      if (!is_open(candidate)) continue;
      match(result, candidate.exact_vertex, candidate.float_vertex);
      matched.push_back(candidate);
    }
    first = last;
  }
  return matched;
}

VertexMatch one_to_one(const Sides& sides, const NearVertices& floats) {
  const Distances distances(sides);
  VertexMatch result = nothing_matched(sides);
  match_equal(result, sides);
  const std::vector<bool> is_done = match_sole_pairs(result, sides, distances);
  const std::vector<Candidate> matched = match_nearest_first(
      result, candidates_by_distance(result, sides, distances, floats, is_done), distances);
  result.largest_squared = std::max(result.largest_squared, distances.largest_squared(matched));
  return result;
}

/// Vertices that correspond by their edges: matched like others, but listed.
std::vector<Finding> match_moved(VertexMatch& result, const Sides& sides, Detail detail) {
  std::vector<Finding> findings;
  for (const auto& [v, w] : moved_vertices(sides, result.match)) {
    match(result, v, w);
    Finding finding;
    finding.kind = CellKind::Vertex;
    finding.disagreement = Disagreement::Moved;
    finding.exact_cells = {v};
    finding.float_cells = {w};
    finding.segments =
        joined(segments_at(sides, Exact, std::array{v}), segments_at(sides, Float, std::array{w}));
    if (detail == Detail::Full) {
      finding.where = sides.point(Exact, v);
      finding.squared_distance = squared_distance(finding.where, sides.point(Float, w));
      finding.distance = length(*finding.squared_distance);
      finding.message =
          fmt::format("a vertex lies {} away from where it should", rough(*finding.distance));
    }
    findings.push_back(std::move(finding));
  }
  return findings;
}

/// A vertex of the side without any vertex of the other one within the tolerance.
Finding lacking_vertex(const Sides& sides, Side side, VertexId v,
                       const std::optional<Near>& nearest_other, Detail detail) {
  Finding finding;
  finding.kind = CellKind::Vertex;
  finding.disagreement = lacking(side);
  finding.where = sides.point(side, v);
  cells(finding, side) = {v};
  finding.segments = segments_at(sides, side, std::array{v});
  finding.message = side == Exact ? "an exact vertex is missing from the float result"
                                  : "a float vertex has no exact counterpart";
  if (nearest_other && detail == Detail::Full) {
    finding.squared_distance =
        squared_distance(finding.where, sides.point(other(side), nearest_other->vertex));
    finding.distance = length(*finding.squared_distance);
    finding.message += fmt::format("; the nearest {} vertex is {} away", name(other(side)),
                                   rough(*finding.distance));
  }
  return finding;
}

/// Vertices of the side that are one vertex of the other: its match first, then those left over.
Finding joined_vertices(const Sides& sides, Side side, const std::vector<VertexId>& vertices,
                        VertexId into, Detail detail) {
  Finding finding;
  finding.kind = CellKind::Vertex;
  finding.disagreement = joining(side);
  cells(finding, side).assign(vertices.begin(), vertices.end());
  std::sort(cells(finding, side).begin(), cells(finding, side).end());
  cells(finding, other(side)) = {into};
  finding.segments =
      joined(segments_at(sides, side, vertices), segments_at(sides, other(side), std::array{into}));
  if (detail != Detail::Full) return finding;
  finding.where = sides.point(other(side), into);
  Rational farthest = 0;
  for (const VertexId v : vertices) {
    farthest = std::max(farthest, squared_distance(sides.point(side, v), finding.where));
  }
  finding.squared_distance = farthest;
  finding.distance = length(farthest);
  const double apart = length(
      squared_distance(sides.point(side, vertices.front()), sides.point(side, vertices.back())));
  const std::string spread = vertices.size() == 2
                                 ? fmt::format("two {} vertices {} apart", name(side), rough(apart))
                                 : fmt::format("{} {} vertices within {} of it", vertices.size(),
                                               name(side), rough(*finding.distance));
  finding.message =
      side == Exact ? spread + " became one float vertex" : "one exact vertex became " + spread;
  return finding;
}

void add(VertexMatch& result, Finding finding, std::size_t first_number) {
  for (const Side side : kBothSides) {
    for (const std::size_t v : cells(finding, side)) {
      if (result.number[side][v] == 0) {
        result.number[side][v] = first_number + result.findings.size();
      }
    }
  }
  result.findings.push_back(std::move(finding));
}

/// Reports the vertices of the side that have no match, and fills in their images.
void account_for_unmatched(VertexMatch& result, const Sides& sides, Side side,
                           const NearVertices& others, std::size_t first_number, Detail detail) {
  const Distances distances(sides);
  std::vector<std::vector<VertexId>> joined_into(sides[other(side)].vertices.size());
  std::vector<Finding> lacking_ones;
  for (std::size_t i = 0; i < sides[side].vertices.size(); ++i) {
    const VertexId v(i);
    if (result.match[side][v].valid()) continue;
    const std::optional<Near> near = others.nearest_to(sides.points[side], v);
    const auto is_within_tolerance = [&] {
      return distances.are_within_tolerance(side == Exact
                                                ? Candidate{v, near->vertex, near->distance}
                                                : Candidate{near->vertex, v, near->distance});
    };
    if (near && is_within_tolerance()) {
      result.image[side][v] = near->vertex;
      joined_into[near->vertex].push_back(v);
    } else {
      lacking_ones.push_back(lacking_vertex(sides, side, v, near, detail));
    }
  }
  for (std::size_t i = 0; i < joined_into.size(); ++i) {
    const VertexId into(i);
    if (joined_into[into].empty()) continue;
    if (const VertexId match = result.match[other(side)][into]; match.valid()) {
      joined_into[into].insert(joined_into[into].begin(), match);
    }
    add(result, joined_vertices(sides, side, joined_into[into], into, detail), first_number);
  }
  for (Finding& finding : lacking_ones) add(result, std::move(finding), first_number);
}

}  // namespace

VertexMatch match_vertices(const Sides& sides, std::size_t first_number, Detail detail) {
  const NearVertices exacts(sides.points[Exact]);
  const NearVertices floats(sides.points[Float]);
  VertexMatch result = one_to_one(sides, floats);
  std::vector<Finding> moved = match_moved(result, sides, detail);
  result.moved_count = moved.size();
  result.image = result.match;
  for (Finding& finding : moved) add(result, std::move(finding), first_number);
  account_for_unmatched(result, sides, Exact, floats, first_number, detail);
  account_for_unmatched(result, sides, Float, exacts, first_number, detail);
  return result;
}

}  // namespace plumbline::compare_steps
