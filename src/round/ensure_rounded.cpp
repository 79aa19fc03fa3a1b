// Checks a rounding by definitions alone: of how it was made nothing is known but the faces'
// labels.

#include <algorithm>

#include "plumbline/error.hpp"
#include "plumbline/round.hpp"
#include "round/grid.hpp"
#include "round/images.hpp"
#include "round/sides.hpp"

namespace plumbline {
namespace {

void require(bool holds, const char* what, const Point& where) {
  if (holds) return;
  throw Error(ErrorCode::Internal, std::string("a rounded complex breaks its guarantee: ") + what +
                                       " at " + to_text(where));
}

class Promises {
 public:
  Promises(const ExactComplex& exact, const Grid& grid, const Rounding& rounding)
      : exact_(exact), grid_(grid), rounding_(rounding), half_(rounding.spacing / 2) {}

  void run() const {
    const std::vector<Violation> violations = validate(rounding_.complex);
    if (!violations.empty()) {
      require(false, violations.front().message.c_str(), violations.front().where);
    }
    check_images();
    check_sides();
  }
  /// Where everything went, but for validity and sides.
  void check_images() const {
    check_vertices();
    check_edges();
    check_faces();
  }

 private:
  Point image(VertexId v) const { return rounding_.complex.vertices[rounding_.vertex_image[v]]; }

  bool is_near(const Rational& a, const Rational& b) const {
    const Rational distance = a - b;
    return cmp(abs(distance), half_) <= 0;
  }

  void check_vertices() const {
    require(rounding_.vertex_image.size() == exact_.vertices.size(), "vertices are missing", {});
    for (const Point& p : rounding_.complex.vertices) {
      require(round_steps::is_on(grid_, p.x) && round_steps::is_on(grid_, p.y),
              "a vertex is not on the grid", p);
    }
    std::vector<bool> is_image(rounding_.complex.vertices.size());
    for (std::size_t v = 0; v < exact_.vertices.size(); ++v) {
      const Point &from = exact_.vertices[v], &to = image(VertexId(v));
      require(is_near(from.x, to.x) && is_near(from.y, to.y), "a vertex moved too far", from);
      is_image[rounding_.vertex_image[v]] = true;
    }
    for (std::size_t v = 0; v < is_image.size(); ++v) {
      require(is_image[v], "a vertex comes from nowhere", rounding_.complex.vertices[v]);
    }
  }

  void check_edges() const {
    require(rounding_.edge_image.size() == exact_.edge_count(), "edges are missing", {});
    std::vector<bool> is_image(rounding_.complex.edge_count());
    for (std::size_t e = 0; e < exact_.edge_count(); ++e) {
      check_chain(EdgeId(e));
      for (const HalfedgeId h : rounding_.edge_image[e]) is_image[edge_of(h)] = true;
    }
    for (std::size_t e = 0; e < is_image.size(); ++e) {
      require(is_image[e], "an edge comes from nowhere",
              rounding_.complex.vertices[rounding_.complex.edges[e].tail]);
    }
  }

  /// The image joins the images of the ends; the vertices inside it are near points of the edge
  /// that come one after the other, so what is between them is near what is between those.
  void check_chain(EdgeId e) const {
    const auto [tail, head] = exact_.edges[e];
    const Point &a = exact_.vertices[tail], &b = exact_.vertices[head];
    const auto image = rounding_.edge_image[e];
    VertexId reached = rounding_.vertex_image[tail];
    Rational t = 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
      require(rounding_.complex.origin(image[i]) == reached, "the image of an edge has a gap", a);
      if (i > 0) walk(a, b, rounding_.complex.vertices[reached], t);
      reached = rounding_.complex.target(image[i]);
    }
    require(reached == rounding_.vertex_image[head], "the image of an edge ends early", b);
  }

  /// Takes t on to the first point a + t (b - a) that is near p.
  void walk(const Point& a, const Point& b, const Point& p, Rational& t) const {
    Rational last = 1;
    const auto cut = [&](const Rational& from, const Rational& to, const Rational& at) {
      const Rational d = to - from;
      if (sgn(d) == 0) return is_near(from, at);
      const Rational s = (at - half_ - from) / d, u = (at + half_ - from) / d;
      t = std::max(t, std::min(s, u));
      last = std::min(last, std::max(s, u));
      return true;
    };
    const bool is_beside = cut(a.x, b.x, p.x) && cut(a.y, b.y, p.y);
    require(is_beside && t <= last, "the image of an edge is too far from it", p);
  }

  void check_faces() const {
    require(rounding_.face_origin == round_steps::face_origins(exact_, rounding_.complex,
                                                               rounding_.vertex_image,
                                                               rounding_.edge_image),
            "a face comes from another face", {});
    if (!rounding_.has_same_incidences()) return;
    const auto is_single = [&](std::size_t e) { return rounding_.edge_image[e].size() == 1; };
    for (std::size_t e = 0; e < exact_.edge_count(); ++e) {
      require(is_single(e), "an edge is not one edge", exact_.vertices[exact_.edges[e].tail]);
    }
    require(rounding_.complex.vertices.size() == exact_.vertices.size() &&
                rounding_.complex.edge_count() == exact_.edge_count() &&
                rounding_.complex.face_count() == exact_.face_count(),
            "the incidences are not the same", {});
  }

  void check_sides() const {
    Lists<VertexId> chains;
    std::vector<VertexId> chain;
    for (std::size_t e = 0; e < exact_.edge_count(); ++e) {
      chain.assign(1, rounding_.vertex_image[exact_.edges[e].tail]);
      for (const HalfedgeId h : rounding_.edge_image[e]) {
        chain.push_back(rounding_.complex.target(h));
      }
      chains.push_back(chain);
    }
    const auto v =
        round_steps::vertex_past_edge(exact_, rounding_.complex, rounding_.vertex_image, chains);
    if (v) require(false, "a vertex went past an edge", exact_.vertices[*v]);
  }

  const ExactComplex& exact_;
  const Grid& grid_;
  const Rounding& rounding_;
  const Rational half_;
};

}  // namespace

void round_steps::ensure_images(const ExactComplex& complex, const Grid& grid,
                                const Rounding& rounding) {
  Promises(complex, grid, rounding).check_images();
}

void ensure_rounded(const ExactComplex& complex, const Grid& grid, const Rounding& rounding) {
  Promises(complex, grid, rounding).run();
}

}  // namespace plumbline
