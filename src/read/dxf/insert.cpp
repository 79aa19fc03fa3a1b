#include "read/dxf/insert.hpp"

#include <algorithm>
#include <utility>

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

Insert insert_of(const Entity& entity, std::string block, const Source& source) {
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
  insert.place = translation(place.x, place.y);
  if (plane_of(entity) == Plane::Back) insert.place = compose(scaling(-1, 1), insert.place);
  insert.turn = rotation_item(entity.number(kAngle, zero).rational(), source);
  return insert;
}

}  // namespace plumbline::dxf
