// GEOS by its C API: noded, then polygonized. The version is that of the library it runs with.
#include <geos_c.h>

#include <cstdarg>
#include <cstdio>
#include <functional>
#include <memory>

#include "adapter.hpp"

namespace {

using study::Clock;
using study::Edge;
using study::Model;
using study::Numbering;
using study::Ring;
using study::Segment;

constexpr double kGrid = 1e-9;

// GEOS's handle, with the last message that it left.
class Geos {
 public:
  Geos() : handle_(GEOS_init_r()) {
    GEOSContext_setErrorMessageHandler_r(
        handle_, [](const char* text, void* of) { *static_cast<std::string*>(of) = text; },
        &message_);
  }
  ~Geos() { GEOS_finish_r(handle_); }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  using Geometry = std::unique_ptr<GEOSGeometry, std::function<void(GEOSGeometry*)>>;

  // A result of GEOS; null is that it failed. Its messages start with the name of the exception.
  Geometry geometry(GEOSGeometry* made) const {
    if (made == nullptr) {
      const std::size_t colon = message_.find(':');
      throw study::EngineError(
          colon == std::string::npos ? "GEOSException" : message_.substr(0, colon), message_);
    }
    return {made, [handle = handle_](GEOSGeometry* g) { GEOSGeom_destroy_r(handle, g); }};
  }
  operator GEOSContextHandle_t() const { return handle_; }

 private:
  GEOSContextHandle_t handle_;
  std::string message_;
};

Geos::Geometry lines_of(const Geos& geos, const std::vector<Segment>& segments) {
  std::vector<GEOSGeometry*> lines;
  for (const Segment& s : segments) {
    GEOSCoordSequence* points = GEOSCoordSeq_create_r(geos, 2, 2);
    for (unsigned i = 0; i < 2; ++i) GEOSCoordSeq_setXY_r(geos, points, i, s[i][0], s[i][1]);
    lines.push_back(GEOSGeom_createLineString_r(geos, points));
  }
  return geos.geometry(GEOSGeom_createCollection_r(geos, GEOS_MULTILINESTRING, lines.data(),
                                                   static_cast<unsigned>(lines.size())));
}

Ring points_of(const Geos& geos, const GEOSGeometry* line, Numbering& number) {
  const GEOSCoordSequence* points = GEOSGeom_getCoordSeq_r(geos, line);
  unsigned count = 0;
  GEOSCoordSeq_getSize_r(geos, points, &count);
  Ring result;
  for (unsigned i = 0; i < count; ++i) {
    study::Point p{};
    GEOSCoordSeq_getXY_r(geos, points, i, p.data(), p.data() + 1);
    result.push_back(number(p));
  }
  return result;
}

std::vector<Ring> rings_of(const Geos& geos, const GEOSGeometry* polygon, Numbering& number) {
  std::vector<Ring> rings{points_of(geos, GEOSGetExteriorRing_r(geos, polygon), number)};
  const int holes = GEOSGetNumInteriorRings_r(geos, polygon);
  for (int i = 0; i < holes; ++i) {
    rings.push_back(points_of(geos, GEOSGetInteriorRingN_r(geos, polygon, i), number));
  }
  for (Ring& ring : rings) ring.pop_back();  // the first again
  return rings;
}

Model model_of(const Geos& geos, const GEOSGeometry* noded, const GEOSGeometry* polygons) {
  Model model;
  Numbering number;
  std::vector<Edge> edges;
  const int lines = GEOSGetNumGeometries_r(geos, noded);
  for (int i = 0; i < lines; ++i) {
    const GEOSGeometry* part = GEOSGetGeometryN_r(geos, noded, i);
    if (GEOSisEmpty_r(geos, part) == 1) continue;
    const Ring line = points_of(geos, part, number);
    for (std::size_t k = 1; k < line.size(); ++k) edges.push_back({line[k - 1], line[k]});
  }
  model.edges = study::each_once(std::move(edges));
  model.polygons.emplace();
  const int faces = GEOSGetNumGeometries_r(geos, polygons);
  for (int i = 0; i < faces; ++i) {
    const GEOSGeometry* polygon = GEOSGetGeometryN_r(geos, polygons, i);
    if (GEOSisEmpty_r(geos, polygon) == 0)
      model.polygons->push_back(rings_of(geos, polygon, number));
  }
  model.vertices = std::move(number).points();
  return model;
}

using Node = std::function<Geos::Geometry(const Geos&, const GEOSGeometry*, double)>;

auto noded_by(Node node) {
  return [node](const std::vector<Segment>& segments, Clock& clock, double grid) {
    const Geos geos;
    const Geos::Geometry lines = lines_of(geos, segments);
    clock.start();
    const Geos::Geometry noded = node(geos, lines.get(), grid);
    const GEOSGeometry* const only = noded.get();
    const Geos::Geometry polygons = geos.geometry(GEOSPolygonize_r(geos, &only, 1));
    clock.stop();
    return model_of(geos, noded.get(), polygons.get());
  };
}

Geos::Geometry node(const Geos& geos, const GEOSGeometry* lines, double) {
  return geos.geometry(GEOSNode_r(geos, lines));
}

Geos::Geometry unary_union(const Geos& geos, const GEOSGeometry* lines, double) {
  return geos.geometry(GEOSUnaryUnion_r(geos, lines));
}

Geos::Geometry union_on_grid(const Geos& geos, const GEOSGeometry* lines, double grid) {
  return geos.geometry(GEOSUnaryUnionPrec_r(geos, lines, grid));
}

Geos::Geometry set_precision_then_node(const Geos& geos, const GEOSGeometry* lines, double grid) {
  const Geos::Geometry on_grid = geos.geometry(GEOSGeom_setPrecision_r(geos, lines, grid, 0));
  return node(geos, on_grid.get(), grid);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string version =
      std::string(GEOSversion()).substr(0, std::string(GEOSversion()).find('-'));
  return study::serve(
      {"geos",
       "GEOS (Debian)",
       version,
       "GEOS " + version,
       "LGPL-2.1",
       {
           {"node", "GEOSNode", "none", 0,
            "geos_c.h, GEOSNode: 'no lines cross each other, and all touching occurs at end "
            "points'",
            noded_by(node)},
           {"unary-union", "GEOSUnaryUnion", "none", 0,
            "geos_c.h, GEOSPolygonize: edges that are not noded 'run through GEOSUnaryUnion() "
            "first'",
            noded_by(unary_union)},
           {"union-grid-1e-9", "GEOSUnaryUnionPrec, grid 1e-9", "grid", kGrid,
            "geos_c.h, GEOSUnaryUnionPrec: 'all the vertices of the output geometry must fall on "
            "the grid'",
            noded_by(union_on_grid), "", "GEOSUnaryUnionPrec"},
           {"set-precision-1e-9-node", "GEOSGeom_setPrecision 1e-9, GEOSNode", "grid", kGrid,
            "what shapely's configuration of this name calls; geos_c.h promises the grid for "
            "overlay functions only",
            noded_by(set_precision_then_node), "some", "GEOSGeom_setPrecision, GEOSNode"},
       }},
      argc, argv);
}
