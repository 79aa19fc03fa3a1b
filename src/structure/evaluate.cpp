// Flattening a hierarchy: one traversal with an explicit stack.

#include <algorithm>
#include <array>
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

/// The same for a Number; a decimal has one word each, or none for 0.
std::size_t words(const Number& x) {
  if (!x.is_decimal()) return words(x.rational());
  return x.mantissa() == 0 ? 1 : 2;
}

std::size_t words(const NumberPoint& p) { return words(p.x) + words(p.y); }

template <class Function>
void for_each_entry(const Affine& map, Function function) {
  for (const Rational* entry : {&map.a, &map.b, &map.c, &map.d, &map.e, &map.f}) function(*entry);
}

/// A map with its entries as Numbers too.
struct Map {
  explicit Map(Affine affine)
      : exact(std::move(affine)),
        entries{exact.a, exact.b, exact.c, exact.d, exact.e, exact.f},
        is_decimal(std::all_of(entries.begin(), entries.end(),
                               [](const Number& entry) { return entry.is_decimal(); })) {}

  Affine exact;
  std::array<Number, 6> entries;
  bool is_decimal;
};

/// p x + q y + r; most entries of the maps in drawings are 0.
Number linear(const Number& p, const Number& x, const Number& q, const Number& y, const Number& r) {
  Number sum = p * x;
  if (sgn(q) != 0) sum = sum + q * y;
  return sgn(r) != 0 ? sum + r : sum;
}

NumberPoint apply(const Map& map, const NumberPoint& p) {
  if (map.is_decimal && p.x.is_decimal() && p.y.is_decimal()) {
    const auto& [a, b, c, d, e, f] = map.entries;
    return {linear(a, p.x, c, p.y, e), linear(d, p.y, b, p.x, f)};
  }
  Point image = apply(map.exact, Point{p.x.rational(), p.y.rational()});
  return {std::move(image.x), std::move(image.y)};
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
  using SharedMap = std::shared_ptr<const Map>;  ///< null is the identity; shared down the stack

  struct Frame {
    StructId id;
    std::size_t next;  ///< index into the body
    SharedMap map;     ///< applies to what follows in the body
  };

  /// Room for as many models and segments as are stored; shared Structs will need more.
  void reserve() {
    std::size_t models = 0;
    std::size_t segments = 0;
    for (const Struct& s : structure_.structs) {
      for (const auto& item : s.body) {
        const auto* model = std::get_if<Model>(&item);
        if (model == nullptr) continue;
        models += model->rows.empty() ? 1 : model->rows.size();
        segments += model->segments.size();
      }
    }
    result_.sources.reserve(models);
    result_.segments.reserve(segments);
    result_.segment_source.reserve(segments);
  }

  void enter(StructId id, SharedMap map) {
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

  void add(const Model& model, const Map* map) {
    if (!model.rows.empty() && model.rows.size() != model.segments.size()) {
      throw Error(ErrorCode::BadInput, "a Model with rows that are not as many as its segments");
    }
    Source source = model.source;
    source.path = path_.text();
    SourceId id;
    if (model.rows.empty()) id = result_.add_source(source);
    for (std::size_t i = 0; i < model.segments.size(); ++i) {
      if (!model.rows.empty()) {
        source.line = model.rows[i].line;
        source.column = model.rows[i].column;
        id = result_.add_source(source);
      }
      const auto numbers = model.segments.numbers(i);
      NumberPoint a{numbers[0], numbers[1]};
      NumberPoint b{numbers[2], numbers[3]};
      if (map != nullptr) {
        a = apply(*map, a);
        b = apply(*map, b);
      }
      spend(words(a) + words(b));
      result_.add(std::move(a), std::move(b), id);
    }
  }

  SharedMap product(const SharedMap& outer, const Affine& inner) {
    Affine map = outer == nullptr ? inner : compose(outer->exact, inner);
    if (map == Affine{}) return nullptr;
    for_each_entry(map, [this](const Rational& entry) {
      constexpr std::size_t kWordBits = GMP_NUMB_BITS;
      if (words(entry) > kMaxMapBits / kWordBits) {
        throw Error(ErrorCode::Limit, "nested maps make a number of more than " +
                                          std::to_string(kMaxMapBits) + " bits");
      }
      spend(words(entry));
    });
    return std::make_shared<const Map>(std::move(map));
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
