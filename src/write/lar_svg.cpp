// Pictures of the float pipeline, as in the publication: buckets and components in colours, faces,
// faces pulled apart, numbered cells, merged vertices.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "plumbline/write.hpp"
#include "write/lar_scene.hpp"
#include "write/picture.hpp"

namespace plumbline {
namespace {

using picture::LarScene;
using Out = std::back_insert_iterator<std::string>;

constexpr double kSide = 1000;  ///< longer side of a picture
constexpr double kMargin = 20;
constexpr double kPen = 1;
constexpr double kSteps = 1000;  ///< coordinates have three decimals

/// A strong colour; consecutive numbers are a golden angle apart on the colour wheel.
std::string colour(std::size_t number) {
  constexpr double kGoldenRatio = 0.6180339887498949, kDarkest = 60, kRange = 150;
  const double hue = std::fmod(static_cast<double>(number % 1'000'000) * kGoldenRatio, 1.0);
  const auto channel = [&](double phase) {
    const double distance = std::abs(std::fmod(hue + phase, 1.0) * 6 - 3) - 1;
    return static_cast<unsigned>(kDarkest + kRange * std::clamp(distance, 0.0, 1.0));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", channel(0), channel(2.0 / 3), channel(1.0 / 3));
}

picture::Box box_of(const LarScene& scene) {
  FloatComplex complex;
  for (const LarScene::Line& line : scene.lines) {
    complex.vertices.push_back(line.a);
    complex.vertices.push_back(line.b);
  }
  complex.vertices.insert(complex.vertices.end(), scene.vertices.begin(), scene.vertices.end());
  return picture::bounds(complex);
}

/// Where points are drawn: as large as fits.
class View {
 public:
  View(const picture::Box& box, bool y_up)
      : frame_(picture::fit(box, {{kMargin, kMargin}, {kSide - kMargin, kSide - kMargin}})),
        y_up_(y_up) {}

  PointD operator()(const PointD& p) const {
    const PointD q = frame_(p);
    return {rounded(q.x), rounded(y_up_ ? kSide - q.y : q.y)};
  }
  double length(double drawn) const { return rounded(drawn * frame_.scale); }
  std::string text(const PointD& p) const { return picture::coordinates((*this)(p)); }

 private:
  static double rounded(double value) { return std::round(value * kSteps) / kSteps; }
  picture::Frame frame_;
  bool y_up_;
};

class Drawing {
 public:
  Drawing(const LarScene& scene, const LarPicture& options)
      : scene_(scene), options_(options), box_(box_of(scene)), view_(box_, options.y_up) {}

  std::string svg() {
    fmt::format_to(
        Out(svg_),
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {0}\" fill=\"none\" "
        "stroke=\"{1}\" stroke-width=\"{2}\" stroke-linecap=\"round\">\n",
        kSide, picture::kInk, kPen);
    switch (options_.show) {
      case LarShow::Buckets:
        buckets();
        break;
      case LarShow::Components:
        components();
        break;
      case LarShow::Faces:
        faces(1);
        edges();
        break;
      case LarShow::Explode:
        faces(options_.explode);
        break;
      case LarShow::Numbers:
        numbers();
        break;
      case LarShow::Pruning:
        pruning();
        break;
    }
    return svg_ + "</svg>\n";
  }

 private:
  void line(const PointD& a, const PointD& b, const std::string& attributes) {
    fmt::format_to(Out(svg_), "<path d=\"M{}L{}\"{}/>\n", view_.text(a), view_.text(b), attributes);
  }
  void line(const std::array<VertexId, 2>& edge, const std::string& attributes) {
    line(scene_.vertices[edge[0]], scene_.vertices[edge[1]], attributes);
  }
  void circle(const PointD& p, double radius, const char* attributes) {
    const PointD q = view_(p);
    fmt::format_to(Out(svg_), "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", shortest_text(q.x),
                   shortest_text(q.y), shortest_text(radius), attributes);
  }

  void buckets() {
    for (const LarScene::Line& l : scene_.lines) {
      line(l.a, l.b, fmt::format(" stroke=\"{}\"", colour(l.bucket)));
    }
  }

  void components() {
    for (std::size_t c = 0; c < scene_.components.size(); ++c)
      for (const auto& edge : scene_.components[c]) {
        line(edge, fmt::format(" stroke=\"{}\" stroke-width=\"2\"", colour(c)));
      }
    for (const auto& edge : scene_.bridges) line(edge, " stroke-dasharray=\"4\"");
  }

  void edges() {
    for (const auto& edge : scene_.edges) line(edge, "");
  }

  /// The faces, each moved away from the drawing's corner by the factor.
  void faces(double factor) {
    if (factor != 1) {
      const PointD far{box_.low.x + box_.width() * factor, box_.low.y + box_.height() * factor};
      view_ = View({box_.low, far}, options_.y_up);
    }
    for (std::size_t f = 0; f < scene_.faces.size(); ++f) {
      const PointD middle = centre(scene_.faces[f].front());
      const PointD shift{(factor - 1) * (middle.x - box_.low.x),
                         (factor - 1) * (middle.y - box_.low.y)};
      std::string path;
      for (const std::vector<PointD>& cycle : scene_.faces[f]) {
        char command = 'M';
        for (const PointD& p : cycle) {
          path += command + view_.text({p.x + shift.x, p.y + shift.y});
          command = 'L';
        }
        path += 'Z';
      }
      fmt::format_to(Out(svg_),
                     "<path fill=\"{}\" fill-opacity=\"0.5\" fill-rule=\"evenodd\" d=\"{}\"/>\n",
                     colour(f), path);
    }
  }

  /// Middle of the box.
  static PointD centre(const std::vector<PointD>& cycle) {
    FloatComplex complex;
    complex.vertices = cycle;
    const picture::Box box = picture::bounds(complex);
    return {(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
  }

  void number(const PointD& p, std::size_t value, double size, const char* ink) {
    const PointD q = view_(p);
    fmt::format_to(Out(svg_), "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\">{}</text>\n",
                   shortest_text(q.x), shortest_text(q.y), shortest_text(size), ink, value);
  }

  void numbers() {
    constexpr double kLargest = 16, kShare = 0.2;
    constexpr const char* kEdgeInk = "#5a6b7a";
    const double cells = static_cast<double>(scene_.edges.size() + 1);
    const double size =
        std::round(std::min(kLargest, kShare * kSide / std::sqrt(cells)) * kSteps) / kSteps;
    faces(1);
    edges();
    svg_ += "<g stroke=\"none\" font-family=\"sans-serif\" text-anchor=\"middle\">\n";
    for (std::size_t f = 0; f < scene_.faces.size(); ++f) {
      number(centre(scene_.faces[f].front()), f, 1.5 * size, picture::kMark);
    }
    for (std::size_t e = 0; e < scene_.edges.size(); ++e) {
      const PointD& p = scene_.vertices[scene_.edges[e][0]];
      const PointD& q = scene_.vertices[scene_.edges[e][1]];
      number({(p.x + q.x) / 2, (p.y + q.y) / 2}, e, size, kEdgeInk);
    }
    for (std::size_t v = 0; v < scene_.vertices.size(); ++v) {
      number(scene_.vertices[v], v, size, picture::kInk);
    }
    svg_ += "</g>\n";
  }

  void pruning() {
    constexpr double kDot = 1.5;
    const std::string filled = fmt::format("fill=\"{}\" stroke=\"none\"", picture::kInk);
    const std::string centroid = fmt::format("fill=\"{}\" stroke=\"none\"", picture::kMark);
    for (const LarScene::Line& l : scene_.lines) line(l.a, l.b, " stroke-opacity=\"0.3\"");
    for (const PointD& p : scene_.unpruned) circle(p, kDot, filled.c_str());
    for (std::size_t c = 0; c < scene_.clusters.size(); ++c) {
      for (const VertexId v : scene_.clusters[c]) {
        const PointD& p = scene_.unpruned[v];
        circle(p, std::max(view_.length(scene_.radius), 2 * kDot), "stroke-width=\"0.5\"");
        line(p, scene_.centroids[c], fmt::format(" stroke=\"{}\"", picture::kMark));
      }
      circle(scene_.centroids[c], kDot, centroid.c_str());
    }
  }

  const LarScene& scene_;
  LarPicture options_;
  picture::Box box_;
  View view_;
  std::string svg_;
};

void check(const LarPicture& options) {
  if (std::isfinite(options.explode) && options.explode >= 1) return;
  throw Error(ErrorCode::BadInput, "the factor of an exploded view must be 1 or more", {},
              shortest_text(options.explode));
}

}  // namespace

std::string to_svg(const lar::Result& result, const LarPicture& options) {
  check(options);
  const LarScene scene = picture::scene(result);
  return Drawing(scene, options).svg();
}

std::string to_svg(const lar::published::Trace& trace, const LarPicture& options) {
  check(options);
  const LarScene scene = picture::scene(trace);
  return Drawing(scene, options).svg();
}

}  // namespace plumbline
