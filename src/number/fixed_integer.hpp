#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "number/wide.hpp"

namespace plumbline {

/// An integer of at most N words of 64 bits, magnitude and sign, held in place: GMP computes, but
/// nothing is in dynamic memory. Results have to fit.
template <int N>
class FixedInteger {
 public:
  FixedInteger() {}  // words beyond its size are nobody's
  FixedInteger(wide::Int128 v) : FixedInteger(wide::UInt256{0, wide::magnitude(v)}, v < 0) {}
  /// Requires: it fits.
  FixedInteger(const wide::UInt256& magnitude, bool is_negative) {
    constexpr int kWordBits = 64;
    const std::array<wide::UInt128, 2> halves{magnitude.low, magnitude.high};
    for (std::size_t i = 0; i < std::min<std::size_t>(N, 4); ++i) {
      words_[i] = static_cast<mp_limb_t>(halves[i / 2] >> (i % 2 * kWordBits));
    }
    set_size(std::min(N, 4), is_negative);
  }
  explicit FixedInteger(mpz_srcptr z) : FixedInteger(mpz_limbs_read(z), z->_mp_size) {}
  template <int M>
  explicit(M > N) FixedInteger(const FixedInteger<M>& v) : FixedInteger(v.words(), v.size()) {}

  /// From the lowest.
  const mp_limb_t* words() const { return words_.data(); }
  /// The number of words, negative where the integer is.
  int size() const { return size_; }
  int length() const { return std::abs(size_); }
  int bits() const {
    return size_ == 0 ? 0 : static_cast<int>(mpn_sizeinbase(words(), length(), 2));
  }

  friend bool operator==(const FixedInteger& a, const FixedInteger& b) {
    return a.size_ == b.size_ && compare_magnitudes(a, b) == 0;
  }
  friend bool operator<(const FixedInteger& a, const FixedInteger& b) {
    if (a.size_ != b.size_) return a.size_ < b.size_;
    return a.size_ < 0 ? compare_magnitudes(b, a) < 0 : compare_magnitudes(a, b) < 0;
  }
  friend bool operator>(const FixedInteger& a, const FixedInteger& b) { return b < a; }

  FixedInteger operator-() const {
    FixedInteger result = *this;
    result.size_ = -size_;
    return result;
  }
  friend FixedInteger operator+(const FixedInteger& a, const FixedInteger& b) {
    return sum(a, b, b.size_ < 0);
  }
  friend FixedInteger operator-(const FixedInteger& a, const FixedInteger& b) {
    return sum(a, b, b.size_ > 0);
  }
  friend FixedInteger<2 * N> product(const FixedInteger& a, const FixedInteger& b) {
    FixedInteger<2 * N> result;
    if (a.size_ == 0 || b.size_ == 0) return result;
    const bool ordered = a.length() >= b.length();
    const FixedInteger &more = ordered ? a : b, &less = ordered ? b : a;
    mpn_mul(result.words_.data(), more.words(), more.length(), less.words(), less.length());
    result.set_size(a.length() + b.length(), (a.size_ < 0) != (b.size_ < 0));
    return result;
  }

 private:
  template <int M>
  friend class FixedInteger;

  FixedInteger(const mp_limb_t* words, int size) : size_(size) {
    std::copy_n(words, length(), words_.data());
  }
  /// Of `length` words, the highest of which may be 0.
  void set_size(int length, bool is_negative) {
    while (length > 0 && words_[static_cast<std::size_t>(length - 1)] == 0) --length;
    size_ = is_negative ? -length : length;
  }
  static int compare_magnitudes(const FixedInteger& a, const FixedInteger& b) {
    if (a.length() != b.length()) return a.length() < b.length() ? -1 : 1;
    return a.size_ == 0 ? 0 : mpn_cmp(a.words(), b.words(), a.length());
  }
  /// a + |b|, or a - |b|.
  static FixedInteger sum(const FixedInteger& a, const FixedInteger& b, bool is_b_negative) {
    FixedInteger result;
    const bool ordered = compare_magnitudes(a, b) >= 0, is_a_negative = a.size_ < 0;
    const FixedInteger &more = ordered ? a : b, &less = ordered ? b : a;
    mp_limb_t* const words = result.words_.data();
    int length = more.length();
    if (is_a_negative != is_b_negative) {
      mpn_sub(words, more.words(), length, less.words(), less.length());
    } else if (mpn_add(words, more.words(), length, less.words(), less.length()) != 0) {
      words[length++] = 1;
    }
    result.set_size(length, ordered ? is_a_negative : is_b_negative);
    return result;
  }

  std::array<mp_limb_t, N> words_;
  int size_ = 0;
};

template <int N>
int sign(const FixedInteger<N>& v) {
  return (v.size() > 0) - (v.size() < 0);
}

/// Sign of a b - c d.
template <int N>
int compare_products(const FixedInteger<N>& a, const FixedInteger<N>& b, const FixedInteger<N>& c,
                     const FixedInteger<N>& d) {
  const int left = sign(a) * sign(b), right = sign(c) * sign(d);
  if (left != right || left == 0) return (left > right) - (left < right);
  const FixedInteger<2 *N> p = product(a, b), q = product(c, d);
  return (p > q) - (p < q);
}

template <int N>
mpz_class to_mpz(const FixedInteger<N>& v) {
  mpz_t view;
  return mpz_class(mpz_roinit_n(view, v.words(), v.size()));
}

}  // namespace plumbline
