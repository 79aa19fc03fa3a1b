// Exact boxes of structures.

#include <map>
#include <utility>

#include "plumbline/error.hpp"
#include "plumbline/structure.hpp"
#include "structure/check.hpp"
#include "structure/placement.hpp"
#include "structure/words.hpp"

namespace plumbline {
namespace {

using MaybeBox = std::optional<Box>;

/// Of the maps under which boxes are known: one for each Struct and linear part.
constexpr std::size_t kMaxBoxWords = std::size_t{1} << 24U;

void extend(MaybeBox& box, std::span<const Number> p) {
  if (!box) box = Box{{p.begin(), p.end()}, {p.begin(), p.end()}};
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i] < box->low[i]) box->low[i] = p[i];
    if (p[i] > box->high[i]) box->high[i] = p[i];
  }
}

/// Boxes of Structs under linear maps: that of a Struct is put together from those of the Structs
/// in it, each under the linear part of the product of the maps above it, moved by its rest.
class Boxes {
 public:
  Boxes(const Structure& structure, const Checked& checked)
      : structure_(structure),
        checked_(checked),
        dimension_(checked.dimension),
        rotations_(structure.angle_bound) {}

  MaybeBox run() {
    const Placement identity(dimension_);
    const auto root = known_.try_emplace({structure_.root, identity.key()}).first;
    frames_.push_back({structure_.root, 0, identity, {}, &root->second});
    while (!frames_.empty()) {
      Frame& frame = frames_.back();
      const auto& body = structure_.structs[frame.id].body;
      if (frame.next == body.size()) {
        *frame.result = std::move(frame.box);
        frames_.pop_back();
      } else {
        look_at(body[frame.next], frame);
      }
    }
    return root->second;
  }

 private:
  using Key = std::pair<StructId, std::vector<Number>>;

  struct Frame {
    StructId id;
    std::size_t next;  ///< index into the body
    Placement map;     ///< of what follows
    MaybeBox box;      ///< of what came before
    MaybeBox* result;
  };

  /// Takes the frame's next item, unless it has to wait for a Struct that is not known yet.
  void look_at(const Struct::Item& item, Frame& frame) {
    if (const auto* id = std::get_if<StructId>(&item)) {
      if (checked_.instances[*id] == 0) {
        ++frame.next;
        return;
      }
      Placement linear = frame.map.linear_part();
      const auto [place, is_new] = known_.try_emplace({*id, linear.key()});
      if (is_new) {
        budget_.spend(2 * linear.checked_words());  // here and on the way
        frames_.push_back({*id, 0, std::move(linear), {}, &place->second});
        return;  // comes back to this item
      }
      if (place->second) add(*place->second, frame);
    } else if (is_map(item)) {
      frame.map.append(item, rotations_);
      frame.map.checked_words();
    } else if (const auto* model = std::get_if<Model>(&item)) {
      for (std::size_t i = 0; i < model->segments.size(); ++i) {
        add(model->segments.numbers(i).first<2>(), frame);
        add(model->segments.numbers(i).last<2>(), frame);
      }
    } else {
      const auto& lar = std::get<LarModel>(item);
      for (std::size_t v = 0; v < lar.vertex_count(); ++v) add(lar.vertex(v), frame);
    }
    ++frame.next;
  }

  void add(std::span<const Number> vertex, Frame& frame) {
    image_.resize(dimension_);
    apply(frame.map.map(rotations_), vertex, image_);
    extend(frame.box, image_);
  }

  /// A box that lacks only the map's translation.
  void add(Box box, Frame& frame) {
    const Affine& map = frame.map.map(rotations_);
    for (std::size_t i = 0; i < dimension_; ++i) {
      box.low[i] = box.low[i] + map(i, dimension_);
      box.high[i] = box.high[i] + map(i, dimension_);
    }
    extend(frame.box, box.low);
    extend(frame.box, box.high);
  }

  const Structure& structure_;
  const Checked& checked_;
  std::size_t dimension_;
  Rotations rotations_;
  WordBudget budget_{kMaxBoxWords};
  std::map<Key, MaybeBox> known_;
  std::vector<Frame> frames_;
  std::vector<Number> image_;
};

}  // namespace

std::optional<Box> box(const Structure& structure) {
  const Checked checked = check(structure);
  if (checked.dimension == 0) return std::nullopt;
  return Boxes(structure, checked).run();
}

}  // namespace plumbline
