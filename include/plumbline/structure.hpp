#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "plumbline/structure/model.hpp"

namespace plumbline {

using StructId = Index<struct StructTag>;

/// Longest path that a Source holds, in bytes.
inline constexpr std::size_t kMaxPathText = 1000;

/// A rotation of the plane about the origin, from +x towards +y, that is not replaced yet: angles
/// are added along the way to a model, through similarities, and only their sum is replaced.
struct Turn {
  Rational degrees;
  Source source = {};  ///< what the ledger names where it is replaced

  friend bool operator==(const Turn&, const Turn&) = default;
};

/// LAR's Struct: an ordered body of models, maps and sub-structures. A map applies to all that
/// follows it in the same body.
struct Struct {
  using Item = std::variant<Affine, Turn, Model, LarModel, StructId>;

  std::string name;
  std::string category;
  std::vector<Item> body;

  friend bool operator==(const Struct&, const Struct&) = default;
};

/// Whether an item is a map: an Affine or a Turn.
inline bool is_map(const Struct::Item& item) {
  return std::holds_alternative<Affine>(item) || std::holds_alternative<Turn>(item);
}

/// The rotation about the origin as an item: an Affine by a multiple of 90 degrees, else a Turn.
Struct::Item rotation_item(const Rational& degrees, Source source);

/// A hierarchy of Structs, each stored once and referred to by index, with what its reader refused
/// and replaced.
struct Structure {
  std::vector<std::string> files;
  std::vector<Struct> structs;
  StructId root;
  std::vector<Rejected> rejected;
  std::vector<Remark> remarks;
  std::vector<Replacement> ledger;
  std::vector<Layer> layers;         ///< that the files declare, in their order
  double angle_bound = kAngleBound;  ///< of what stands for rotations (`rotation`)
  std::string crs;  ///< name of the coordinates' reference system, where the files have one
  std::optional<LengthUnit> unit;  ///< of the root's coordinates, where the files say it
  bool y_up = false;               ///< whether y runs upwards, in pictures; it does not in SVG

  friend bool operator==(const Structure&, const Structure&) = default;
};

/// The dimension that all models and maps of a structure have; 0 where there are none. Looks at
/// what the root refers to. Throws: Error BadInput for a cycle of references, naming its path; for
/// two items of different dimensions, naming both; for a StructId out of range, a Model whose
/// rows have other numbers of segments or ids, and what `check` finds in a LarModel. Cost: linear.
std::size_t dimension(const Structure& structure);

/// How many models a Traversal meets; 2^64 - 1 stands for that many or more. Throws: as
/// `dimension`. Cost: linear in the structure, however many they are.
std::uint64_t instance_count(const Structure& structure);

/// Largest size of one number, in bits, in a map that a Traversal makes.
inline constexpr std::size_t kMaxMapBits = std::size_t{1} << 17U;

/// The models of a structure one by one, each as often as it is referred to, with the product of
/// the maps above it: `for (Traversal t(structure); t.next();)`. Angles of Turns are added before
/// the sum is replaced, as far as what is between them is a translation, a scaling by one factor or
/// a reflection; other maps end a sum. Nothing is stored but the way from
/// the root. No recursion: depth is limited by memory only. References to Structs without models
/// are passed over. Source: larstruct 2015, 4.1.
class Traversal {
 public:
  /// Keeps a reference to the structure. Throws: as `dimension`.
  explicit Traversal(const Structure& structure);
  ~Traversal();
  Traversal(const Traversal&) = delete;
  Traversal& operator=(const Traversal&) = delete;

  /// Goes on to the next model; false at the end. Throws: Error Limit beyond kMaxMapBits, and where
  /// the maps on the way take more than kMaxEvaluatedWords.
  bool next();
  /// The current model, a Model or a LarModel, and the Struct that holds it.
  const Struct::Item& model() const;
  StructId holder() const;
  /// The product of the maps above the current model.
  const Affine& map() const;
  /// The names of the Structs above the current model, outermost first, joined by '/'; the root's
  /// and empty ones left out; a path of more than kMaxPathText characters ends in "/...".
  const std::string& path() const;
  /// The name of the innermost Struct of category "layer" above the current model; "" without one.
  const std::string& layer() const;
  /// The rotations that were replaced so far: each sum of angles that is no multiple of 90, with
  /// the first Turn that completed it and how many did.
  std::vector<Replacement> replaced() const;

