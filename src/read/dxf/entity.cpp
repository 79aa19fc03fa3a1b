#include "read/dxf/entity.hpp"

#include <algorithm>

#include "read/dxf/names.hpp"

namespace plumbline::dxf {
namespace {

constexpr int kExtrusionX = 210;
constexpr int kExtrusionY = 220;
constexpr int kExtrusionZ = 230;
constexpr int kFromXToY = 10;  ///< from the code of an x to the code of its y

std::string text_of(const Group& group) {
  return "group " + std::to_string(group.code) + ": " + in_ascii(group.value);
}

}  // namespace

Number number_of(const Group& group, Numbers& numbers) {
  try {
    return numbers.parse(group.value);
  } catch (const Unusable& problem) {
    throw Unusable{problem.reason, text_of(group)};
  }
}

std::int64_t integer_of(const Group& group, Numbers& numbers) {
  std::int64_t value = 0;
  if (parse_integer(group.value, value)) return value;
  const Number number = number_of(group, numbers);
  if (number.is_decimal() && number.digits() == 0) return number.mantissa();
  throw Unusable{"not an integer", text_of(group)};
}

const Group* Entity::find(int code) const {
  const auto found = std::find_if(record_.groups.begin(), record_.groups.end(),
                                  [code](const Group& group) { return group.code == code; });
  return found == record_.groups.end() ? nullptr : &*found;
}

std::string_view Entity::text(int code) const {
  const Group* group = find(code);
  return group == nullptr ? std::string_view() : group->value;
}

Number Entity::number(int code) const {
  const Group* group = find(code);
  if (group == nullptr) throw Unusable{"has no group " + std::to_string(code), {}};
  return number_of(*group, numbers_);
}

Number Entity::number(int code, const Number& otherwise) const {
  const Group* group = find(code);
  return group == nullptr ? otherwise : number_of(*group, numbers_);
}

std::int64_t Entity::integer(int code, std::int64_t otherwise) const {
  const Group* group = find(code);
  return group == nullptr ? otherwise : integer_of(*group, numbers_);
}

NumberPoint Entity::point(int code) const { return {number(code), number(code + kFromXToY)}; }

Point Entity::exact_point(int code) const {
  return {number(code).rational(), number(code + kFromXToY).rational()};
}

bool Entity::is_nonzero(int code) const {
  const Group* group = find(code);
  return group != nullptr && sgn(number_of(*group, numbers_)) != 0;
}

Plane plane_of(const Entity& entity) {
  if (!entity.has(kExtrusionZ) && !entity.has(kExtrusionX) && !entity.has(kExtrusionY)) {
    return Plane::Front;
  }
  const Number z = entity.number(kExtrusionZ, Number::decimal(1, 0));
  if (entity.is_nonzero(kExtrusionX) || entity.is_nonzero(kExtrusionY) || sgn(z) == 0) {
    throw Unusable{"not in the plane: extruded in another direction than z",
                   in_ascii(entity.text(kExtrusionX)) + " " + in_ascii(entity.text(kExtrusionY)) +
                       " " + in_ascii(entity.text(kExtrusionZ))};
  }
  return sgn(z) > 0 ? Plane::Front : Plane::Back;
}

void mirror_x(std::vector<NumberPoint>& points) {
  const Number minus_one = Number::decimal(-1, 0);
  for (NumberPoint& p : points) p.x = minus_one * p.x;
}

}  // namespace plumbline::dxf
