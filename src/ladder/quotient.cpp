#include "ladder/quotient.hpp"

#include <algorithm>
#include <utility>

namespace plumbline {
namespace {

/// Grows with the foot of the perpendicular from v, from the tail of the edge to its head.
Rational along(const ExactComplex& complex, EdgeId e, VertexId v) {
  const Point& a = complex.vertices[complex.edges[e].tail];
  const Point& b = complex.vertices[complex.edges[e].head];
  const Point& p = complex.vertices[v];
  return (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);
}

}  // namespace

Quotient::Quotient(const ExactComplex& complex)
    : complex_(complex),
      vertices_(complex.vertices.size()),
      components_(complex.vertices.size()),
      clusters_(complex.vertices.size()),
      connected_(complex.vertices.size()),
      pieces_at_(complex.vertices.size()) {
  pieces_.reserve(complex.edge_count());
  multiplicity_.reserve(complex.edge_count());
  for (const Edge& e : complex.edges) {
    add_piece(e.tail, e.head);
    connect(e.tail, e.head);
  }
}

std::uint64_t Quotient::key(const Piece& piece) const {
  const auto [low, high] = std::minmax({cluster(piece.from), cluster(piece.to)});
  return std::uint64_t{low} << 32U | high;
}

void Quotient::count(const Piece& piece) {
  if (cluster(piece.from) != cluster(piece.to)) ++multiplicity_[key(piece)];
}

void Quotient::discount(const Piece& piece) {
  if (cluster(piece.from) == cluster(piece.to)) return;
  const auto entry = multiplicity_.find(key(piece));
  if (--entry->second == 0) multiplicity_.erase(entry);
}

void Quotient::connect(VertexId v, VertexId w) {
  if (connected_.find(v) == connected_.find(w)) return;
  connected_.unite(v, w);
  --components_;
}

void Quotient::merge(VertexId v, VertexId w) {
  std::uint32_t large = cluster(v), small = cluster(w);
  if (large == small) return;
  if (pieces_at_[large].size() < pieces_at_[small].size()) std::swap(large, small);
  // A piece between the two stands in both lists and is discounted once: it is a loop afterwards.
  for (const std::uint32_t piece : pieces_at_[small]) discount(pieces_[piece]);
  clusters_.unite_into(large, small);
  for (const std::uint32_t piece : pieces_at_[small]) {
    count(pieces_[piece]);
    pieces_at_[large].push_back(piece);
  }
  std::vector<std::uint32_t>().swap(pieces_at_[small]);
  --vertices_;
  connect(v, w);
}

std::uint32_t Quotient::add_piece(VertexId from, VertexId to) {
  const auto number = static_cast<std::uint32_t>(pieces_.size());
  pieces_.push_back({from, to});
  pieces_at_[cluster(from)].push_back(number);
  pieces_at_[cluster(to)].push_back(number);
  count(pieces_.back());
  return number;
}

void Quotient::lead_through(EdgeId e, VertexId v) {
  std::vector<Stop>& stops = stops_[e];
  if (stops.empty()) stops.push_back({0, complex_.edges[e].tail, static_cast<std::uint32_t>(e)});
  const Rational foot = along(complex_, e, v);
  const auto next = std::partition_point(stops.begin() + 1, stops.end(), [&](const Stop& stop) {
    const int order = cmp(stop.along, foot);
    return order != 0 ? order < 0 : stop.vertex <= v;
  });
  if (std::prev(next)->vertex == v) return;
  std::uint32_t& before = std::prev(next)->piece;
  const Piece cut = pieces_[before];
  discount(cut);
  pieces_[before].to = cut.from;  // counts for nothing from now on
  before = add_piece(cut.from, v);
  stops.insert(next, {foot, v, add_piece(v, cut.to)});
  connect(v, cut.from);
}

bool Quotient::is_led_through_others(EdgeId e) const {
  const auto found = stops_.find(e);
  if (found == stops_.end()) return false;
  const std::uint32_t tail = cluster(complex_.edges[e].tail),
                      head = cluster(complex_.edges[e].head);
  return std::any_of(found->second.begin(), found->second.end(), [&](const Stop& stop) {
    const std::uint32_t at = cluster(stop.vertex);
    return at != tail && at != head;
  });
}

}  // namespace plumbline
