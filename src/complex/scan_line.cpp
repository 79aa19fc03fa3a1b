#include "complex/scan_line.hpp"

namespace plumbline {

bool ScanLine::meets(EdgeId e) const {
  const Edge& edge = complex_.edges[e];
  return complex_.vertices[edge.tail].x <= x_ && x_ < complex_.vertices[edge.head].x;
}

bool ScanLine::passes_below(EdgeId e, const Point& p) const {
  const Edge& edge = complex_.edges[e];
  return orientation(complex_.vertices[edge.tail], complex_.vertices[edge.head], p) > 0;
}

bool ScanLine::above(EdgeId e, EdgeId f) const {
  const int by_height = cmp(height(e), height(f));
  return by_height != 0 ? by_height > 0 : slope(e) > slope(f);
}

Rational ScanLine::height(EdgeId e) const {
  const Point& tail = complex_.vertices[complex_.edges[e].tail];
  return tail.y + slope(e) * (x_ - tail.x);
}

Rational ScanLine::slope(EdgeId e) const {
  const Point& tail = complex_.vertices[complex_.edges[e].tail];
  const Point& head = complex_.vertices[complex_.edges[e].head];
  return (head.y - tail.y) / (head.x - tail.x);
}

FaceId face_above(const Incidences& complex, std::optional<EdgeId> e) {
  return e ? complex.halfedge_face[halfedge(*e, false)] : kUnbounded;
}

}  // namespace plumbline
