#include "inputs/curve_scenes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline::inputs {
namespace {

constexpr double kHalfTurn = 3.141592653589793;  // in radians

/// A line from a to b; or the arc of a circle counter-clockwise from angle `from` to `to`, in
/// degrees, the whole circle where these are equal; or, with a ratio, that of the ellipse whose
/// longer half axis has length `radius` and the direction `axis`.
struct Piece {
  bool is_line;
  PointD a, b;  ///< of an arc its ends
  PointD centre = {};
  double radius = 0, from = 0, to = 0;
  double ratio = 0, axis = 0;
};

PointD on_circle(const PointD& c, double r, double degrees) {
  return {c.x + r * std::cos(degrees * kHalfTurn / 180),
          c.y + r * std::sin(degrees * kHalfTurn / 180)};
}

class Sketch {
 public:
  explicit Sketch(std::uint64_t number) : random_(number) {}

  double between(double low, double high) {
    constexpr double kUnit = 0x1p-53;
    return low + (high - low) * (static_cast<double>(random_() >> 11U) * kUnit);
  }
  int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

  void line(const PointD& a, const PointD& b) { pieces.push_back({true, a, b}); }
  void arc(const PointD& c, double r, double from, double to) {
    pieces.push_back({false, on_circle(c, r, from), on_circle(c, r, to), c, r, from, to});
  }
  void elliptic_arc(const PointD& c, double r, double ratio, double from, double to) {
    const auto at = [&](double t) {
      return PointD{c.x + r * std::cos(t * kHalfTurn / 180),
                    c.y + r * ratio * std::sin(t * kHalfTurn / 180)};
    };
    pieces.push_back({false, at(from), at(to), c, r, from, to, ratio, 0});
  }
  void circle(const PointD& c, double r) { arc(c, r, 0, 0); }
  void polyline(const std::vector<PointD>& points, bool is_closed) {
    for (std::size_t i = 1; i < points.size(); ++i) line(points[i - 1], points[i]);
    if (is_closed) line(points.back(), points.front());
  }

  std::vector<Piece> pieces;

