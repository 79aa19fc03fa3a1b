// The peer that most users pick: GEOS, in doubles.

#include <geos_c.h>

#include <stdexcept>
#include <utility>

#include "contenders.hpp"

namespace plumbline::bench {
namespace {

/// A context of GEOS's reentrant interface; its errors become exceptions.
class Context {
 public:
  Context() : handle_(GEOS_init_r()) {
    GEOSContext_setErrorMessageHandler_r(
        handle_, [](const char* text, void* self) { static_cast<Context*>(self)->error_ = text; },
        this);
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() { GEOS_finish_r(handle_); }

  GEOSContextHandle_t handle() const { return handle_; }
  /// The pointer that a call returned.
  template <class T>
  T* checked(T* returned) const {
    if (returned == nullptr) throw std::runtime_error("GEOS: " + error_);
    return returned;
  }

 private:
  GEOSContextHandle_t handle_;
  std::string error_;
};

using Geometry = std::shared_ptr<GEOSGeometry>;

Geometry owned(const std::shared_ptr<Context>& context, GEOSGeometry* geometry) {
  return {context->checked(geometry),
          [context](GEOSGeometry* g) { GEOSGeom_destroy_r(context->handle(), g); }};
}

Geometry multi_line(const std::shared_ptr<Context>& context, const SegmentSet& input) {
  GEOSContextHandle_t h = context->handle();
  std::vector<GEOSGeometry*> lines;
  lines.reserve(input.segments.size());
  for (const Segment& s : input.segments) {
    GEOSCoordSequence* points = context->checked(GEOSCoordSeq_create_r(h, 2, 2));
    for (unsigned i = 0; i < 2; ++i) {
      const PointD p = nearest(i == 0 ? s.a : s.b);
      GEOSCoordSeq_setXY_r(h, points, i, p.x, p.y);
    }
    lines.push_back(context->checked(GEOSGeom_createLineString_r(h, points)));
  }
  return owned(context, GEOSGeom_createCollection_r(h, GEOS_MULTILINESTRING, lines.data(),
                                                    static_cast<unsigned>(lines.size())));
}

/// Adds the points and edges of a line.
void add_line(const Context& context, const GEOSGeometry* line, std::vector<PointD>& points,
              std::vector<std::pair<PointD, PointD>>& edges) {
  GEOSContextHandle_t h = context.handle();
  const GEOSCoordSequence* sequence = context.checked(GEOSGeom_getCoordSeq_r(h, line));
  unsigned size = 0;
  GEOSCoordSeq_getSize_r(h, sequence, &size);
  PointD last;
  for (unsigned i = 0; i < size; ++i) {
    PointD p;
    GEOSCoordSeq_getXY_r(h, sequence, i, &p.x, &p.y);
    points.push_back(p);
    if (i > 0) edges.push_back(std::minmax(last, p));
    last = p;
  }
}

template <class T>
std::size_t distinct(std::vector<T>& items) {
  std::sort(items.begin(), items.end());
  return static_cast<std::size_t>(std::unique(items.begin(), items.end()) - items.begin());
}

Cells count(const Context& context, const GEOSGeometry* noded, const GEOSGeometry* polygons) {
  GEOSContextHandle_t h = context.handle();
  std::vector<PointD> points;
  std::vector<std::pair<PointD, PointD>> edges;
  const int lines = GEOSGetNumGeometries_r(h, noded);
  for (int i = 0; i < lines; ++i) {
    add_line(context, context.checked(GEOSGetGeometryN_r(h, noded, i)), points, edges);
  }
  return {distinct(points), distinct(edges),
          static_cast<std::size_t>(GEOSGetNumGeometries_r(h, polygons)) + 1};
}

}  // namespace

Job prepare_geos(const SegmentSet& input) {
  const auto context = std::make_shared<Context>();
  return [context, lines = multi_line(context, input)] {
    GEOSContextHandle_t h = context->handle();
    const Geometry noded = owned(context, GEOSUnaryUnion_r(h, lines.get()));
    const GEOSGeometry* all = noded.get();
    const Geometry polygons = owned(context, GEOSPolygonize_r(h, &all, 1));
    return Outcome{polygons, [context, noded, polygons] {
                     return count(*context, noded.get(), polygons.get());
                   }};
  };
}

std::string geos_version() { return GEOSversion(); }

}  // namespace plumbline::bench
