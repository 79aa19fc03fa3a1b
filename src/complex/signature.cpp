// The bytes that are hashed are a text: numbers in lowest terms, one cell a line. It does not
// depend on word size, byte order or compiler.

#include <xxhash.h>

#include <array>
#include <charconv>
#include <memory>

#include "number/wide.hpp"
#include "plumbline/complex.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

class Hasher {
 public:
  Hasher() : state_(XXH3_createState()) {
    ensure(state_ != nullptr && XXH3_128bits_reset(state_.get()) == XXH_OK, "the hash starts");
  }
  void add(const std::string& text) {
    ensure(XXH3_128bits_update(state_.get(), text.data(), text.size()) == XXH_OK,
           "the hash goes on");
  }
  std::string digest() const {
    XXH128_canonical_t bytes;
    XXH128_canonicalFromHash(&bytes, XXH3_128bits_digest(state_.get()));
    static constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    for (const unsigned char byte : bytes.digest) {
      text += kDigits[byte / 16];
      text += kDigits[byte % 16];
    }
    return text;
  }

 private:
  struct Free {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
  };
  std::unique_ptr<XXH3_state_t, Free> state_;
};

/// One line: a letter and numbers.
class Line {
 public:
  explicit Line(char kind) : text_(1, kind) {}

  void add(std::size_t id) {
    std::array<char, 20> digits;
    text_ += ' ';
    text_.append(digits.data(), std::to_chars(digits.data(), digits.data() + 20, id).ptr);
  }
  void add(const PointList& points, std::size_t v) {
    if (const WidePoint* p = points.wide(v)) {
      for (const auto coordinate : {p->x, p->y}) {
        wide::append_fraction(text_ += ' ', wide::lowest(coordinate, p->w), 16);
      }
    } else {
      const Point other = points[v];
      text_ += ' ' + other.x.get_str(16) + ' ' + other.y.get_str(16);
    }
  }
  const std::string& end() { return text_ += '\n'; }

 private:
  std::string text_;
};

template <class Range>
std::string line(char kind, const Range& ids) {
  Line text(kind);
  for (const auto id : ids) text.add(static_cast<std::size_t>(id));
  return text.end();
}

std::string vertex_line(const PointList& points, std::size_t v) {
  Line text('v');
  text.add(points, v);
  return text.end();
}

}  // namespace

std::string signature(const ExactComplex& complex) {
  Hasher hash;
  hash.add("plumbline complex 1\n");
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    hash.add(vertex_line(complex.vertices, v));
  }
  for (const Edge& e : complex.edges) hash.add(line('e', std::array{e.tail, e.head}));
  for (std::size_t c = 0; c < complex.cycles.size(); ++c) hash.add(line('c', complex.cycles[c]));
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    if (complex.face_outer[f].valid()) hash.add(line('o', std::array{complex.face_outer[f]}));
    hash.add(line('h', complex.face_holes[f]));
    hash.add(line('i', complex.face_isolated_vertices[f]));
  }
  return hash.digest();
}

}  // namespace plumbline
