#include "read/dxf/insert.hpp"

#include <algorithm>
#include <utility>

#include "read/dxf/names.hpp"

namespace plumbline::dxf {
namespace {

// Groups of an INSERT.
constexpr int kPlace = 10;
constexpr int kScaleX = 41;
constexpr int kScaleY = 42;
constexpr int kColumnDistance = 44;
constexpr int kRowDistance = 45;
constexpr int kAngle = 50;
constexpr int kColumns = 70;
constexpr int kRows = 71;

/// The number of copies in a direction.
std::size_t copies(const Entity& entity, int code, const Rational& distance) {
  const std::int64_t count = std::max<std::int64_t>(entity.integer(code, 1), 1);
  return distance == 0 ? 1 : static_cast<std::size_t>(count);
}

}  // namespace

Insert insert_of(const Entity& entity, std::string block, double angle_bound,
                 std::vector<Substitution>& replaced) {
  const Number zero;
  const Number one = Number::decimal(1, 0);
  Insert insert;
  insert.block = std::move(block);
  insert.scale =
      scaling(entity.number(kScaleX, one).rational(), entity.number(kScaleY, one).rational());
  insert.column_distance = entity.number(kColumnDistance, zero).rational();
  insert.row_distance = entity.number(kRowDistance, zero).rational();
  insert.columns = copies(entity, kColumns, insert.column_distance);
  insert.rows = copies(entity, kRows, insert.row_distance);
  if (insert.columns > kMaxCopies || insert.rows > kMaxCopies / insert.columns) {
    throw Unusable{"array of " + std::to_string(insert.columns) + " x " +
                       std::to_string(insert.rows) + " copies, more than " +
                       std::to_string(kMaxCopies),
                   {}};
  }
  const Point place = entity.exact_point(kPlace);
  const ApproximateAffine turned = rotation(entity.number(kAngle, zero).rational(), angle_bound);
  insert.placement = compose(translation(place.x, place.y), turned.map);
  if (plane_of(entity) == Plane::Back) insert.placement = compose(scaling(-1, 1), insert.placement);
  if (turned.bound != 0) {
    replaced.push_back({"rotation by " + in_ascii(entity.text(kAngle)) + " degrees",
                        nearest_double(turned.bound), "rad"});
  }
  return insert;
}

}  // namespace plumbline::dxf
