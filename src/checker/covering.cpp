// Step 2: the edges cover the segments exactly and nothing else.

#include <string>

#include "refusal.hpp"
#include "steps.hpp"

namespace plumbline_checker {
namespace {

/// For each segment its edges by position. (Edges name segments that exist, and each names one.)
Lists chains_of(const Input& input, const Certificate& certificate) {
  Lists chains;
  chains.begins.assign(input.segments.size() + 1, 0);
  for (const Index s : certificate.segments.values) ++chains.begins[s + 1];
  for (std::size_t s = 0; s < input.segments.size(); ++s) chains.begins[s + 1] += chains.begins[s];
  chains.values.assign(chains.begins.back(), kNone);
  for (Index e = 0; e < certificate.edges.size(); ++e) {
    for (Index at = certificate.segments.begins[e]; at < certificate.segments.begins[e + 1]; ++at) {
      const Index s = certificate.segments.values[at];
      const Index piece = certificate.pieces[at];
      const Index place = chains.begins[s] + piece;
      const bool is_beyond = piece >= chains.begins[s + 1] - chains.begins[s];
      if (is_beyond || chains.values[place] != kNone) {
        certificate.refuse_edge(
            e,
            "is said to be piece " + std::to_string(piece) + " of segment " + std::to_string(s) +
                (is_beyond ? ", which fewer edges name" : ", which another edge is"),
            certificate.vertices[certificate.edges[e].tail]);
      }
      chains.values[place] = e;
    }
  }
  return chains;
}

}  // namespace

void check_covering(const Input& input, const Certificate& certificate) {
  const Lists chains = chains_of(input, certificate);
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const Segment& segment = input.segments[s];
    const std::string name = "segment " + std::to_string(s);
    if (chains.begin(s) == chains.end(s)) {
      throw Refusal{"no edge covers " + name, certificate.edge_line, text_of(segment.first)};
    }
    for (const Index* piece = chains.begin(s); piece != chains.end(s); ++piece) {
      const Edge& edge = certificate.edges[*piece];
      const Point& tail = certificate.vertices[edge.tail];
      const Point& head = certificate.vertices[edge.head];
      const bool is_last = piece + 1 == chains.end(s);
      if (piece == chains.begin(s)) {
        if (!(tail == segment.first)) {
          certificate.refuse_edge(*piece, "does not start at the first end of " + name, tail);
        }
      } else if (edge.tail != certificate.edges[piece[-1]].head) {
        certificate.refuse_edge(
            *piece, "does not go on where the piece of " + name + " before it ends", tail);
      }
      if (is_last && !(head == segment.last)) {
        certificate.refuse_edge(*piece, "does not end at the last end of " + name, head);
      }
      if (!is_last && side(segment.line, head) != 0) {
        certificate.refuse_edge(*piece, "does not lie on " + name, head);
      }
    }
  }
}

}  // namespace plumbline_checker
