#include "structure/placement.hpp"

#include <array>
#include <utility>

#include "structure/continued_fraction.hpp"
#include "structure/words.hpp"

namespace plumbline {
namespace {

/// +1 for a map that turns and scales alone, -1 where it mirrors too, 0 for any other.
int similarity(const Affine& map) {
  const auto are_opposite = [](const Number& a, const Number& b) { return sgn(a + b) == 0; };
  if (map(0, 0) == map(1, 1) && are_opposite(map(0, 1), map(1, 0))) return 1;
  return are_opposite(map(0, 0), map(1, 1)) && map(0, 1) == map(1, 0) ? -1 : 0;
}

/// The same angle between -180, excluded, and 180.
Rational reduced(const Rational& degrees) {
  constexpr int kTurn = 360;
  const Rational back = Rational(1, 2) - degrees / kTurn;
  return degrees + kTurn * floor(back);
}

Affine without_shift(Affine map) {
  for (std::size_t i = 0; i < map.dimension(); ++i) map(i, map.dimension()) = Number();
  return map;
}

}  // namespace

Struct::Item rotation_item(const Rational& degrees, Source source) {
  constexpr int kQuarter = 90;
  if (Rational(degrees / kQuarter).get_den() == 1) return rotation(degrees).map;
  return Turn{degrees, std::move(source)};
}

const ApproximateAffine& Rotations::operator()(const Rational& degrees) {
  const auto found = known_.find(degrees);
  if (found != known_.end()) return found->second;
  return known_.emplace(degrees, rotation(degrees, bound_)).first->second;
}

void Placement::append(const Affine& map) {
  inner_ = compose(inner_, map);
  map_.reset();
}

void Placement::append(const Turn& turn, Rotations& rotations) {
  if (const auto& [map, bound] = rotations(turn.degrees); sgn(bound) == 0) return append(map);
  Turned turned = turned_ ? *turned_ : Turned{};
  if (const int way = similarity(inner_); way != 0) {
    std::array<Number, 2>& shift = turned.shifts[turned.degrees];
    for (const std::size_t i : {0, 1}) shift[i] = shift[i] + inner_(i, 2);
    if (sgn(shift[0]) == 0 && sgn(shift[1]) == 0) turned.shifts.erase(turned.degrees);
    turned.degrees = reduced(turned.degrees + way * turn.degrees);
    inner_ = without_shift(std::move(inner_));
  } else {
    turned = {map(rotations), angles(), {}, reduced(turn.degrees)};
    inner_ = Affine(2);
  }
  turned.last = &turn;
  turned_ = std::make_shared<const Turned>(std::move(turned));
  map_.reset();
}

void Placement::append(const Struct::Item& item, Rotations& rotations) {
  if (const auto* turn = std::get_if<Turn>(&item)) return append(*turn, rotations);
  append(std::get<Affine>(item));
}

Placement Placement::linear_part() const {
  Placement result = *this;
  result.inner_ = without_shift(inner_);
  result.map_.reset();
  if (!turned_) return result;
  Turned turned = *turned_;
  turned.shifts.clear();
  if (turned.frozen) turned.frozen = without_shift(*std::move(turned.frozen));
  result.turned_ = std::make_shared<const Turned>(std::move(turned));
  return result;
}

const Affine& Placement::map(Rotations& rotations) {
  if (!turned_) return inner_;
  if (map_) return *map_;
  Affine sum = compose(rotations(turned_->degrees).map, inner_);
  for (const auto& [degrees, shift] : turned_->shifts) {
    std::array<Number, 2> image;
    apply(rotations(degrees).map, shift, image);
    for (const std::size_t i : {0, 1}) sum(i, 2) = sum(i, 2) + image[i];
  }
  map_ = turned_->frozen ? compose(*turned_->frozen, sum) : std::move(sum);
  plumbline::checked_words(*map_);
  return *map_;
}

std::vector<Number> Placement::key() const {
  std::vector<Number> key(inner_.entries().begin(), inner_.entries().end());
  if (!turned_) return key;
  key.emplace_back(turned_->degrees);
  if (!turned_->frozen) return key;
  const auto frozen = turned_->frozen->entries();
  key.insert(key.end(), frozen.begin(), frozen.end());
  return key;
}

std::size_t Placement::checked_words() const {
  std::size_t sum = plumbline::checked_words(inner_);
  if (!turned_) return sum;
  if (turned_->frozen) sum += plumbline::checked_words(*turned_->frozen);
  for (const auto& [degrees, shift] : turned_->shifts) {
    sum += words(degrees) + words(shift[0]) + words(shift[1]);
  }
  return sum;
}

std::vector<Rational> Placement::angles() const {
  if (!turned_) return {};
  std::vector<Rational> result = turned_->frozen_angles;
  result.push_back(turned_->degrees);
  for (const auto& [degrees, shift] : turned_->shifts) result.push_back(degrees);
  return result;
}

}  // namespace plumbline
