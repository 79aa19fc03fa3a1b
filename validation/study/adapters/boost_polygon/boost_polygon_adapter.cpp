// Boost.Polygon: segments on a grid of 32-bit integers, cut where they cross. It has no faces of
// lines.
#include <boost/polygon/polygon.hpp>
#include <boost/version.hpp>

#include <cmath>
#include <limits>

#include "adapter.hpp"

namespace {

using study::Clock;
using study::Edge;
using study::Model;
using study::Numbering;
using Number = int;
using GridPoint = boost::polygon::point_data<Number>;
using GridSegment = boost::polygon::segment_data<Number>;

GridPoint on_grid(const study::Point& point, double scale) {
  std::array<Number, 2> result{};
  for (std::size_t k = 0; k < 2; ++k) {
    const double x = std::round(point[k] * scale);
    if (!(std::abs(x) <= std::numeric_limits<Number>::max())) {
      throw study::EngineError("OutOfRange",
                               "coordinates times the scale are beyond 32-bit integers");
    }
    result[k] = static_cast<Number>(x);
  }
  return {result[0], result[1]};
}

Model noded(const std::vector<study::Segment>& segments, Clock& clock, double grid) {
  const double scale = 1 / grid;
  std::vector<GridSegment> input;
  for (const study::Segment& s : segments) {
    const GridSegment rounded(on_grid(s[0], scale), on_grid(s[1], scale));
    if (rounded.low() != rounded.high()) input.push_back(rounded);
  }
  std::vector<std::pair<std::size_t, GridSegment>> pieces;
  clock.start();
  boost::polygon::intersect_segments(pieces, input.begin(), input.end());
  clock.stop();
  Numbering number;
  const auto numbered = [&](const GridPoint& p) { return number({p.x() / scale, p.y() / scale}); };
  std::vector<Edge> edges;
  for (const auto& [source, piece] : pieces)
    edges.push_back({numbered(piece.low()), numbered(piece.high())});
  Model model;
  model.edges = study::each_once(std::move(edges));
  model.vertices = std::move(number).points();
  return model;
}

study::Configuration configuration(const std::string& name, double scale) {
  return {"scale-" + name,
          "intersect_segments, scale " + name,
          "grid",
          1 / scale,
          "segment concept: intersect_segments, on integral coordinates, which the user scales",
          noded,
          "integers",
          "intersect_segments"};
}

}  // namespace

int main(int argc, char** argv) {
  const std::string version =
      std::to_string(BOOST_VERSION / 100000) + "." + std::to_string(BOOST_VERSION / 100 % 1000);
  return study::serve(
      {"boost_polygon",
       "Boost.Polygon",
       version,
       "Boost.Polygon",
       "BSL-1.0",
       {configuration("1e4", 1e4), configuration("1e6", 1e6), configuration("1e8", 1e8)}},
      argc, argv);
}
