// The data of a check as the page takes them: findings as in the JSON report, geometry as packed
// arrays. Input segments have no coordinates of their own: each runs between the first and the last
// vertex of the edges that it covers.

#include "output/page/data.hpp"

#include <map>
#include <tuple>

#include "output/json/check.hpp"
#include "output/json/input.hpp"
#include "output/page/arrays.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kLongestArea = 40;  // characters; of longer ones the nearest double will do

using Integers = std::vector<std::uint32_t>;

std::uint32_t integer(std::size_t value) { return static_cast<std::uint32_t>(value); }

template <class T>
Integers integers(std::span<const T> ids) {
  Integers result;
  result.reserve(ids.size());
  for (const T id : ids) result.push_back(integer(id));
  return result;
}

template <class T>
void add_lists(PageArrays& arrays, const std::string& name, const Lists<T>& lists) {
  Integers sizes;
  sizes.reserve(lists.size());
  for (std::size_t i = 0; i < lists.size(); ++i) sizes.push_back(integer(lists[i].size()));
  arrays.add(name + "_sizes", sizes);
  arrays.add(name, integers(lists.flat()));
}

void add_incidences(PageArrays& arrays, const std::string& name, const Incidences& complex) {
  Integers tails, heads;
  for (const Edge& edge : complex.edges) {
    tails.push_back(integer(edge.tail));
    heads.push_back(integer(edge.head));
  }
  arrays.add(name + ".tail", tails);
  arrays.add(name + ".head", heads);
  add_lists(arrays, name + ".cycles", complex.cycles);
  arrays.add(name + ".face_outer", integers<CycleId>(complex.face_outer));
  add_lists(arrays, name + ".face_holes", complex.face_holes);
  arrays.add(name + ".face_depth", complex.face_depth);
  arrays.add(name + ".isolated_vertices", integers(complex.face_isolated_vertices.flat()));
  add_lists(arrays, name + ".edge_segments", complex.edge_sources);
}

struct Coordinates {
  std::vector<double> x, y;
};

PointD rounded(const PointList& points, std::size_t i) { return points.nearest(i); }
PointD rounded(const std::vector<PointD>& points, std::size_t i) { return points[i]; }

template <class Points>
Coordinates coordinates(const CellComplex<Points>& complex) {
  Coordinates result;
  result.x.reserve(complex.vertices.size());
  result.y.reserve(complex.vertices.size());
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    const PointD p = rounded(complex.vertices, v);
    result.x.push_back(p.x);
    result.y.push_back(p.y);
  }
  return result;
}

/// Per place the first one of the others that is not before it, or their last one: where the
/// complexes agree, the same place. Requires: there are others.
Integers like_places(const Coordinates& places, const Coordinates& others) {
  Integers result;
  result.reserve(places.x.size());
  std::size_t j = 0;
  for (std::size_t i = 0; i < places.x.size(); ++i) {
    const PointD p{places.x[i], places.y[i]};
    while (j + 1 < others.x.size() && PointD{others.x[j], others.y[j]} < p) ++j;
    result.push_back(integer(j));
  }
  return result;
}

std::vector<double> nearest_doubles(const std::vector<Rational>& values) {
  std::vector<double> result;
  result.reserve(values.size());
  for (const Rational& value : values) result.push_back(nearest_double(value));
  return result;
}

/// The three complexes: all of the first, of the others what differs.
class Complexes {
 public:
  Complexes(PageArrays& arrays, const ExactComplex& authored)
      : arrays_(arrays), authored_(authored), first_(coordinates(authored)) {
    arrays_.add("authored.x", first_.x);
    arrays_.add("authored.y", first_.y);
    add_incidences(arrays_, "authored", authored);
  }

  template <class Points>
  void add(const std::string& name, const CellComplex<Points>& complex) {
    const Coordinates own = coordinates(complex);
    if (first_.x.empty()) {
      arrays_.add(name + ".x", own.x);
      arrays_.add(name + ".y", own.y);
    } else {
      const Integers like = like_places(own, first_);
      arrays_.add(name + ".like", like);
      arrays_.add(name + ".x", own.x, {"authored.x", first_.x, name + ".like", like});
      arrays_.add(name + ".y", own.y, {"authored.y", first_.y, name + ".like", like});
    }
    if (static_cast<const Incidences&>(complex) == static_cast<const Incidences&>(authored_)) {
      same_.push_back(name);
    } else {
      add_incidences(arrays_, name, complex);
    }
  }

  const std::vector<std::string>& same() const { return same_; }

 private:
  PageArrays& arrays_;
  const ExactComplex& authored_;
  Coordinates first_;
  std::vector<std::string> same_;
};

/// Adds the sources. Returns their files, elements and paths, each combination once, in the order
/// of their first source.
std::vector<Source> add_sources(PageArrays& arrays, const SegmentSet& input) {
  std::map<std::tuple<std::uint32_t, std::string, std::string>, std::uint32_t> number;
  std::vector<Source> kinds;
  Integers lines, columns, kind;
  for (const Source& source : input.sources) {
    lines.push_back(source.line);
    columns.push_back(source.column);
    const auto [it, is_new] =
        number.try_emplace({source.file, source.element, source.path}, integer(kinds.size()));
    if (is_new) kinds.push_back(source);
    kind.push_back(it->second);
  }
  arrays.add("source_line", lines);
  arrays.add("source_column", columns);
  arrays.add("source_kind", kind);
  arrays.add("segment_source", integers<SourceId>(input.segment_source));
  return kinds;
}

/// The member "page".
auto page_member(const Check& check, const PageArrays& arrays, const std::vector<std::string>& same,
                 const std::vector<Rational>& areas, const std::vector<Source>& kinds) {
  using namespace json;
  const auto entry = [](const PageArrays::Entry& e) {
    return object(member("name", e.name), member("type", e.type), member("count", e.count),
                  member("reference", e.reference), member("index", e.index));
  };
  const auto short_text = [](const Rational& area) {
    std::string text = exact_text(area);
    return text.size() <= kLongestArea ? text : "";
  };
  const auto kind = [](const Source& s) {
    return object(member("file", s.file), member("element", s.element), member("path", s.path));
  };
  std::vector<std::tuple<std::size_t, std::string>> ids;
  for (std::size_t s = 0; const Source& source : check.input.sources) {
    if (!source.id.empty()) ids.emplace_back(s, source.id);
    ++s;
  }
  return member(
      "page",
      object(member("y_up", check.input.y_up), member("arrays", list(arrays.entries(), entry)),
             member("same_incidences", same), member("exact_areas", list(areas, short_text)),
             member("kinds", list(kinds, kind)), member("ids", std::move(ids))));
}

}  // namespace

PageData page_data(const Check& check) {
  using namespace json;
  PageArrays arrays;
  Complexes complexes(arrays, check.exact_complex);
  complexes.add("doubles", check.doubles_complex);
  complexes.add("float", check.answer.complex);
  const std::vector<Rational> areas = face_areas(check.exact_complex);
  arrays.add("authored.area", nearest_doubles(areas));
  arrays.add("doubles.area", nearest_doubles(face_areas(check.doubles_complex)));
  arrays.add("float.area", nearest_doubles(face_areas(exact(check.answer.complex))));
  const std::vector<Source> kinds = add_sources(arrays, check.input);
  const SegmentSet& input = check.input;
  return {document(object(check_members(check), member("files", input.files),
                          losses(input.rejected, input.remarks, input.ledger),
                          page_member(check, arrays, complexes.same(), areas, kinds))),
          arrays.bytes()};
}

}  // namespace plumbline
