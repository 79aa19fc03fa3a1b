#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumbline/complex.hpp"
#include "plumbline/polygons.hpp"

/// Regions of the plane as chains of faces: which faces of an arrangement lie in which region, what
/// an expression of regions selects, and polygons of what was selected. The faces are the atoms of
/// a finite Boolean algebra (Paoluzzi et al., arXiv 1910.11848). Everything is **exact**: a face is
/// in a region or not, there are no interior points and no rays.
namespace plumbline {

using RegionId = Index<struct RegionTag>;

/// Which winding numbers are inside.
enum class FillRule : std::uint8_t { EvenOdd, NonZero, Positive, Negative };
constexpr bool is_inside(FillRule rule, std::int64_t winding) {
  switch (rule) {
    case FillRule::EvenOdd:
      return winding % 2 != 0;
    case FillRule::NonZero:
      return winding != 0;
    case FillRule::Positive:
      return winding > 0;
    case FillRule::Negative:
      break;
  }
  return winding < 0;
}
/// "evenodd", "nonzero", "positive", "negative".
std::string to_text(FillRule rule);

/// What some segments of a drawing enclose together.
struct Region {
  std::string name;  ///< in expressions; several regions may have one name
  FillRule rule = FillRule::EvenOdd;
  /// Each as often as it counts, in the direction in which it is drawn. They are closed: in each
  /// point as many begin as end, or by EvenOdd an even number meet.
  std::vector<SegmentId> segments;
};

/// What regions are made of.
enum class RegionKind {
  Polygon,  ///< each polygon of the input with its parts and holes, by the name of its layer
  Layer,    ///< all segments of a layer
};
/// The regions of a drawing, in the order of its polygons or, by name, of its layers. A closed line
/// counts as a polygon. Rings that the drawing leaves open are none. By layer a region has all
/// segments that lie there.
std::vector<Region> regions(const SegmentSet& input, RegionKind kind, FillRule rule);

/// What the layers of a drawing enclose, by their names.
struct LayerRegions {
  std::vector<Region> regions;
  std::vector<SegmentId> open;  ///< what encloses nothing, ascending
};
/// The polygons of a drawing, and of each layer the other lines as one region by EvenOdd: those of
/// them that hang together by their ends, and at each end an even number. The others are open, as
/// is a text's leader in a layer of walls. Order: polygons first, then by layer. Cost: O(n log n).
LayerRegions layer_regions(const SegmentSet& input, FillRule rule);

/// The element that a region was read from, as "file:line:column element #id".
std::string source_text(const Region& region, const SegmentSet& input);

/// How a winding number changes.
struct WindingChange {
  RegionId region;
  std::int32_t by = 0;
  friend bool operator==(const WindingChange&, const WindingChange&) = default;
};

/// The winding number of every face about every region, as differences between neighbours, so that
/// thousands of regions within each other take no more room than their edges.
struct LabelledComplex {
  std::vector<Region> regions;
  /// All faces, the unbounded one first, each after the face that it is told from.
  std::vector<FaceId> order;
  std::vector<FaceId> from;           ///< per face a neighbour; none for the unbounded face
  Lists<WindingChange> changes;       ///< per face against that neighbour, by region
  Lists<WindingChange> edge_changes;  ///< per edge, of the face on its left against the right one
};

/// Labels the faces of a complex. Requires: the complex is `arrange` of the drawing that the
/// segments of the regions are of. Cost: O(k log k) for all sources of edges. Throws: Error
/// BadInput for a region that is not closed, with the first point where it is not.
LabelledComplex label(const SegmentSet& input, const ExactComplex& complex,
                      std::vector<Region> regions);

/// What is known of a face: which regions it lies in.
class Membership {
 public:
  explicit Membership(const LabelledComplex& labelled);
  std::int64_t winding(RegionId r) const { return winding_[r]; }
  bool contains(RegionId r) const { return is_inside(labelled_->regions[r].rule, winding_[r]); }
  /// In how many regions, and in how many of that name (a number of `names`).
  std::size_t count() const { return count_; }
  std::size_t count(std::size_t name) const { return name_count_[name]; }
  /// The same number for the same set of regions; other sets have others but for a chance of 2^-90.
  using SetKey = std::pair<std::uint64_t, std::uint64_t>;
  const SetKey& key() const { return key_; }
  /// Distinct names of regions, in their first order.
  const std::vector<std::string>& names() const { return names_; }

  void apply(std::span<const WindingChange> changes, int sign);

 private:
  const LabelledComplex* labelled_;
  std::vector<std::int64_t> winding_;
  std::vector<std::string> names_;
  std::vector<std::uint32_t> name_of_;  ///< per region
  std::vector<std::size_t> name_count_;
  std::size_t count_ = 0;
  SetKey key_{};
};

/// Visits all faces, in `order`, with what is known of each. Cost: linear in all changes.
void for_each_face(const LabelledComplex& labelled,
                   const std::function<void(FaceId, const Membership&)>& visit);
/// The regions that each face lies in, ascending. Cost: what it returns, which for regions within
/// each other is quadratic.
Lists<RegionId> regions_of_faces(const LabelledComplex& labelled);

/// A set of faces, as one flag each.
using FaceSet = std::vector<bool>;

/// The faces for which a predicate holds.
FaceSet select(const LabelledComplex& labelled,
               const std::function<bool(const Membership&)>& predicate);
/// The faces that an expression selects: names of regions (in ' or " where they have other
/// characters than letters, digits and _ . : * ?, which stand for any characters and for one), `!`
/// not, `&` and, `|` or, `^` either, `-` without, parentheses; `count`, the number of regions, and
/// `count(NAME)`, compared with a number by < <= = != >= >. `&` binds more tightly than `|`, `^`
/// and
/// `-`, which go from left to right. Throws: Error BadInput, with the place, for what is none, and
/// for a name that no region has.
FaceSet select(const LabelledComplex& labelled, std::string_view expression);

/// A complex with faces joined: those of one class that have an edge in common are one. Edges
/// within a class are gone, as are vertices of none of those left.
struct JoinedComplex {
  ExactComplex complex;               ///< canonical; its edges keep their sources
  std::vector<FaceId> face_of;        ///< per face of the other one, the face that it is part of
  std::vector<VertexId> vertex_from;  ///< per vertex, that of the other one
};
/// Requires: a valid complex, a class for each face. **Exact**. Cost: O(n log n).
JoinedComplex joined(const ExactComplex& complex, std::span<const std::uint32_t> face_class);

/// The faces of a set as polygons: neighbours joined, holes where they are; what touches in points
/// alone is apart, so that GEOS and JTS call the polygons valid. `area` is exact.
struct RegionPolygons {
  ExactComplex complex;
  std::vector<FacePolygon> polygons;  ///< vertices are those of `complex`
  std::vector<Rational> areas;        ///< per polygon
};
RegionPolygons region_polygons(const ExactComplex& complex, const FaceSet& faces);

/// The boundary of a set of faces by d2: per edge +1 where the set lies on its left alone, -1 where
/// on its right alone.
std::vector<std::int8_t> boundary(const Incidences& complex, const FaceSet& faces);
/// **Exact**.
Rational area(const ExactComplex& complex, const FaceSet& faces);

}  // namespace plumbline
