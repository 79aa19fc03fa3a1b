// Walking a hierarchy with an explicit stack.

#include <algorithm>
#include <utility>

#include "plumbline/error.hpp"
#include "plumbline/structure.hpp"
#include "structure/check.hpp"
#include "structure/name_path.hpp"
#include "structure/placement.hpp"
#include "structure/replaced_rotations.hpp"
#include "structure/words.hpp"

namespace plumbline {

/// The way from the root to the current model.
class Traversal::Walk {
 public:
  Walk(const Structure& structure, Checked checked)
      : structure_(structure),
        instances_(std::move(checked.instances)),
        identity_(std::make_shared<Placement>(std::max<std::size_t>(checked.dimension, 1))),
        rotations_(structure.angle_bound) {
    if (instances_[structure.root] > 0) frames_.push_back({structure.root, 0, identity_, 0});
  }

  bool next() {
    while (!frames_.empty()) {
      Frame& frame = frames_.back();
      const auto& body = structure_.structs[frame.id].body;
      if (frame.next == body.size()) {
        leave();
        continue;
      }
      const Struct::Item& item = body[frame.next++];
      if (is_map(item)) {
        append(item, frame);
      } else if (const auto* id = std::get_if<StructId>(&item)) {
        enter(*id, frame.map);
      } else {
        model_ = &item;
        map_ = &frame.map->map(rotations_);
        replaced_.add(*frame.map, rotations_);
        return true;
      }
    }
    return false;
  }

  const Struct::Item& model() const { return *model_; }
  StructId holder() const { return frames_.back().id; }
  const Affine& map() const { return *map_; }
  const std::string& path() const { return path_.text(); }
  const std::string& layer() const {
    static const std::string none;
    const auto of_layer = [&](const Frame& frame) {
      return structure_.structs[frame.id].category == "layer";
    };
    const auto found = std::find_if(frames_.rbegin(), frames_.rend(), of_layer);
    return found == frames_.rend() ? none : structure_.structs[found->id].name;
  }
  std::vector<Replacement> replaced() const { return replaced_.ledger(structure_.angle_bound); }

 private:
  using SharedMap = std::shared_ptr<Placement>;  ///< shared down the stack

  struct Frame {
    StructId id;
    std::size_t next;       ///< index into the body
    SharedMap map;          ///< applies to what follows in the body
    std::size_t words = 0;  ///< of the map, if it was made for this frame
  };

  void enter(StructId id, SharedMap map) {
    if (instances_[id] == 0) return;
    path_.push(structure_.structs[id].name);
    frames_.push_back({id, 0, std::move(map), 0});
  }

  void leave() {
    live_words_ -= frames_.back().words;
    frames_.pop_back();
    if (!frames_.empty()) path_.pop();
  }

  void append(const Struct::Item& inner, Frame& frame) {
    Placement map = *frame.map;
    map.append(inner, rotations_);
    live_words_ -= frame.words;
    frame.words = map.checked_words();
    live_words_ += frame.words;
    if (live_words_ > kMaxEvaluatedWords) {
      throw Error(ErrorCode::Limit, "nested maps take too much memory");
    }
    frame.map = std::make_shared<Placement>(std::move(map));
  }

  const Structure& structure_;
  std::vector<std::uint64_t> instances_;
  SharedMap identity_;
  std::vector<Frame> frames_;
  const Struct::Item* model_ = nullptr;
  const Affine* map_ = nullptr;
  Rotations rotations_;
  ReplacedRotations replaced_;
  std::size_t live_words_ = 0;  ///< of all maps on the way
  NamePath path_;
};

std::size_t checked_words(const Affine& map) {
  constexpr std::size_t kWordBits = GMP_NUMB_BITS;
  std::size_t sum = 0;
  for (const Number& entry : map.entries()) {
    if (words(entry) > kMaxMapBits / kWordBits) {
      throw Error(ErrorCode::Limit, "nested maps make a number of more than " +
                                        std::to_string(kMaxMapBits) + " bits");
    }
    sum += words(entry);
  }
  return sum;
}

Traversal::Traversal(const Structure& structure)
    : walk_(std::make_unique<Walk>(structure, check(structure))) {}
Traversal::~Traversal() = default;

bool Traversal::next() { return walk_->next(); }
const Struct::Item& Traversal::model() const { return walk_->model(); }
StructId Traversal::holder() const { return walk_->holder(); }
const Affine& Traversal::map() const { return walk_->map(); }
const std::string& Traversal::path() const { return walk_->path(); }
const std::string& Traversal::layer() const { return walk_->layer(); }
std::vector<Replacement> Traversal::replaced() const { return walk_->replaced(); }

std::vector<Replacement> replaced_rotations(const Structure& structure) {
  Traversal traversal(structure);
  while (traversal.next()) {
  }
  return traversal.replaced();
}

}  // namespace plumbline
