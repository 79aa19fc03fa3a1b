// Grids of unit cubes of any dimension.

#include <algorithm>
#include <numeric>

#include "plumbline/error.hpp"
#include "plumbline/structure/model.hpp"

namespace plumbline {
namespace {

/// All integer points of the box with the given extents, the last coordinate fastest. Extents of 0
/// leave none.
class Odometer {
 public:
  explicit Odometer(std::vector<std::uint32_t> extents)
      : extents_(std::move(extents)), at_(extents_.size()) {
    done_ = std::find(extents_.begin(), extents_.end(), 0U) != extents_.end();
  }

  bool done() const { return done_; }
  const std::vector<std::uint32_t>& at() const { return at_; }
  void next() {
    for (std::size_t i = extents_.size(); i-- > 0;) {
      if (++at_[i] < extents_[i]) return;
      at_[i] = 0;
    }
    done_ = true;
  }

 private:
  std::vector<std::uint32_t> extents_, at_;
  bool done_ = false;
};

class Grid {
 public:
  /// Throws: Error Limit for a grid that is too large, before anything is made.
  Grid(const std::vector<std::uint32_t>& shape, bool skeletons)
      : shape_(shape), stride_(shape.size()) {
    // An axis along which a cell extends has n places with 2 corners each, any other n + 1 places.
    std::uint64_t vertices = 1;
    std::uint64_t indices = 1;
    for (std::size_t i = shape.size(); i-- > 0;) {
      const std::uint64_t n = shape[i];
      stride_[i] = static_cast<std::uint32_t>(vertices);
      vertices *= n + 1;
      indices *= skeletons ? 3 * n + 1 : 2 * n;
      require_room(vertices * shape.size());
      require_room(indices);
    }
    vertices_ = vertices;
  }

  std::vector<Number> coordinates() const {
    std::vector<Number> result;
    result.reserve(vertices_ * shape_.size());
    std::vector<std::uint32_t> extents = shape_;
    for (std::uint32_t& extent : extents) ++extent;
    for (Odometer point(extents); !point.done(); point.next()) {
      for (const std::uint32_t x : point.at()) result.push_back(Number::decimal(x, 0));
    }
    return result;
  }

  /// The cells of dimension k: for each choice of k axes, those with the last axes first, the cells
  /// that extend along them.
  Cells cells(std::size_t k) const {
    const std::size_t d = shape_.size();
    std::vector<bool> along(d, false);
    std::fill(along.end() - static_cast<std::ptrdiff_t>(k), along.end(), true);
    Cells result;
    do {
      append(along, result);
    } while (std::next_permutation(along.begin(), along.end()));
    return result;
  }

 private:
  static void require_room(std::uint64_t count) {
    if (count <= kMaxGridNumbers) return;
    throw Error(ErrorCode::Limit,
                "a grid of more than " + std::to_string(kMaxGridNumbers) + " numbers");
  }

  void append(const std::vector<bool>& along, Cells& cells) const {
    for (std::size_t i = 0; i < shape_.size(); ++i) {
      if (along[i] && shape_[i] == 0) return;
    }
    std::vector<std::uint32_t> corners{0};  // offsets of a cell's vertices from its first
    std::vector<std::uint32_t> extents = shape_;
    for (std::size_t i = 0; i < shape_.size(); ++i) {
      if (along[i]) {
        const std::vector<std::uint32_t> low = corners;
        for (const std::uint32_t corner : low) corners.push_back(corner + stride_[i]);
      } else {
        ++extents[i];
      }
    }
    std::sort(corners.begin(), corners.end());
    std::vector<std::uint32_t> cell(corners.size());
    for (Odometer point(extents); !point.done(); point.next()) {
      const auto first = std::inner_product(stride_.begin(), stride_.end(), point.at().begin(), 0U);
      std::transform(corners.begin(), corners.end(), cell.begin(),
                     [first](std::uint32_t corner) { return first + corner; });
      cells.push_back(cell);
    }
  }

  std::vector<std::uint32_t> shape_;
  std::vector<std::uint32_t> stride_;  ///< of the vertex numbers, per axis
  std::uint64_t vertices_ = 0;
};

}  // namespace

LarModel cuboids(const std::vector<std::uint32_t>& shape, bool skeletons) {
  constexpr std::size_t kMaxAxes = 24;  // 2^24 corners per cell
  if (shape.empty()) throw Error(ErrorCode::BadInput, "a grid of dimension 0");
  if (shape.size() > kMaxAxes) {
    throw Error(ErrorCode::Limit, "a grid of more than 24 dimensions");
  }
  const Grid grid(shape, skeletons);
  LarModel model;
  model.dimension = shape.size();
  model.coordinates = grid.coordinates();
  model.cells.push_back(grid.cells(shape.size()));
  if (skeletons) {
    for (std::size_t k = shape.size(); k-- > 0;) model.cells.push_back(grid.cells(k));
  }
  return model;
}

}  // namespace plumbline
