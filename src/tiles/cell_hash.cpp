#include "tiles/cell_hash.hpp"

#include <xxhash.h>

#include <array>
#include <initializer_list>
#include <numeric>

#include "number/wide.hpp"

namespace plumbline::tiles {
namespace {

using wide::Int128;
using wide::UInt128;

/// The greatest primes below 2^61 and 2^62.
constexpr std::array<std::uint64_t, 2> kPrimes{2305843009213693951U, 4611686018427387847U};

std::uint64_t residue(Int128 value, std::uint64_t p) {
  const auto r = static_cast<std::int64_t>(value % static_cast<Int128>(p));
  return r < 0 ? static_cast<std::uint64_t>(r) + p : static_cast<std::uint64_t>(r);
}
std::uint64_t residue(const mpz_class& value, std::uint64_t p) {
  return mpz_fdiv_ui(value.get_mpz_t(), p);
}

std::uint64_t product(std::uint64_t a, std::uint64_t b, std::uint64_t p) {
  return static_cast<std::uint64_t>(static_cast<UInt128>(a) * b % p);
}

/// 1 / a modulo p, by Euclid. Requires: 0 < a < p, p a prime.
std::uint64_t inverse(std::uint64_t a, std::uint64_t p) {
  std::int64_t t = 0, next_t = 1;
  std::uint64_t r = p, next_r = a;
  while (next_r != 0) {
    const std::uint64_t q = r / next_r;
    t = std::exchange(next_t, t - static_cast<std::int64_t>(q) * next_t);
    r = std::exchange(next_r, r - q * next_r);
  }
  return t < 0 ? static_cast<std::uint64_t>(t + static_cast<std::int64_t>(p))
               : static_cast<std::uint64_t>(t);
}

/// n / d modulo p. Where p divides the denominator in lowest terms, p and more.
std::uint64_t quotient(const Rational& value, std::uint64_t p) {
  const std::uint64_t d = residue(value.get_den(), p), n = residue(value.get_num(), p);
  return d == 0 ? p + n : product(n, inverse(d, p), p);
}

CellHash hash(char kind, std::initializer_list<CellHash> parts) {
  std::array<std::uint64_t, 7> words{static_cast<std::uint64_t>(kind)};
  std::size_t count = 1;
  for (const CellHash& part : parts) {
    words[count++] = part.low;
    words[count++] = part.high;
  }
  return bytes_hash({reinterpret_cast<const char*>(words.data()), count * sizeof(words[0])});
}

/// The point's coordinates modulo p.
template <class Point>
std::array<std::uint64_t, 2> residues(const PointList& points, std::size_t v, const Point& point,
                                      std::uint64_t p) {
  const std::uint64_t w = residue(point.w, p);
  if (w == 0) {
    const plumbline::Point exact = points[v];
    return {quotient(exact.x, p), quotient(exact.y, p)};
  }
  const std::uint64_t by = w == 1 ? 1 : inverse(w, p);
  return {product(residue(point.x, p), by, p), product(residue(point.y, p), by, p)};
}

}  // namespace

CellHash vertex_hash(const PointList& points, std::size_t v) {
  std::array<std::array<std::uint64_t, 2>, 2> found;
  for (std::size_t i = 0; i < kPrimes.size(); ++i) {
    const WidePoint* point = points.wide(v);
    found[i] = point != nullptr ? residues(points, v, *point, kPrimes[i])
                                : residues(points, v, points.long_point(v), kPrimes[i]);
  }
  return hash('v', {{found[0][0], found[0][1]}, {found[1][0], found[1][1]}});
}

CellHash edge_hash(const CellHash& tail, const CellHash& head) { return hash('e', {tail, head}); }
CellHash halfedge_hash(const CellHash& origin, const CellHash& target) {
  return hash('h', {origin, target});
}
CellHash corner_hash(const CellHash& before, const CellHash& vertex, const CellHash& behind) {
  return hash('n', {before, vertex, behind});
}
CellHash cycle_hash(const CellHash& halfedges) { return hash('c', {halfedges}); }
CellHash isolated_hash(const CellHash& vertex) { return hash('i', {vertex}); }
CellHash face_hash(const CellHash& cycles, bool is_bounded) {
  return hash(is_bounded ? 'f' : 'u', {cycles});
}

CellHash bytes_hash(std::string_view bytes) {
  const XXH128_hash_t made = XXH3_128bits(bytes.data(), bytes.size());
  return {made.low64, made.high64};
}

std::string to_text(const CellHash& hash) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const std::uint64_t word : {hash.high, hash.low}) {
    for (int shift = 60; shift >= 0; shift -= 4) text += kDigits[(word >> shift) & 15U];
  }
  return text;
}

}  // namespace plumbline::tiles
