// Step 7: the signature is the hash of the content.

#include <xxhash.h>

#include <array>
#include <memory>
#include <new>
#include <string>

#include "steps.hpp"

namespace plumbline_checker {
namespace {

class Hash {
 public:
  Hash() : state_(XXH3_createState(), XXH3_freeState) {
    if (!state_) throw std::bad_alloc();
    XXH3_128bits_reset(state_.get());
  }

  Hash& operator<<(std::string_view text) {
    buffer_ += text;
    if (buffer_.size() > kEnough) flush();
    return *this;
  }
  Hash& operator<<(Index number) {
    std::array<char, 10> digits;
    std::size_t begin = digits.size();
    do {
      digits[--begin] = static_cast<char>('0' + number % 10);
      number /= 10;
    } while (number > 0);
    return *this << std::string_view(digits.data() + begin, digits.size() - begin);
  }
  Hash& operator<<(const Number& value) {
    *this << value.numerator;
    return value.denominator == 1 ? *this : *this << "/" << value.denominator;
  }
  Hash& operator<<(const mpz_class& value) {
    constexpr int kBase = 16;
    const std::size_t room_for_sign_and_end = 2;
    number_.resize(mpz_sizeinbase(value.get_mpz_t(), kBase) + room_for_sign_and_end);
    return *this << std::string_view(mpz_get_str(number_.data(), kBase, value.get_mpz_t()));
  }

  /// 32 hexadecimal digits, the most significant first.
  std::string digits() {
    flush();
    XXH128_canonical_t bytes;
    XXH128_canonicalFromHash(&bytes, XXH3_128bits_digest(state_.get()));
    std::string text;
    for (const unsigned char byte : bytes.digest) {
      text += "0123456789abcdef"[byte / 16];
      text += "0123456789abcdef"[byte % 16];
    }
    return text;
  }

 private:
  static constexpr std::size_t kEnough = 1 << 14;

  void flush() {
    XXH3_128bits_update(state_.get(), buffer_.data(), buffer_.size());
    buffer_.clear();
  }

  std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state_;
  std::string buffer_, number_;
};

void add_list(Hash& hash, std::string_view name, const Index* begin, const Index* end) {
  hash << name;
  for (; begin != end; ++begin) hash << " " << *begin;
  hash << "\n";
}
void add_list(Hash& hash, std::string_view name, const std::vector<Index>& list) {
  add_list(hash, name, list.data(), list.data() + list.size());
}

}  // namespace

void check_signature(const Certificate& certificate, const Lists& cycles,
                     const std::vector<Face>& faces) {
  Hash hash;
  hash << "plumbline complex 1\n";
  for (const Point& p : certificate.vertices) hash << "v " << p.x << " " << p.y << "\n";
  for (const Edge& e : certificate.edges) hash << "e " << e.tail << " " << e.head << "\n";
  for (std::size_t c = 0; c < cycles.size(); ++c) {
    add_list(hash, "c", cycles.begin(c), cycles.end(c));
  }
  for (const Face& face : faces) {
    if (face.outer != kNone) hash << "o " << face.outer << "\n";
    add_list(hash, "h", face.holes);
    add_list(hash, "i", face.isolated);
  }
  constexpr std::size_t kSignatureLine = 2;
  require("the signature", certificate.signature, hash.digits(), kSignatureLine);
}

}  // namespace plumbline_checker