 private:
  std::mt19937_64 random_;
};

// What is drawn; each returns how many faces there are.

std::size_t sector(Sketch& s) {
  const double r = s.between(1, 100), from = s.between(0, 360), sweep = s.between(20, 170);
  s.arc({0, 0}, r, from, from + sweep);
  s.line({0, 0}, on_circle({0, 0}, r, from));
  s.line(on_circle({0, 0}, r, from + sweep), {0, 0});
  return 2;
}

std::size_t ring(Sketch& s) {
  const double r = s.between(1, 50), outer = r * s.between(1.2, 3);
  const double from = s.between(0, 360), to = from + s.between(20, 170);
  for (const double radius : {r, outer}) s.arc({0, 0}, radius, from, to);
  for (const double at : {from, to}) s.line(on_circle({0, 0}, r, at), on_circle({0, 0}, outer, at));
  return 2;
}

std::size_t fillets(Sketch& s) {
  const double w = s.between(5, 50), h = s.between(5, 50), r = s.between(0.5, 2);
  s.line({r, 0}, {w - r, 0});
  s.arc({w - r, r}, r, 270, 360);
  s.line({w, r}, {w, h - r});
  s.arc({w - r, h - r}, r, 0, 90);
  s.line({w - r, h}, {r, h});
  s.arc({r, h - r}, r, 90, 180);
  s.line({0, h - r}, {0, r});
  s.arc({r, r}, r, 180, 270);
  return 2;
}

std::size_t slot(Sketch& s) {
  const double w = s.between(2, 50), r = s.between(0.5, 20);
  s.line({0, -r}, {w, -r});
  s.arc({w, 0}, r, 270, 450);
  s.line({w, r}, {0, r});
  s.arc({0, 0}, r, 90, 270);
  return 2;
}

/// A column, walls that run from it to the sides of a room.
std::size_t column(Sketch& s) {
  const double r = s.between(1, 5), half = r * s.between(2, 4);
  s.polyline({{-half, -half}, {half, -half}, {half, half}, {-half, half}}, true);
  s.circle({0, 0}, r);
  for (int i = 0; i < 4; ++i) {
    const PointD corner{i % 2 == 0 ? half : -half, i / 2 == 0 ? half : -half};
    const double at = std::atan2(corner.y, corner.x) * 180 / kHalfTurn;
    s.line(on_circle({0, 0}, r, at), corner);
  }
  return 6;
}

/// A door leaf and its swing, which ends on the wall opposite.
std::size_t door(Sketch& s) {
  const double r = s.between(0.6, 1.2), w = s.between(2, 5);
  s.polyline({{-w, 0}, {0, 0}, {r + w, 0}}, false);
  s.line({0, 0}, {0, r});
  s.arc({0, 0}, r, 0, 90);
  s.polyline({{-w, 0}, {-w, -w}, {r + w, -w}, {r + w, 0}}, false);
  return 3;
}

std::size_t lens(Sketch& s) {
  const double r = s.between(1, 50), half = s.between(20, 80);
  const double across = 2 * r * std::cos(half * kHalfTurn / 180);
  s.arc({0, 0}, r, -half, half);
  s.arc({across, 0}, r, 180 - half, 180 + half);
  return 2;
}

std::size_t tangents(Sketch& s) {
  const double r = s.between(1, 50), at = s.between(0, 360);
  s.circle({0, 0}, r);
  const PointD touch = on_circle({0, 0}, r, at), way = on_circle({0, 0}, 1, at + 90);
  const PointD a{touch.x - 2 * r * way.x, touch.y - 2 * r * way.y};
  const PointD b{touch.x + 2 * r * way.x, touch.y + 2 * r * way.y};
  const PointD far = on_circle({0, 0}, 3 * r, at);
  s.polyline({a, b, far}, true);
  return 3;
}

std::size_t crossing_circles(Sketch& s) {
  const double r = s.between(1, 50), apart = s.between(0.2, 1.8) * r;
  s.circle({0, 0}, r);
  s.circle({apart, 0}, r);
  return 4;
}

std::size_t bay(Sketch& s) {
  const double r = s.between(1, 50), from = s.between(0, 360), to = from + s.between(40, 300);
  s.elliptic_arc({0, 0}, r, s.between(0.2, 0.9), from, to);
  const Piece arc = s.pieces.back();
  s.line(arc.a, arc.b);
  return 2;
}

struct Drawing {
  const char* name;
  std::size_t (*draw)(Sketch&);
};
constexpr Drawing kDrawings[] = {
    {"sector", sector}, {"ring", ring},         {"fillets", fillets},
    {"slot", slot},     {"column", column},     {"door", door},
    {"lens", lens},     {"tangents", tangents}, {"crossing circles", crossing_circles},
    {"bay", bay}};

/// Turned, scaled and moved, in doubles.
struct Placing {
  double degrees = 0, scale = 1;
  PointD by{};

  PointD operator()(const PointD& p) const {
    const double c = std::cos(degrees * kHalfTurn / 180), s = std::sin(degrees * kHalfTurn / 180);
    return {scale * (c * p.x - s * p.y) + by.x, scale * (s * p.x + c * p.y) + by.y};
  }
  Piece operator()(const Piece& p) const {
    const auto turned = [&](double angle) {
      return std::fmod(std::fmod(angle + degrees, 360) + 360, 360);
    };
    Piece result = p;
    result.a = (*this)(p.a);
    result.b = (*this)(p.b);
    result.centre = (*this)(p.centre);
    result.radius = scale * p.radius;
    if (p.ratio == 0) {
      result.from = turned(p.from);
      result.to = turned(p.to);
    } else {
      result.axis = turned(p.axis);
    }
    return result;
  }
};

/// Prints with a number of digits.
class Writer {
 public:
  explicit Writer(int digits) : digits_(digits) {}

  std::string number(double x) const { return fmt::format("{:.{}g}", x, digits_); }
  std::string pair(int code, const std::string& value) const {
    return fmt::format("{}\n{}\n", code, value);
  }
  std::string point(int code, const PointD& p) const {
    return pair(code, number(p.x)) + pair(code + 10, number(p.y));
  }

