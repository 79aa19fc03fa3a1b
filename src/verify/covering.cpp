// Steps 1 and 2: the edges cover the input exactly and nothing else, and each vertex has a reason.

#include <algorithm>
#include <string>

#include "refusal.hpp"
#include "steps.hpp"

namespace plumbline_verify {
namespace {

std::string operator+(const std::string& text, Index number) {
  return text + std::to_string(number);
}

/// For each segment its edges by position.
class Chains {
 public:
  Chains(const Input& input, const Certificate& certificate)
      : input_(input), certificate_(certificate) {
    begins_.assign(input.segments.size() + 1, 0);
    for (const Index segment : certificate.segments.values) ++begins_[segment + 1];
    for (std::size_t s = 0; s < input.segments.size(); ++s) begins_[s + 1] += begins_[s];
    edges_.assign(begins_.back(), kNone);
    for (Index e = 0; e < certificate.edges.size(); ++e) place(e);
  }

  /// The chain of one segment leads from its first end to its last along its line.
  void check(Index s) const {
    const Segment& segment = input_.segments[s];
    if (begins_[s] == begins_[s + 1]) {
      throw Refusal{std::string("no edge covers segment ") + s, certificate_.edge_line,
                    text_of(segment.first)};
    }
    const Edge* before = nullptr;
    for (Index at = begins_[s]; at < begins_[s + 1]; ++at) {
      const Edge& edge = certificate_.edges[edges_[at]];
      const Point& tail = certificate_.vertices[edge.tail];
      if (before == nullptr ? !(tail == segment.first) : edge.tail != before->head) {
        refuse(at, s,
               before == nullptr ? "does not start at its first end"
                                 : "does not go on where the piece before it ends");
      }
      const Point& head = certificate_.vertices[edge.head];
      const bool is_last = at + 1 == begins_[s + 1];
      if (is_last && !(head == segment.last)) refuse(at, s, "does not end at its last end");
      if (!is_last && side(segment.line, head) != 0) refuse(at, s, "does not lie on it");
      before = &edge;
    }
  }

 private:
  void place(Index e) {
    const Lists& segments = certificate_.segments;
    for (Index at = segments.begins[e]; at < segments.begins[e + 1]; ++at) {
      const Index s = segments.values[at];
      const Index piece = certificate_.pieces[at];
      const Index count = begins_[s + 1] - begins_[s];
      const std::string says =
          std::string("edge ") + e + " is said to be piece " + piece + " of segment " + s;
      if (piece >= count) {
        throw Refusal{says + ", which is named by " + count + " edges only",
                      certificate_.edge_line + e, ""};
      }
      Index& edge = edges_[begins_[s] + piece];
      if (edge != kNone) {
        throw Refusal{says + ", which edge " + edge + " is", certificate_.edge_line + e, ""};
      }
      edge = e;
    }
  }

  [[noreturn]] void refuse(Index at, Index s, const char* problem) const {
    const Index e = edges_[at];
    throw Refusal{std::string("edge ") + e + ", piece " + (at - begins_[s]) + " of segment " + s +
                      ", " + problem,
                  certificate_.edge_line + e,
                  text_of(certificate_.vertices[certificate_.edges[e].head])};
  }

  const Input& input_;
  const Certificate& certificate_;
  std::vector<Index> begins_, edges_;
};

/// The reason of each vertex, kNone where there is none.
class Definers {
 public:
  Definers(const Input& input, const Certificate& certificate)
      : input_(input), certificate_(certificate), definers_(certificate.vertices.size()) {
    ends();
    crossings();
    points();
  }

  const std::vector<Definer>& get() const { return definers_; }

 private:
  bool is_known(Index v) const { return definers_[v].first != kNone; }

  void ends() {
    const Lists& segments = certificate_.segments;
    std::vector<Index>& least = end_segment_;
    least.assign(definers_.size(), kNone);
    for (Index e = 0; e < certificate_.edges.size(); ++e) {
      const auto [tail, head] = certificate_.edges[e];
      for (const Index* s = segments.begin(e); s != segments.end(e); ++s) {
        const Segment& segment = input_.segments[*s];
        if (*s < least[tail] && certificate_.vertices[tail] == segment.first) end(tail, *s, false);
        if (*s < least[head] && certificate_.vertices[head] == segment.last) end(head, *s, true);
      }
    }
  }
  void end(Index v, Index s, bool last) {
    end_segment_[v] = s;
    definers_[v] = {Definer::Kind::End, s, last != input_.segments[s].reversed ? 1U : 0U};
  }

