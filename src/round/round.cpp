#include "plumbline/round.hpp"

#include <array>
#include <optional>
#include <utility>

#include "complex/planarity.hpp"
#include "complex/validate.hpp"
#include "plumbline/error.hpp"
#include "round/grid.hpp"
#include "round/hot_pixels.hpp"
#include "round/images.hpp"
#include "round/sides.hpp"
#include "round/snap.hpp"

namespace plumbline {
namespace {

using namespace round_steps;

/// What `validate` decides, without looking for what is wrong.
bool is_valid(const ExactComplex& complex) {
  Violations violations;
  validate_incidences(complex, violations);
  return violations.empty() && is_certified(complex);
}

Lists<VertexId> straight_chains(const ExactComplex& complex, const Places& places) {
  Lists<VertexId> chains;
  for (const auto& [tail, head] : complex.edges) {
    chains.push_back(std::vector{places.of_vertex[tail], places.of_vertex[head]});
  }
  return chains;
}

/// The complex with its vertices at these places and the same incidences, if that is a valid one
/// and no vertex goes past an edge.
std::optional<ExactComplex> moved(const ExactComplex& complex, const Places& places) {
  if (places.points.size() != complex.vertices.size()) return {};
  ExactComplex result = complex;
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    result.vertices.replace(v, places.points[places.of_vertex[v]]);
  }
  result = canonical(std::move(result));
  if (!is_valid(result)) return {};
  if (vertex_past_edge(complex, result, places.of_vertex, straight_chains(complex, places))) {
    return {};
  }
  return result;
}

Places nearest_doubles(const ExactComplex& complex) {
  std::vector<Point> points;
  points.reserve(complex.vertices.size());
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    points.push_back(exact(complex.vertices.nearest(v)));
  }
  return distinct(std::move(points));
}

Places on_grid(const Places& centres, const Rational& spacing) {
  Places result = centres;
  for (Point& p : result.points) p = {p.x * spacing, p.y * spacing};
  return result;
}

void ensure_coordinates_within_limit(const ExactComplex& complex) {
  static_assert(WidePoint::kBits < kMaxCoordinateBits);
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    if (complex.vertices.wide(v) != nullptr) continue;
    const Point p = complex.vertices[v];
    if (!is_within_limit(p)) {
      throw Error(ErrorCode::Limit, "a coordinate is beyond 8.7e99", {}, to_text(p));
    }
  }
}

Rounding finished(const ExactComplex& complex, const Grid& grid, Rounding rounding,
                  const Lists<VertexId>& chains) {
  rounding.edge_image = edge_images(rounding.complex, chains);
  rounding.face_origin =
      face_origins(complex, rounding.complex, rounding.vertex_image, rounding.edge_image);
  // Simple rounding has looked at all sides itself.
  rounding.has_same_incidences() ? ensure_images(complex, grid, rounding)
                                 : ensure_rounded(complex, grid, rounding);
  if (grid.decimals) {
    rounding.valid_as_doubles = is_kept_by_simple_rounding(rounding.complex, Grid{});
  }
  return rounding;
}

bool is_on_grid(const ExactComplex& complex, const Grid& grid) {
  for (const Point& p : complex.vertices) {
    if (!is_on(grid, p.x) || !is_on(grid, p.y)) return false;
  }
  return true;
}

/// A complex on the grid is its own rounding: valid, and nothing moves.
Rounding unchanged(const ExactComplex& complex, const Grid& grid, Rounding result) {
  result.method = grid.decimals ? RoundingMethod::NearestPoints : RoundingMethod::NearestDoubles;
  result.complex = complex;
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) result.vertex_image.emplace_back(v);
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    result.edge_image.push_back(std::array{halfedge(EdgeId(e), false)});
  }
  for (std::size_t f = 0; f < complex.face_count(); ++f) result.face_origin.emplace_back(f);
  if (grid.decimals) result.valid_as_doubles = is_kept_by_simple_rounding(complex, Grid{});
  return result;
}

/// The uniform grid that simple rounding goes to.
Places nearest_points(const ExactComplex& complex, const Rational& spacing) {
  std::vector<Point> points;
  points.reserve(complex.vertices.size());
  for (const Point& p : complex.vertices) {
    points.push_back(
        {nearest_integer(p.x / spacing) * spacing, nearest_integer(p.y / spacing) * spacing});
  }
  return distinct(std::move(points));
}

}  // namespace

bool is_kept_by_simple_rounding(const ExactComplex& complex, const Grid& grid) {
  ensure_coordinates_within_limit(complex);
  return moved(complex, grid.decimals ? nearest_points(complex, spacing(complex, grid))
                                      : nearest_doubles(complex))
      .has_value();
}

Rounding safely_rounded(const ExactComplex& complex, const Grid& grid,
                        const ArrangeOptions& options) {
  ensure_coordinates_within_limit(complex);
  Rounding result;
  result.spacing = spacing(complex, grid);
  if (is_on_grid(complex, grid)) return unchanged(complex, grid, std::move(result));
  const auto keep = [&](RoundingMethod method, ExactComplex rounded, const Places& places,
                        const Lists<VertexId>& chains) {
    result.method = method;
    result.complex = std::move(rounded);
    result.vertex_image = places.of_vertex;
    return finished(complex, grid, std::move(result), chains);
  };
  if (!grid.decimals) {
    const Places places = nearest_doubles(complex);
    if (std::optional<ExactComplex> rounded = moved(complex, places)) {
      return keep(RoundingMethod::NearestDoubles, std::move(*rounded), places,
                  straight_chains(complex, places));
    }
  }
  const HotPixels pixels(complex, result.spacing);
  const Places places = on_grid(pixels.places(), result.spacing);
  if (std::optional<ExactComplex> rounded = moved(complex, places)) {
    return keep(RoundingMethod::NearestPoints, std::move(*rounded), places,
                straight_chains(complex, places));
  }
  Snapped snap = snapped(complex, pixels, result.spacing, options);
  return keep(RoundingMethod::SnapRounded, std::move(snap.complex), places, snap.chains);
}

}  // namespace plumbline
