#include "plumbline/output.hpp"

#include <charconv>

#include "number/wide.hpp"
#include "output/certificate/reasons.hpp"

namespace plumbline {
namespace {

/// Text of the certificate: one space before every field of a line but the first.
class Text {
 public:
  Text& field(std::string_view field) {
    separate();
    text_ += field;
    return *this;
  }
  Text& field(std::size_t number) {
    char digits[20];
    const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
    return field(std::string_view(digits, end - digits));
  }
  Text& field(const wide::Fraction& number) {
    separate();
    wide::append_fraction(text_, number, 10);
    return *this;
  }
  Text& field(const Rational& number) {
    const auto fraction = wide::fraction(number);
    return fraction ? field(*fraction) : field(number.get_str());
  }
  Text& field(const Point& p) { return field(p.x).field(p.y); }
  Text& field(const PointList& points, std::size_t i) {
    const WidePoint* p = points.wide(i);
    if (p == nullptr) return field(points[i]);
    return field(wide::lowest(p->x, p->w)).field(wide::lowest(p->y, p->w));
  }
  /// "-" where there is none.
  template <class Id>
  Text& field_or_none(Id id) {
    return id.valid() ? field(static_cast<std::size_t>(id)) : field("-");
  }
  template <class Ids>
  Text& fields(const Ids& ids) {
    for (const auto id : ids) field(static_cast<std::size_t>(id));
    return *this;
  }
  void line() { text_ += '\n'; }
  void section(std::string_view name, std::size_t count) { field(name).field(count).line(); }
  std::string take() { return std::move(text_); }

 private:
  void separate() {
    if (!text_.empty() && text_.back() != '\n') text_ += ' ';
  }

  std::string text_;
};

void add_vertices(Text& text, const ExactComplex& complex, const SegmentSet& input) {
  const std::vector<std::string> reasons = certificate_steps::reasons(complex, input);
  text.section("vertices", complex.vertices.size());
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    text.field(complex.vertices, v).field(reasons[v]).line();
  }
}

void add_edges(Text& text, const ExactComplex& complex, std::size_t segments) {
  // Edges ascend by their tails, so the pieces of a segment come in their order.
  std::vector<std::size_t> pieces(segments);
  text.section("edges", complex.edge_count());
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    text.field(complex.edges[e].tail).field(complex.edges[e].head);
    for (const SegmentId s : complex.edge_sources[e]) {
      text.field(std::to_string(static_cast<std::size_t>(s)) + ':' + std::to_string(pieces.at(s)));
      ++pieces[s];
    }
    text.line();
  }
}

void add_cycles(Text& text, const ExactComplex& complex) {
  text.section("cycles", complex.cycles.size());
  for (std::size_t c = 0; c < complex.cycles.size(); ++c) {
    for (const HalfedgeId h : complex.cycles[c]) {
      text.field((is_reversed(h) ? "-" : "+") +
                 std::to_string(static_cast<std::size_t>(edge_of(h))));
    }
    text.line();
  }
}

void add_faces(Text& text, const ExactComplex& complex) {
  text.section("faces", complex.face_count());
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    const FaceId face(f);
    const bool is_bounded = face != kUnbounded;
    text.field("outer").field_or_none(complex.face_outer[f]);
    text.field("depth").field(complex.face_depth[f]);
    text.field("parent").field_or_none(is_bounded ? complex.parent(face) : FaceId());
    text.field("holes").fields(complex.face_holes[f]);
    text.field("isolated").fields(complex.face_isolated_vertices[f]);
    text.field("inside");
    if (is_bounded) {
      text.field(interior_point(complex, face));
    } else {
      text.field("-");
    }
    text.line();
  }
}

void add_components(Text& text, const ExactComplex& complex) {
  std::vector<VertexId> least(complex.component_count());
  for (std::size_t v = complex.vertices.size(); v-- > 0;) {
    least[complex.vertex_component[v]] = VertexId(v);
  }
  text.section("components", least.size());
  for (std::size_t c = 0; c < least.size(); ++c) {
    text.field(least[c]).field(complex.component_parent[c]).line();
  }
}

}  // namespace

std::string certificate(const ExactComplex& complex, const SegmentSet& input) {
  Text text;
  text.field("plumbline certificate 1").line();
  text.field("signature").field(signature(complex)).line();
  add_vertices(text, complex, input);
  add_edges(text, complex, input.segments.size());
  add_cycles(text, complex);
  add_faces(text, complex);
  add_components(text, complex);
  text.field("end").line();
  return text.take();
}

}  // namespace plumbline
