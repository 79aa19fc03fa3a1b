#include <iostream>
#include <plumbline/cgal.hpp>

// The complex of an arrangement is what arranging the segments gives.
int main() {
  plumbline::SegmentSet cross;
  const auto source = cross.add_source({});
  cross.add(plumbline::Segment{{0, 0}, {2, 2}}, source);
  cross.add(plumbline::Segment{{0, 2}, {2, 0}}, source);

  const plumbline::cgal::Arrangement arrangement = plumbline::cgal::arrangement(cross);
  const plumbline::ExactComplex complex = plumbline::cgal::to_complex(arrangement, cross);
  std::cout << arrangement.number_of_vertices() << " vertices, " << arrangement.number_of_edges()
            << " edges, " << arrangement.number_of_faces() << " face\n";
  const bool right = arrangement.number_of_vertices() == 5 && arrangement.number_of_edges() == 4 &&
                     complex.vertices.size() == 5 && complex.edge_count() == 4;
  return right ? 0 : 1;
}
