// overlay_geos FILE: OverlayNG on two multipolygons in doubles.

#include <geos_c.h>

#include "workload.hpp"

namespace {

GEOSGeometry* multipolygon(const std::vector<workload::Ring>& rings) {
  std::vector<GEOSGeometry*> polygons;
  for (const workload::Ring& ring : rings) {
    GEOSCoordSequence* points = GEOSCoordSeq_create(static_cast<unsigned>(ring.size() + 1), 2);
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      const auto [x, y] = ring[i % ring.size()];
      GEOSCoordSeq_setXY(points, static_cast<unsigned>(i), static_cast<double>(x),
                         static_cast<double>(y));
    }
    polygons.push_back(GEOSGeom_createPolygon(GEOSGeom_createLinearRing(points), nullptr, 0));
  }
  return GEOSGeom_createCollection(GEOS_MULTIPOLYGON, polygons.data(),
                                   static_cast<unsigned>(polygons.size()));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const workload::Workload given = workload::read(argv[1]);
  if (given.validity != "valid") return 3;
  initGEOS(nullptr, nullptr);
  const GEOSGeometry *a = multipolygon(given.sets[0]), *b = multipolygon(given.sets[1]);
  workload::Measure measure;
  const GEOSGeometry* result =
      given.operation == "xor" ? GEOSSymDifference(a, b) : GEOSIntersection(a, b);
  measure.end();
  if (result == nullptr) return 1;
  double area = 0;
  GEOSArea(result, &area);
  measure.print(static_cast<std::size_t>(GEOSGetNumGeometries(result)), area);
}