  std::string line(const Piece& p) const {
    return "0\nLINE\n8\n0\n" + point(10, p.a) + point(11, p.b);
  }
  std::string arc(const Piece& p, bool is_mirrored) const {
    PointD c = p.centre;
    double from = p.from, to = p.to;
    if (is_mirrored) {
      c.x = -c.x;
      from = std::fmod(540 - p.to, 360);
      to = std::fmod(540 - p.from, 360);
    }
    const bool is_whole = p.from == p.to;
    std::string text = is_whole ? "0\nCIRCLE\n8\n0\n" : "0\nARC\n8\n0\n";
    if (is_mirrored) text += pair(210, "0") + pair(220, "0") + pair(230, "-1");
    text += point(10, c) + pair(40, number(p.radius));
    return is_whole ? text : text + pair(50, number(from)) + pair(51, number(to));
  }
  /// An ELLIPSE has coordinates of the drawing, whichever way it is seen.
  std::string ellipse(const Piece& p, bool is_mirrored) const {
    const double from = (is_mirrored ? -p.to : p.from) * kHalfTurn / 180;
    const double to = (is_mirrored ? -p.from : p.to) * kHalfTurn / 180;
    std::string text = "0\nELLIPSE\n8\n0\n";
    if (is_mirrored) text += pair(210, "0") + pair(220, "0") + pair(230, "-1");
    return text + point(10, p.centre) + point(11, on_circle({0, 0}, p.radius, p.axis)) +
           pair(40, number(p.ratio)) + pair(41, number(from)) + pair(42, number(to));
  }
  std::string bulge(const Piece& p) const {
    const double sweep = std::fmod(p.to - p.from + 360, 360);
    return "0\nLWPOLYLINE\n8\n0\n90\n2\n70\n0\n" + point(10, p.a) +
           pair(42, number(std::tan(sweep * kHalfTurn / 720))) + point(10, p.b);
  }
  std::string svg(const Piece& p) const {
    if (p.is_line) {
      return fmt::format("<path d=\"M {} {} L {} {}\"/>\n", number(p.a.x), number(p.a.y),
                         number(p.b.x), number(p.b.y));
    }
    if (p.from == p.to) {
      return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", number(p.centre.x),
                         number(p.centre.y), number(p.radius));
    }
    const double sweep = std::fmod(p.to - p.from + 360, 360);
    const double other = p.ratio == 0 ? p.radius : p.ratio * p.radius;
    return fmt::format("<path d=\"M {} {} A {} {} {} {} 1 {} {}\"/>\n", number(p.a.x),
                       number(p.a.y), number(p.radius), number(other), number(p.axis),
                       sweep > 180 ? 1 : 0, number(p.b.x), number(p.b.y));
  }

 private:
  int digits_;
};

std::string entities(const std::vector<Piece>& pieces, const Writer& writer, int how) {
  std::string text;
  for (const Piece& p : pieces) {
    const bool is_bulge = how == 2 && !p.is_line && p.from != p.to;
    text += p.ratio != 0 ? writer.ellipse(p, how == 1)
            : p.is_line  ? writer.line(p)
            : is_bulge   ? writer.bulge(p)
                         : writer.arc(p, how == 1);
  }
  return text;
}

}  // namespace

CurveScene curve_scene(std::uint64_t number) {
  constexpr const char* kHow[] = {"arcs", "mirrored arcs", "bulges", "in a turned block", "SVG"};
  Sketch sketch(number);
  const Drawing& drawing = kDrawings[sketch.pick(static_cast<int>(std::size(kDrawings)))];
  const std::size_t faces = drawing.draw(sketch);
  Placing placing;
  if (sketch.pick(3) > 0) placing.degrees = sketch.between(0, 360);
  if (sketch.pick(2) == 0) placing.scale = std::pow(10, sketch.pick(5) - 2);
  if (sketch.pick(2) == 0) {
    const double reach = std::pow(10, sketch.pick(5));
    placing.by = {sketch.between(-reach, reach), sketch.between(-reach, reach)};
  }
  const int how = sketch.pick(static_cast<int>(std::size(kHow)));
  const Writer writer(15 + sketch.pick(3));
  CurveScene scene{fmt::format("{}, {}", drawing.name, kHow[how]), "scene.dxf", {}, faces};
  std::vector<Piece> placed = sketch.pieces;
  for (Piece& piece : placed) piece = placing(piece);
  if (how == 4) {
    scene.file = "scene.svg";
    scene.text = "<svg xmlns=\"http://www.w3.org/2000/svg\">\n";
    for (const Piece& p : placed) scene.text += writer.svg(p);
    scene.text += "</svg>\n";
    return scene;
  }
  if (how == 3) {
    scene.text = "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n10\n0\n20\n0\n" +
                 entities(placed, writer, 0) + "0\nENDBLK\n0\nENDSEC\n";
  }
  scene.text += "0\nSECTION\n2\nENTITIES\n";
  scene.text += how == 3 ? "0\nINSERT\n8\n0\n2\nB\n" + writer.point(10, {1, 2}) +
                               writer.pair(50, writer.number(sketch.between(0, 360)))
                         : entities(placed, writer, how);
  scene.text += "0\nENDSEC\n0\nEOF\n";
  return scene;
}

}  // namespace plumbline::inputs
