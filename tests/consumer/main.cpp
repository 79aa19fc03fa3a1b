#include <iostream>
#include <plumbline/plumbline.hpp>

// Two diagonals of a square meet exactly in its centre.
int main() {
  using plumbline::parse_decimal;
  plumbline::SegmentSet cross;
  const auto source = cross.add_source({});
  cross.add(plumbline::Segment{{0, 0}, {parse_decimal("0.2"), parse_decimal("0.2")}}, source);
  cross.add(plumbline::Segment{{0, parse_decimal("0.2")}, {parse_decimal("0.2"), 0}}, source);

  const plumbline::ExactComplex complex = plumbline::arrange(cross);
  const bool right =
      complex.vertices.size() == 5 && complex.edge_count() == 4 && complex.face_count() == 1 &&
      complex.vertices[2] == plumbline::Point{parse_decimal("0.1"), parse_decimal("0.1")};
  std::cout << complex.vertices.size() << " vertices, " << complex.edge_count() << " edges, "
            << complex.face_count() << " face\n";
  return right ? 0 : 1;
}
