// One depth-first look at every Struct that the root refers to.

#include "structure/check.hpp"

#include <utility>

#include "plumbline/error.hpp"

namespace plumbline {
namespace {

std::string name_of(const Structure& structure, StructId id) {
  const std::string& name = structure.structs[id].name;
  return name.empty() ? "Struct " + std::to_string(id) : name;
}

class Check {
 public:
  explicit Check(const Structure& structure)
      : structure_(structure), states_(structure.structs.size(), State::New) {
    result_.instances.resize(structure.structs.size());
  }

  Checked run() && {
    enter(structure_.root);
    while (!frames_.empty()) {
      Frame& frame = frames_.back();
      const auto& body = structure_.structs[frame.id].body;
      if (frame.next == body.size()) {
        leave();
      } else {
        const std::size_t item = frame.next++;
        look_at(body[item], frame.id, item);
      }
    }
    return std::move(result_);
  }

 private:
  enum class State : unsigned char { New, Open, Done };
  struct Frame {
    StructId id;
    std::size_t next;  ///< index into the body
  };

  void enter(StructId id) {
    if (id >= structure_.structs.size()) {
      throw Error(ErrorCode::BadInput, "reference to a Struct that does not exist");
    }
    if (states_[id] == State::Open) {
      throw Error(ErrorCode::BadInput, "cycle of references", {}, cycle(id));
    }
    if (states_[id] == State::Done) return;
    states_[id] = State::Open;
    frames_.push_back({id, 0});
  }

  void leave() {
    const StructId id = frames_.back().id;
    states_[id] = State::Done;
    frames_.pop_back();
    if (!frames_.empty()) count(frames_.back().id, result_.instances[id]);
  }

  static void check_rows(const Model& model) {
    if (model.rows.empty()) return;
    std::size_t segments = 0;
    bool has_ids = true;
    for (const Model::Row& row : model.rows) {
      segments += row.segment_count;
      has_ids = has_ids && row.id <= model.row_ids.size();
    }
    if (has_ids && segments == model.segments.size()) return;
    throw Error(ErrorCode::BadInput, "a Model whose rows have other numbers of segments or ids");
  }

  static void check_rings(const Model& model) {
    std::size_t end = 0;
    for (const Ring& ring : model.rings) {
      if (ring.first < end || ring.count > model.segments.size() ||
          ring.first > model.segments.size() - ring.count) {
        throw Error(ErrorCode::BadInput, "a Model whose rings are not among its segments in turn");
      }
      end = std::size_t{ring.first} + ring.count;
    }
  }

  void look_at(const Struct::Item& item, StructId holder, std::size_t index) {
    if (const auto* id = std::get_if<StructId>(&item)) {
      const bool is_done = *id < states_.size() && states_[*id] == State::Done;
      enter(*id);
      if (is_done) count(holder, result_.instances[*id]);  // else when it is left
    } else if (const auto* map = std::get_if<Affine>(&item)) {
      agree("map", map->dimension(), holder, index);
    } else if (std::holds_alternative<Turn>(item)) {
      agree("rotation", 2, holder, index);
    } else if (const auto* model = std::get_if<Model>(&item)) {
      check_rows(*model);
      check_rings(*model);
      agree("model", 2, holder, index);
      count(holder, 1);
    } else {
      const auto& lar = std::get<LarModel>(item);
      check(lar, structure_.files);
      agree("model", lar.dimension, holder, index);
      count(holder, 1);
    }
  }

  void count(StructId holder, std::uint64_t more) {
    std::uint64_t& instances = result_.instances[holder];
    constexpr std::uint64_t kMost = ~std::uint64_t{0};
    instances = more > kMost - instances ? kMost : instances + more;
  }

  void agree(const char* kind, std::size_t dimension, StructId holder, std::size_t index) {
    const auto told = [&] {
      return "a " + std::string(kind) + " of dimension " + std::to_string(dimension) + " (item " +
             std::to_string(index + 1) + " of " + name_of(structure_, holder) + ")";
    };
    if (result_.dimension == 0) {
      result_.dimension = dimension;
      first_ = told();
    } else if (result_.dimension != dimension) {
      throw Error(ErrorCode::BadInput, "mixed dimensions: " + told() + " and " + first_);
    }
  }

  /// The names from the first visit of `id` to the second.
  std::string cycle(StructId id) const {
    std::string names;
    bool inside = false;
    for (const Frame& frame : frames_) {
      inside = inside || frame.id == id;
      if (inside) names += name_of(structure_, frame.id) + "/";
    }
    return names + name_of(structure_, id);
  }

  const Structure& structure_;
  std::vector<State> states_;
  std::vector<Frame> frames_;
  std::string first_;  ///< what gave the dimension
  Checked result_;
};

}  // namespace

Checked check(const Structure& structure) { return Check(structure).run(); }

std::size_t dimension(const Structure& structure) { return check(structure).dimension; }

std::uint64_t instance_count(const Structure& structure) {
  return check(structure).instances[structure.root];
}

}  // namespace plumbline
