#pragma once

#include <optional>
#include <string_view>

#include "plumbline/geometry.hpp"
#include "read/attribute.hpp"
#include "read/dxf/records.hpp"

namespace plumbline::dxf {

/// The value as an exact number. Throws: Unusable, naming the group.
Number number_of(const Group& group, Numbers& numbers);
/// The value as an integer; "1.0" is one. Throws: Unusable, naming the group.
std::int64_t integer_of(const Group& group, Numbers& numbers);

/// The group that holds the flags of most types of records.
constexpr int kFlags = 70;

/// A record's groups by their codes; the first one where a code is repeated. Throws: Unusable for
/// values that are no numbers and for required groups that are missing.
class Entity {
 public:
  /// Requires: both outlive the entity.
  Entity(const Record& record, Numbers& numbers) : record_(record), numbers_(numbers) {}

  const Record& record() const { return record_; }
  Numbers& numbers() const { return numbers_; }
  bool has(int code) const { return find(code) != nullptr; }
  /// Empty where the group is missing.
  std::string_view text(int code) const;
  Number number(int code) const;
  Number number(int code, const Number& otherwise) const;
  std::int64_t integer(int code, std::int64_t otherwise) const;
  /// The x of this code and the y of code + 10.
  NumberPoint point(int code) const;
  Point exact_point(int code) const;
  /// Whether the group is there and not 0.
  bool is_nonzero(int code) const;

 private:
  const Group* find(int code) const;

  const Record& record_;
  Numbers& numbers_;
};

/// What an extrusion direction (groups 210, 220, 230) makes of an entity's own coordinates, by the
/// DXF reference's arbitrary axis algorithm.
enum class Plane {
  Front,  ///< +z: coordinates of the drawing
  Back,   ///< -z: x has the other sign
};
/// Throws: Unusable for a direction that is not along z.
Plane plane_of(const Entity& entity);
/// The points as they are seen from +z.
void mirror_x(std::vector<NumberPoint>& points);

}  // namespace plumbline::dxf
