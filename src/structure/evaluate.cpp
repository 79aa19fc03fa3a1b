// Flattening a hierarchy: one traversal with an explicit stack.

#include <memory>
#include <utility>

#include "plumbline/error.hpp"
#include "plumbline/structure.hpp"
#include "structure/name_path.hpp"

namespace plumbline {
namespace {

std::size_t words(const Rational& x) {
  return mpz_size(x.get_num_mpz_t()) + mpz_size(x.get_den_mpz_t());
}

std::size_t words(const Point& p) { return words(p.x) + words(p.y); }

template <class Function>
void for_each_entry(const Affine& map, Function function) {
  for (const Rational* entry : {&map.a, &map.b, &map.c, &map.d, &map.e, &map.f}) function(*entry);
}

class Evaluation {
 public:
  Evaluation(const Structure& structure, std::size_t max_words)
      : structure_(structure), open_(structure.structs.size(), false), words_left_(max_words) {
    result_.files = structure.files;
    result_.rejected = structure.rejected;
    result_.ledger = structure.ledger;
    reserve();
  }

  SegmentSet run() && {
    enter(structure_.root, nullptr);
    while (!frames_.empty()) {
      Frame& frame = frames_.back();
      const auto& body = structure_.structs[frame.id].body;
      if (frame.next == body.size()) {
        leave();
        continue;
      }
      spend(1);
      const auto& item = body[frame.next++];
      if (const auto* map = std::get_if<Affine>(&item)) {
        frame.map = product(frame.map, *map);
      } else if (const auto* model = std::get_if<Model>(&item)) {
        add(*model, frame.map.get());
      } else {
        enter(std::get<StructId>(item), frame.map);
      }
    }
    return std::move(result_);
  }

 private:
  using Map = std::shared_ptr<const Affine>;  ///< null is the identity; shared down the stack

  struct Frame {
    StructId id;
    std::size_t next;  ///< index into the body
    Map map;           ///< applies to what follows in the body
  };

  /// Room for as many models and segments as are stored; shared Structs will need more.
  void reserve() {
    std::size_t models = 0;
    std::size_t segments = 0;
    for (const Struct& s : structure_.structs) {
      for (const auto& item : s.body) {
        const auto* model = std::get_if<Model>(&item);
        if (model == nullptr) continue;
        ++models;
        segments += model->segments.size();
      }
    }
    result_.sources.reserve(models);
    result_.segments.reserve(segments);
    result_.segment_source.reserve(segments);
  }

  void enter(StructId id, Map map) {
    if (id >= structure_.structs.size()) {
      throw Error(ErrorCode::BadInput, "reference to a Struct that does not exist");
    }
    if (open_[id]) throw Error(ErrorCode::BadInput, "cycle of references", {}, cycle(id));
    open_[id] = true;
    if (!frames_.empty()) path_.push(structure_.structs[id].name);
    frames_.push_back({id, 0, std::move(map)});
  }

  void leave() {
    open_[frames_.back().id] = false;
    frames_.pop_back();
    if (!frames_.empty()) path_.pop();
  }

  void add(const Model& model, const Affine* map) {
    Source source = model.source;
    source.path = path_.text();
    const SourceId id = result_.add_source(std::move(source));
    for (const Segment& segment : model.segments) {
      Segment mapped =
          map == nullptr ? segment : Segment{apply(*map, segment.a), apply(*map, segment.b)};
      spend(words(mapped.a) + words(mapped.b));
      result_.add(std::move(mapped), id);
    }
  }

  Map product(const Map& outer, const Affine& inner) {
    auto map = std::make_shared<const Affine>(outer == nullptr ? inner : compose(*outer, inner));
    if (*map == Affine{}) return nullptr;
    for_each_entry(*map, [this](const Rational& entry) {
      constexpr std::size_t kWordBits = GMP_NUMB_BITS;
      if (words(entry) > kMaxMapBits / kWordBits) {
        throw Error(ErrorCode::Limit, "nested maps make a number of more than " +
                                          std::to_string(kMaxMapBits) + " bits");
      }
      spend(words(entry));
    });
    return map;
  }

  void spend(std::size_t word_count) {
    if (word_count > words_left_) {
      throw Error(ErrorCode::Limit, "the structure is too large when all references are followed");
    }
    words_left_ -= word_count;
  }

  /// The names from the first visit of `id` to the second.
  std::string cycle(StructId id) const {
    const auto name = [this](StructId s) {
      const std::string& given = structure_.structs[s].name;
      return given.empty() ? "Struct " + std::to_string(s) : given;
    };
    std::string names;
    bool inside = false;
    for (const Frame& frame : frames_) {
      inside = inside || frame.id == id;
      if (inside) names += name(frame.id) + "/";
    }
    return names + name(id);
  }

  const Structure& structure_;
  SegmentSet result_;
  std::vector<Frame> frames_;
  std::vector<bool> open_;  ///< per Struct: on the stack
  NamePath path_;
  std::size_t words_left_;
};

}  // namespace

SegmentSet evaluate(const Structure& structure, std::size_t max_words) {
  return Evaluation(structure, max_words).run();
}

}  // namespace plumbline