 private:
  class Walk;
  std::unique_ptr<Walk> walk_;
};

/// Largest size of a result of `evaluate` or `struct_to_lar`, in 64-bit words of its numbers (an
/// integer coordinate or a decimal of up to 19 digits counts 2); shared Structs count each time
/// that they are visited.
inline constexpr std::size_t kMaxEvaluatedWords = std::size_t{1} << 28U;

/// A limit on the number of something that there is not.
inline constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

/// How large a result of `evaluate` may be.
struct EvaluateOptions {
  std::size_t max_words = kMaxEvaluatedWords;
  std::size_t max_segments = kAnyNumber;
};

/// What `Traversal::replaced` says after the last model. Throws: as Traversal.
std::vector<Replacement> replaced_rotations(const Structure& structure);

/// The segments of all models of a structure in the plane, in traversal order, each model with a
/// Source of its own whose path is that of the Traversal, and the layer where it has none. A
/// LarModel gives its `edges`. **Exact**. Curves (Model::curves) meet what meets them in the
/// drawing: an end that is known within a bound takes the place of an authored end, of another
/// curve's end or on a line within it; and a curve gets a vertex where an end lies on it, never
/// beyond the bounds, nor 1e-9 of the extent; and within 1e-12 of the extent where lines or curves
/// cross or touch it. In the ledger. Zero-length segments and cells that can't be drawn go to
/// `rejected`. Throws: as Traversal; Error BadInput for a structure of another dimension than 2;
/// Limit beyond the options, which is told before the result has grown that far.
SegmentSet evaluate(const Structure& structure, const EvaluateOptions& options = {});

/// The segments of `rounded(structure)`: what a reader has that parses numbers as doubles and then
/// computes exactly. Curves are joined where they are in `evaluate(structure)`. Throws: as these.
SegmentSet evaluate_rounded(const Structure& structure, const EvaluateOptions& options = {});

/// How `struct_to_lar` identifies vertices and cells.
struct ToLarOptions {
  /// Vertices are the same when they are equal after rounding to this many decimals, half away from
  /// zero, and get the rounded coordinates (`vcode`); else when they are equal.
  std::optional<int> decimals;
  /// Whether cells of the same vertices, in any order, are kept once, the first of them (larstruct
  /// since November 2015), or each time.
  bool merge_cells = false;
  /// Largest number of cells, repeated ones counted too.
  std::size_t max_cells = kAnyNumber;
};

/// The whole structure as one model: vertices that cells use, in the order of first use; cells in
/// traversal order, each with its vertices in the order given. First arrays go to the first array
/// and so on; segments, and models of nothing but edges, to the last; there are as many as the
/// model with the most has. **Exact** unless decimals are given. Degenerate: the empty structure
/// gives an empty model of dimension 2. Throws: as Traversal; Limit beyond `max_words` and the
/// options' cells. Source: struct2lar (larstruct 2015, 3.1).
LarModel struct_to_lar(const Structure& structure, const ToLarOptions& options = {},
                       std::size_t max_words = kMaxEvaluatedWords);

/// The least axis-parallel box, closed, `dimension` numbers each.
struct Box {
  std::vector<Number> low, high;

  friend bool operator==(const Box&, const Box&) = default;
};

/// The box of all vertices of the structure, after all maps; none where there are none. **Exact**,
/// under rotations too. Cost: each Struct is looked at once per different linear part of the maps
/// above it. Throws: as `dimension`; Error Limit where these, or their numbers, are too many.
/// Source: larstruct 2015, 2.4, which transforms only the corners
/// of nested boxes.
std::optional<Box> box(const Structure& structure);

/// The structure reduced to what stands within Structs of the given category, maps kept; Structs
/// without models are left out. Throws: as `dimension`.
Structure filter(const Structure& structure, const std::string& category);

/// The structure with every coordinate of its models and every entry of its maps **rounded** to the
/// nearest double: what a reader has that parses numbers as doubles. Segments may lose their
/// length. Throws: Error BadInput for a number beyond the largest double.
Structure rounded(Structure structure);

/// All models and maps with k more dimensions, or -k fewer; Models become LarModels (V, EV).
/// Throws: Error BadInput as the embedding of maps and models.
Structure embed(const Structure& structure, int k);

}  // namespace plumbline