  /// The segments through a vertex are those of its edges, and those of one edge are parallel: so
  /// its least decides.
  void crossings() {
    std::vector<Index> least(definers_.size(), kNone);
    for_each_segment_at_vertex([&](Index v, Index s) { least[v] = std::min(least[v], s); });
    std::vector<Index> other(definers_.size(), kNone);
    for_each_segment_at_vertex([&](Index v, Index s) {
      if (s < other[v] && turn(input_.segments[s].line, input_.segments[least[v]].line) != 0) {
        other[v] = s;
      }
    });
    for (Index v = 0; v < definers_.size(); ++v) {
      if (!is_known(v) && other[v] != kNone)
        definers_[v] = {Definer::Kind::Cross, least[v], other[v]};
    }
  }
  template <class Visit>
  void for_each_segment_at_vertex(const Visit& visit) const {
    for (Index e = 0; e < certificate_.edges.size(); ++e) {
      const Index s = *certificate_.segments.begin(e);
      if (!is_known(certificate_.edges[e].tail)) visit(certificate_.edges[e].tail, s);
      if (!is_known(certificate_.edges[e].head)) visit(certificate_.edges[e].head, s);
    }
  }

  void points() {
    const std::vector<Point>& vertices = certificate_.vertices;
    for (Index p = 0; p < input_.points.size(); ++p) {
      const auto found =
          std::lower_bound(vertices.begin(), vertices.end(), input_.points[p],
                           [](const Point& a, const Point& b) { return compare(a, b) < 0; });
      if (found == vertices.end() || !(*found == input_.points[p])) {
        throw Refusal{std::string("no vertex is at point ") + p + " of the input",
                      certificate_.vertex_line, text_of(input_.points[p])};
      }
      const auto v = static_cast<Index>(found - vertices.begin());
      if (!is_known(v)) definers_[v] = {Definer::Kind::Point, p, kNone};
    }
  }

  const Input& input_;
  const Certificate& certificate_;
  std::vector<Definer> definers_;
  std::vector<Index> end_segment_;
};

std::string name_of(const Definer& definer) {
  switch (definer.kind) {
    case Definer::Kind::End:
      return std::string("end ") + definer.first + " " + definer.second;
    case Definer::Kind::Cross:
      return std::string("cross ") + definer.first + " " + definer.second;
    default:
      return std::string("point ") + definer.first;
  }
}

}  // namespace

void check_order(const Certificate& certificate) {
  const std::vector<Point>& vertices = certificate.vertices;
  for (Index v = 1; v < vertices.size(); ++v) {
    const int order = compare(vertices[v - 1], vertices[v]);
    if (order < 0) continue;
    const std::string before = std::to_string(v - 1);
    throw Refusal{std::string("vertex ") + v +
                      (order == 0 ? " is where vertex " + before + " is"
                                  : " should come before vertex " + before),
                  certificate.vertex_line + v, text_of(vertices[v])};
  }
  const std::vector<Edge>& edges = certificate.edges;
  for (Index e = 1; e < edges.size(); ++e) {
    const auto ends = [&](Index i) { return std::pair(edges[i].tail, edges[i].head); };
    if (ends(e - 1) < ends(e)) continue;
    throw Refusal{
        std::string("edge ") + e +
            (ends(e - 1) == ends(e) ? " has the ends of edge " : " should come before edge ") +
            (e - 1),
        certificate.edge_line + e, text_of(vertices[edges[e].tail])};
  }
}

void check_covering(const Input& input, const Certificate& certificate) {
  const Chains chains(input, certificate);
  for (Index s = 0; s < input.segments.size(); ++s) chains.check(s);
}

void check_definers(const Input& input, const Certificate& certificate) {
  const Definers definers(input, certificate);
  for (Index v = 0; v < certificate.vertices.size(); ++v) {
    const Definer& right = definers.get()[v];
    if (right == certificate.definers[v]) continue;
    const std::string vertex = std::string("vertex ") + v;
    throw Refusal{right.first == kNone
                      ? vertex +
                            " has no reason: no segment ends there, no two that are not parallel "
                            "meet there, no point of the input is there"
                      : vertex + " is there for the reason " + name_of(right) + ", not " +
                            name_of(certificate.definers[v]),
                  certificate.vertex_line + v, text_of(certificate.vertices[v])};
  }
}

}  // namespace plumbline_verify
