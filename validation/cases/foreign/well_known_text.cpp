#include "cases/foreign/well_known_text.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

namespace plumbline::foreign {

namespace {

class Parser {
 public:
  explicit Parser(std::string_view text) : rest_(text) {}

  Geometry whole() {
    Geometry result = geometry();
    if (!peek().empty()) fail();
    return result;
  }

 private:
  [[noreturn]] void fail() const {
    throw Error(ErrorCode::BadInput, "not well-known text", {}, std::string(rest_));
  }

  /// The next bracket, comma or word.
  std::string_view peek() {
    constexpr std::string_view kBlanks = " \t\r\n", kMarks = "(),";
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
    if (rest_.empty()) return rest_;
    if (kMarks.find(rest_[0]) != std::string_view::npos) return rest_.substr(0, 1);
    return rest_.substr(0, rest_.find_first_of(" \t\r\n(),"));
  }
  std::string_view take() {
    const std::string_view word = peek();
    rest_.remove_prefix(word.size());
    return word;
  }
  bool take_if(std::string_view word) {
    if (peek() != word) return false;
    take();
    return true;
  }

  /// Items in brackets, or EMPTY.
  template <class Item>
  void list(Item item) {
    if (take_if("EMPTY")) return;
    if (!take_if("(")) fail();
    do {
      item();
    } while (take_if(","));
    if (!take_if(")")) fail();
  }

  Point point() {
    const Rational x = parse_decimal(take());
    return {x, parse_decimal(take())};
  }
  Path path() {
    Path result;
    list([&] { result.push_back(point()); });
    return result;
  }
  std::vector<Path> paths() {
    std::vector<Path> result;
    list([&] { result.push_back(path()); });
    return result;
  }

  void add_polygon(Geometry& result) {
    std::vector<Path> rings = paths();
    std::erase_if(rings, [](const Path& ring) { return ring.empty(); });
    if (!rings.empty()) result.polygons.push_back(std::move(rings));
  }

  Geometry geometry() {
    std::string type(take());
    for (char& c : type) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    Geometry result;
    if (type == "POINT") {
      result.points = path();
    } else if (type == "MULTIPOINT") {
      list([&] {  // with brackets around each or not
        if (peek() != "(" && peek() != "EMPTY") {
          result.points.push_back(point());
          return;
        }
        const Path one = path();
        result.points.insert(result.points.end(), one.begin(), one.end());
      });
    } else if (type == "LINESTRING") {
      result.lines = {path()};
    } else if (type == "LINEARRING") {
      result.rings = {path()};
    } else if (type == "MULTILINESTRING") {
      result.lines = paths();
    } else if (type == "POLYGON") {
      add_polygon(result);
    } else if (type == "MULTIPOLYGON") {
      list([&] { add_polygon(result); });
    } else if (type == "GEOMETRYCOLLECTION") {
      list([&] { result.parts.push_back(geometry()); });
    } else {
      fail();
    }
    return result;
  }

  std::string_view rest_;
};

Rational area(const Path& ring) {
  Rational twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
    twice += p.x * q.y - p.y * q.x;
  }
  return abs(twice) / 2;
}

}  // namespace

Rational area(const Geometry& geometry) {
  Rational sum = 0;
  for (const std::vector<Path>& rings : geometry.polygons) {
    sum += area(rings[0]);
    for (std::size_t i = 1; i < rings.size(); ++i) sum -= area(rings[i]);
  }
  for (const Geometry& part : geometry.parts) sum += area(part);
  return sum;
}

double perimeter(const Geometry& geometry) {
  double sum = 0;
  for (const std::vector<Path>& rings : geometry.polygons) {
    for (const Path& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        sum += nearest_sqrt(squared_distance(ring[i], ring[(i + 1) % ring.size()]));
      }
    }
  }
  for (const Geometry& part : geometry.parts) sum += perimeter(part);
  return sum;
}

Geometry geometry(std::string_view text) { return Parser(text).whole(); }

}  // namespace plumbline::foreign
