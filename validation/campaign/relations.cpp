#include "campaign/relations.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "campaign/claims.hpp"
#include "campaign/dice.hpp"
#include "campaign/images.hpp"
#include "plumbline/arrange.hpp"

namespace plumbline::campaign {

namespace {

ExactComplex arranged(const SegmentSet& input, std::size_t threads = 1) {
  return arrange(input, ExactEngine::Bucket, {threads, {}});
}

/// A changed input, and which segment of the old one each of its segments is or is part of.
struct Changed {
  SegmentSet input;
  SourceId source = input.add_source({});
  std::vector<SegmentId> original;

  void add(const Segment& segment, std::size_t id) {
    input.add(segment, source);
    original.emplace_back(id);
  }
  void add_points(const std::vector<Point>& points) {
    for (const Point& p : points) input.add_point(p, source);
  }
};

Segment reversed(const Segment& s) { return {s.b, s.a}; }

template <class T>
void shuffle(std::vector<T>& items, Dice& dice) {
  for (std::size_t i = items.size(); i > 1; --i) {
    std::swap(items[i - 1], items[static_cast<std::size_t>(dice.pick(i))]);
  }
}

Changed permuted(const SegmentSet& input, Dice& dice) {
  std::vector<std::size_t> order(input.segments.size());
  std::iota(order.begin(), order.end(), 0U);
  shuffle(order, dice);
  Changed changed;
  for (const std::size_t s : order) changed.add(input.segments[s], s);
  std::vector<Point> points = input.points;
  shuffle(points, dice);
  changed.add_points(points);
  return changed;
}

Changed with_some_reversed(const SegmentSet& input, Dice& dice) {
  Changed changed;
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const Segment segment = input.segments[s];
    changed.add(dice.one_in(2) ? segment : reversed(segment), s);
  }
  changed.add_points(input.points);
  return changed;
}

Changed with_duplicates(const SegmentSet& input, Dice& dice) {
  Changed changed;
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const Segment segment = input.segments[s];
    changed.add(segment, s);
    while (dice.one_in(3)) changed.add(dice.one_in(2) ? segment : reversed(segment), s);
  }
  changed.add_points(input.points);
  changed.add_points(input.points);
  return changed;
}

bool split_holds(const SegmentSet& input, const ExactComplex& complex, Dice& dice) {
  if (input.segments.empty()) return true;
  const auto cut = static_cast<std::size_t>(dice.pick(input.segments.size()));
  const Segment whole = input.segments[cut];
  const int denominator = dice.between(2, dice.one_in(4) ? 1'000'000 : 12);
  const Rational t = Rational(dice.between(1, denominator - 1)) / denominator;
  const Point place{whole.a.x + t * (whole.b.x - whole.a.x),
                    whole.a.y + t * (whole.b.y - whole.a.y)};
  Changed changed;
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    if (s != cut) changed.add(input.segments[s], s);
  }
  changed.add({whole.a, place}, cut);
  changed.add({place, whole.b}, cut);
  changed.add_points(input.points);
  return renamed(arranged(changed.input), changed.original) == with_vertex(complex, place);
}

/// x and y exchanged, or a large shear, or small entries; and moved. Most turn the plane over or
/// not by chance.
Affine random_map(Dice& dice) {
  const auto number = [&]() -> Rational {
    return Rational(dice.between(-5, 5)) / dice.between(1, 4);
  };
  Affine map;
  for (const std::size_t row : {0U, 1U}) map(row, 2) = number();
  switch (dice.pick(4)) {
    case 0:
      map(0, 0) = map(1, 1) = Rational(0);
      map(0, 1) = map(1, 0) = Rational(1);
      return map;
    case 1:
      map(0, 1) = Rational(1'000'003 * number());
      return map;
    case 2:
      map(1, 0) = Rational(dice.between(-1'000'000, 1'000'000));
      map(1, 1) = Rational(-1);
      return map;
    default:
      do {
        for (const std::size_t row : {0U, 1U}) {
          for (const std::size_t column : {0U, 1U}) map(row, column) = number();
        }
      } while (determinant_sign(map) == 0);
      return map;
  }
}

void add_mapped(SegmentSet& result, const SegmentSet& input, const Affine& map, SourceId source) {
  for (const Segment& s : input.segments) result.add({apply(map, s.a), apply(map, s.b)}, source);
  for (const Point& p : input.points) result.add_point(apply(map, p), source);
}

bool map_holds(const SegmentSet& input, const ExactComplex& complex, Dice& dice) {
  const Affine map = random_map(dice);
  SegmentSet changed;
  add_mapped(changed, input, map, changed.add_source({}));
  return mapped(arranged(changed), inverse(map)) == complex;
}

bool two_copies_hold(const SegmentSet& input, const ExactComplex& complex, Dice& dice) {
  if (complex.vertices.empty()) return true;
  const Rational width = complex.vertices.back().x - complex.vertices.front().x;
  const Rational far = width + Rational(1 + dice.pick(1000)) / (1 + dice.pick(1000));
  const Affine move = translation(dice.one_in(2) ? far : Rational(-far), dice.between(-9, 9));
  SegmentSet both;
  const SourceId source = both.add_source({});
  add_mapped(both, input, Affine(), source);
  add_mapped(both, input, move, source);
  return arranged(both) == with_copy(complex, move, input.segments.size());
}

bool noded_holds(const ExactComplex& complex) {
  SegmentSet edges;
  const SourceId source = edges.add_source({});
  for (const Edge& e : complex.edges) {
    edges.add({complex.vertices[e.tail], complex.vertices[e.head]}, source);
  }
  for (const VertexId v : complex.face_isolated_vertices.flat()) {
    edges.add_point(complex.vertices[v], source);
  }
  return arranged(edges) == sourced_by_itself(complex);
}

}  // namespace

std::string to_text(Relation relation) {
  switch (relation) {
    case Relation::Permuted:
      return "permuted";
    case Relation::Reversed:
      return "reversed";
    case Relation::Duplicated:
      return "duplicated";
    case Relation::Split:
      return "split";
    case Relation::Mapped:
      return "mapped";
    case Relation::TwoCopies:
      return "two copies";
    case Relation::Threads:
      return "threads";
    case Relation::Noded:
      return "noded";
    case Relation::Claims:
      return "claims";
  }
  return "";
}

bool holds(Relation relation, const SegmentSet& input, const ExactComplex& complex,
           std::uint64_t seed) {
  Dice dice(seed);
  const auto same = [&](const Changed& changed) {
    return renamed(arranged(changed.input), changed.original) == complex;
  };
  switch (relation) {
    case Relation::Permuted:
      return same(permuted(input, dice));
    case Relation::Reversed:
      return same(with_some_reversed(input, dice));
    case Relation::Duplicated:
      return same(with_duplicates(input, dice));
    case Relation::Split:
      return split_holds(input, complex, dice);
    case Relation::Mapped:
      return map_holds(input, complex, dice);
    case Relation::TwoCopies:
      return two_copies_hold(input, complex, dice);
    case Relation::Threads:
      return arranged(input, static_cast<std::size_t>(dice.between(2, 3))) == complex;
    case Relation::Noded:
      return noded_holds(complex);
    case Relation::Claims:
      return refuted_claim(input, complex, seed).empty();
  }
  return false;
}

}  // namespace plumbline::campaign
