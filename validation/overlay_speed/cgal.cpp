// overlay_cgal FILE: CGAL's Boolean_set_operations_2 on two sets of polygons, exactly.

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

#include "workload.hpp"

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;
using Set = CGAL::Polygon_set_2<Kernel>;

namespace {

Set set_of(const std::vector<workload::Ring>& rings) {
  std::vector<Polygon> polygons;
  for (const workload::Ring& ring : rings) {
    Polygon polygon;
    for (const auto& [x, y] : ring) {
      polygon.push_back({static_cast<double>(x), static_cast<double>(y)});
    }
    polygons.push_back(std::move(polygon));
  }
  Set set;
  set.insert(polygons.begin(), polygons.end());
  return set;
}

double area_of(const Polygon& polygon) { return CGAL::to_double(polygon.area()); }

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const workload::Workload given = workload::read(argv[1]);
  if (given.validity != "valid") return 3;
  Set a = set_of(given.sets[0]);
  const Set b = set_of(given.sets[1]);
  workload::Measure measure;
  given.operation == "xor" ? a.symmetric_difference(b) : a.intersection(b);
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> result;
  a.polygons_with_holes(std::back_inserter(result));
  measure.end();
  double area = 0;
  for (const auto& polygon : result) {
    area += area_of(polygon.outer_boundary());
    for (const auto& hole : polygon.holes()) area += area_of(hole);
  }
  measure.print(result.size(), area);
}
