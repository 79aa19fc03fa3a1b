// Boost.Geometry: polygons united, or combined by symmetric difference, one by one.
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/version.hpp>

#include "adapter.hpp"

namespace {

namespace bg = boost::geometry;
using study::Clock;
using study::Model;
using study::Numbering;
using study::Ring;

using Point = bg::model::d2::point_xy<double>;
constexpr bool kClockwise = false;
using Polygon = bg::model::polygon<Point, kClockwise>;
using Polygons = bg::model::multi_polygon<Polygon>;

Polygon polygon_of(const std::vector<study::Point>& ring) {
  Polygon polygon;
  for (const study::Point& p : ring) polygon.outer().emplace_back(p[0], p[1]);
  bg::correct(polygon);  // closed, and counter-clockwise
  return polygon;
}

Ring ring_of(const Polygon::ring_type& points, Numbering& number) {
  Ring ring;
  for (const Point& p : points) ring.push_back(number({p.x(), p.y()}));
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

Model model_of(const Polygons& polygons) {
  Model model;
  Numbering number;
  model.polygons.emplace();
  for (const Polygon& polygon : polygons) {
    std::vector<Ring> rings{ring_of(polygon.outer(), number)};
    for (const auto& hole : polygon.inners()) rings.push_back(ring_of(hole, number));
    for (const Ring& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        model.edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
      }
    }
    model.polygons->push_back(std::move(rings));
  }
  model.edges = study::each_once(std::move(model.edges));
  model.vertices = std::move(number).points();
  return model;
}

Model fold(const study::Rings& given, Clock& clock) {
  std::vector<Polygon> polygons;
  for (const auto& ring : given.rings) polygons.push_back(polygon_of(ring));
  Polygons all;
  clock.start();
  for (const Polygon& polygon : polygons) {
    Polygons next;
    if (given.is_even_odd) {
      bg::sym_difference(all, polygon, next);
    } else {
      bg::union_(all, polygon, next);
    }
    all = std::move(next);
  }
  clock.stop();
  return model_of(all);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string version =
      std::to_string(BOOST_VERSION / 100000) + "." + std::to_string(BOOST_VERSION / 100 % 1000);
  return study::serve({"boost_geometry",
                       "Boost.Geometry",
                       version,
                       "Boost.Geometry",
                       "BSL-1.0",
                       {{"fold", "union_ or sym_difference, one by one", "none", 0,
                         "reference: union_, sym_difference, of two geometries; correct, which "
                         "closes and orients polygons",
                         nullptr, "", "", fold}},
                       {"simple evenodd", "simple nonzero"}},
                      argc, argv);
}
