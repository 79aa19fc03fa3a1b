#pragma once

#include <string>
#include <variant>
#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline {

/// Exact affine map of the plane: (x, y) -> (a x + c y + e, b x + d y + f), the order of SVG's
/// matrix(a b c d e f).
struct Affine {
  Rational a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  friend bool operator==(const Affine&, const Affine&) = default;
};

Point apply(const Affine& map, const Point& p);
/// The map that applies `inner` first, then `outer`.
Affine compose(const Affine& outer, const Affine& inner);
Affine translation(const Rational& dx, const Rational& dy);
Affine scaling(const Rational& sx, const Rational& sy);

/// An affine map that stands for one whose entries are not rational. The bound is 0 where the map
/// is exactly the one asked for.
struct ApproximateAffine {
  Affine map;
  Rational bound;
};

/// Default bound on the angle by which `rotation` may deviate, in radians.
inline constexpr double kAngleBound = 1e-15;

/// Rotation about the origin by an angle in degrees (from +x towards +y). A multiple of 90 is
/// exact. Any other angle is replaced by a rational rotation (((1-t^2)/(1+t^2), 2t/(1+t^2)) with
/// rational t, so still an exact isometry) whose angle deviates by at most `bound` radians; the
/// bound is in the result. The simplest such t within the bound is taken (a convergent of a
/// continued fraction). Throws: Error BadInput for a bound that is not positive and finite; the
/// same below.
ApproximateAffine rotation(const Rational& degrees, double bound = kAngleBound);
/// Skew along x (x += y tan(angle)), along y. Exact for angles with a rational tangent among the
/// multiples of 45 degrees; else the tangent is replaced by a rational one within `bound`
/// (absolute). Throws: Error BadInput for odd multiples of 90 degrees.
ApproximateAffine skew_x(const Rational& degrees, double bound = kAngleBound);
ApproximateAffine skew_y(const Rational& degrees, double bound = kAngleBound);

using StructId = Index<struct StructTag>;

/// Longest path that a Source holds, in bytes.
inline constexpr std::size_t kMaxPathText = 1000;

/// Segments of one drawing element, in the coordinates of the Struct that holds it; or of a table
/// of rows, each an element of its own.
struct Model {
  /// Where a row begins.
  struct Row {
    std::uint32_t line = 0, column = 0;
  };

  Source source;  ///< its `path` is filled in by `evaluate`
  SegmentList segments;
  std::vector<Row> rows;  ///< empty, or per segment what replaces the source's line and column
};

/// LAR's Struct: an ordered body of models, affine maps and sub-structures. A map applies to all
/// that follows it in the same body.
struct Struct {
  std::string name;
  std::string category;
  std::vector<std::variant<Affine, Model, StructId>> body;
};

/// A hierarchy of Structs, each stored once and referred to by index, with what its reader refused
/// and replaced.
struct Structure {
  std::vector<std::string> files;
  std::vector<Struct> structs;
  StructId root;
  std::vector<Rejected> rejected;
  std::vector<Replacement> ledger;
};

/// Largest size of one number, in bits, in a map that `evaluate` makes.
inline constexpr std::size_t kMaxMapBits = std::size_t{1} << 17U;
/// Largest size of a result of `evaluate`, in 64-bit words of its numbers (an integer coordinate or
/// a decimal of up to 19 digits counts 2); shared Structs count each time that they are visited.
inline constexpr std::size_t kMaxEvaluatedWords = std::size_t{1} << 28U;

/// All models of the structure in traversal order, mapped by the product of the maps above them,
/// each with a Source of its own whose path is the names of the Structs above it (the root's and
/// empty ones left out; a path of more than kMaxPathText characters ends in "/..."). **Exact**.
/// Zero-length segments go to `rejected`. No recursion: depth is limited by memory only. Throws:
/// Error BadInput for a cycle of references, naming its path, for a StructId out of range and
/// for a Model with rows that are not as many as its segments; Limit beyond kMaxMapBits and
/// `max_words`. Source: larstruct 2015, 4.1.
SegmentSet evaluate(const Structure& structure, std::size_t max_words = kMaxEvaluatedWords);

}  // namespace plumbline
