#include "plumbline/structure/affine.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "plumbline/error.hpp"

namespace plumbline {
namespace {

const Number& one() {
  static const Number value = Number::decimal(1, 0);
  return value;
}

/// sum += p * q; most entries of the maps in drawings are 0, many of the rest 1.
void add_product(Number& sum, const Number& p, const Number& q) {
  if (sgn(p) == 0 || sgn(q) == 0) return;
  Number product = p == one() ? q : q == one() ? p : p * q;
  sum = sgn(sum) == 0 ? std::move(product) : sum + product;
}

void require_dimension(std::size_t dimension) {
  if (dimension == 0) throw Error(ErrorCode::BadInput, "an affine map of dimension 0");
  if (dimension > kMaxDimension) {
    throw Error(ErrorCode::Limit, "a dimension of more than " + std::to_string(kMaxDimension));
  }
}

Affine diagonal(std::span<const Rational> factors) {
  Affine map(factors.size());
  for (std::size_t i = 0; i < factors.size(); ++i) map(i, i) = factors[i];
  return map;
}

}  // namespace

Affine::Affine(std::size_t dimension) : dimension_(dimension) {
  require_dimension(dimension);
  entries_.resize(dimension * (dimension + 1));
  for (std::size_t i = 0; i < dimension; ++i) (*this)(i, i) = one();
}

Affine::Affine(Rational a, Rational b, Rational c, Rational d, Rational e, Rational f)
    : dimension_(2) {
  entries_.reserve(6);
  for (Rational* entry : {&a, &c, &e, &b, &d, &f}) entries_.emplace_back(std::move(*entry));
}

Point apply(const Affine& map, const Point& p) {
  const std::array<Number, 2> from{p.x, p.y};
  std::array<Number, 2> image;
  apply(map, from, image);
  return {image[0].rational(), image[1].rational()};
}

void apply(const Affine& map, std::span<const Number> p, std::span<Number> image) {
  const std::size_t d = map.dimension();
  for (std::size_t i = 0; i < d; ++i) {
    image[i] = map(i, d);
    for (std::size_t j = 0; j < d; ++j) add_product(image[i], map(i, j), p[j]);
  }
}

Affine compose(const Affine& outer, const Affine& inner) {
  const std::size_t d = outer.dimension();
  if (inner.dimension() != d) {
    throw Error(ErrorCode::BadInput, "maps of dimensions " + std::to_string(d) + " and " +
                                         std::to_string(inner.dimension()) + " are composed");
  }
  Affine product(d);
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t j = 0; j <= d; ++j) {
      product(i, j) = j == d ? outer(i, d) : Number();
      for (std::size_t k = 0; k < d; ++k) add_product(product(i, j), outer(i, k), inner(k, j));
    }
  }
  return product;
}

Affine inverse(const Affine& map) {
  // Gauss-Jordan elimination on the rows [A | I], all rational.
  const std::size_t d = map.dimension();
  std::vector<std::vector<Rational>> rows(d, std::vector<Rational>(2 * d));
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t j = 0; j < d; ++j) rows[i][j] = map(i, j).rational();
    rows[i][d + i] = 1;
  }
  for (std::size_t column = 0; column < d; ++column) {
    std::size_t pivot = column;
    while (pivot < d && sgn(rows[pivot][column]) == 0) ++pivot;
    if (pivot == d) throw Error(ErrorCode::BadInput, "an affine map that is not invertible");
    std::swap(rows[column], rows[pivot]);
    const Rational scale = rows[column][column];
    for (Rational& entry : rows[column]) entry /= scale;
    for (std::size_t i = 0; i < d; ++i) {
      const Rational factor = rows[i][column];
      if (i == column || sgn(factor) == 0) continue;
      for (std::size_t j = 0; j < 2 * d; ++j) rows[i][j] -= factor * rows[column][j];
    }
  }
  Affine result(d);
  for (std::size_t i = 0; i < d; ++i) {
    Rational shift;
    for (std::size_t j = 0; j < d; ++j) {
      shift -= rows[i][d + j] * map(j, d).rational();
      result(i, j) = rows[i][d + j];
    }
    result(i, d) = shift;
  }
  return result;
}

Affine translation(const std::vector<Rational>& by) {
  Affine map(by.size());
  for (std::size_t i = 0; i < by.size(); ++i) map(i, by.size()) = by[i];
  return map;
}

Affine translation(const Rational& dx, const Rational& dy) { return {1, 0, 0, 1, dx, dy}; }

Affine scaling(const std::vector<Rational>& factors) { return diagonal(factors); }

Affine scaling(const Rational& sx, const Rational& sy) { return {sx, 0, 0, sy, 0, 0}; }

Affine shear(std::size_t dimension, std::size_t row, std::size_t column, const Rational& factor) {
  ensure(row != column && row < dimension && column < dimension, "shear of two coordinates");
  Affine map(dimension);
  map(row, column) = factor;
  return map;
}

Affine embed(const Affine& map, int k) {
  const std::size_t d = map.dimension();
  if (k < 0 && d <= static_cast<std::size_t>(-static_cast<long>(k))) {
    throw Error(ErrorCode::BadInput, "a projection that leaves no dimension");
  }
  const std::size_t to = d + static_cast<std::size_t>(k);
  Affine result(to);
  const std::size_t kept = std::min(d, to);
  for (std::size_t i = 0; i < kept; ++i) {
    for (std::size_t j = 0; j < kept; ++j) result(i, j) = map(i, j);
    result(i, to) = map(i, d);
    for (std::size_t j = kept; j < d; ++j) {
      if (sgn(map(i, j)) == 0) continue;
      throw Error(ErrorCode::BadInput, "a map whose dropped coordinates act on those kept");
    }
  }
  return result;
}

}  // namespace plumbline
