// A structure as one LAR model.

#include <algorithm>
#include <set>
#include <unordered_set>
#include <utility>

#include "plumbline/error.hpp"
#include "plumbline/structure.hpp"
#include "structure/words.hpp"

namespace plumbline {
namespace {

/// x in units of 10^-decimals, half away from zero, as a decimal.
Number rounded(const Number& x, int decimals) {
  mpz_class unit;
  mpz_ui_pow_ui(unit.get_mpz_t(), 10, static_cast<unsigned long>(decimals));
  const Rational scaled = abs(x.rational()) * unit + Rational(1, 2);
  Rational result(scaled.get_num() / scaled.get_den());
  if (sgn(x) < 0) result = -result;
  return Rational(result / unit);
}

/// The distinct vertices of a model in the order of their first use.
class VertexIndex {
 public:
  explicit VertexIndex(LarModel& model) : model_(model), known_(0, Hash{this}, Equal{this}) {}

  std::uint32_t find_or_add(std::span<const Number> vertex) {
    const std::size_t count = model_.vertex_count();
    ensure(count < 0xffffffffU, "a model holds less than 2^32 vertices");
    model_.coordinates.insert(model_.coordinates.end(), vertex.begin(), vertex.end());
    const auto [place, is_new] = known_.insert(static_cast<std::uint32_t>(count));
    if (!is_new) model_.coordinates.resize(count * model_.dimension);
    return *place;
  }

 private:
  struct Hash {
    const VertexIndex* index;
    std::size_t operator()(std::uint32_t v) const {
      std::size_t hash = 0;
      for (const Number& x : index->model_.vertex(v)) {
        constexpr std::size_t kFactor = 0x9E3779B97F4A7C15U;  // Knuth, TAOCP 6.4
        hash = (hash ^ (hash >> 32U) ^ hash_of(x)) * kFactor;
      }
      return hash;
    }
    static std::size_t hash_of(const Number& x) {
      if (x.is_decimal()) {
        return static_cast<std::size_t>(x.mantissa()) ^ static_cast<std::size_t>(x.digits()) << 56U;
      }
      const Rational value = x.rational();
      return mpz_get_ui(value.get_num_mpz_t()) ^ ~mpz_get_ui(value.get_den_mpz_t());
    }
  };
  struct Equal {
    const VertexIndex* index;
    bool operator()(std::uint32_t v, std::uint32_t w) const {
      return std::ranges::equal(index->model_.vertex(v), index->model_.vertex(w));
    }
  };

  LarModel& model_;
  std::unordered_set<std::uint32_t, Hash, Equal> known_;
};

class ToLar {
 public:
  ToLar(const Structure& structure, const ToLarOptions& options, std::size_t max_words)
      : structure_(structure),
        options_(options),
        index_(result_),
        budget_(max_words),
        cells_(options.max_cells, "segments or cells") {
    if (options.decimals && (*options.decimals < 0 || *options.decimals > Number::kMaxDigits)) {
      throw Error(ErrorCode::BadInput, "decimals are not between 0 and 18", {},
                  std::to_string(*options.decimals));
    }
  }

  LarModel run() && {
    Traversal traversal(structure_);
    while (traversal.next()) {
      const Struct::Item& item = traversal.model();
      result_.dimension = traversal.map().dimension();
      if (const auto* model = std::get_if<Model>(&item)) {
        add(lar_model(*model), traversal.map());
      } else {
        add(std::get<LarModel>(item), traversal.map());
      }
    }
    if (edges_.size() > 0) append_edges();
    return std::move(result_);
  }

 private:
  static bool are_edges(const LarModel& model) {
    const Cells* cells = model.cells.size() == 1 ? &model.cells.front() : nullptr;
    for (std::size_t c = 0; cells != nullptr && c < cells->size(); ++c) {
      if ((*cells)[c].size() != 2) return false;
    }
    return cells != nullptr && cells->size() > 0;
  }

  void add(const LarModel& model, const Affine& map) {
    budget_.spend(1 + model.vertex_count() / 2);
    vertices_.assign(model.vertex_count(), kUnknown);
    if (are_edges(model)) return append(model.cells.front(), model, map, edges_, edge_sets_);
    if (result_.cells.size() < model.cells.size()) result_.cells.resize(model.cells.size());
    cell_sets_.resize(result_.cells.size());
    for (std::size_t k = 0; k < model.cells.size(); ++k) {
      append(model.cells[k], model, map, result_.cells[k], cell_sets_[k]);
    }
  }

  using CellSets = std::set<std::vector<std::uint32_t>>;

  void append(const Cells& cells, const LarModel& model, const Affine& map, Cells& to,
              CellSets& known) {
    cells_.spend(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      cell_.clear();
      for (const std::uint32_t v : cells[c]) cell_.push_back(vertex(v, model, map));
      add_cell(to, known);
    }
  }

  void add_cell(Cells& to, CellSets& known) {
    budget_.spend(1 + cell_.size());
    if (options_.merge_cells) {
      constexpr std::size_t kWordsOfSet = 8;
      budget_.spend(kWordsOfSet);
      std::vector<std::uint32_t> set = cell_;
      std::sort(set.begin(), set.end());
      if (!known.insert(std::move(set)).second) return;
    }
    to.push_back(cell_);
  }

  /// The result's vertex for the image of the model's vertex v.
  std::uint32_t vertex(std::uint32_t v, const LarModel& model, const Affine& map) {
    if (vertices_[v] != kUnknown) return vertices_[v];
    image_.resize(model.dimension);
    apply(map, model.vertex(v), image_);
    for (Number& x : image_) {
      if (options_.decimals) x = rounded(x, *options_.decimals);
      budget_.spend(words(x));
    }
    return vertices_[v] = index_.find_or_add(image_);
  }

  /// Edges go to the last array.
  void append_edges() {
    if (result_.cells.empty()) result_.cells.resize(1);
    cell_sets_.resize(result_.cells.size());
    for (std::size_t c = 0; c < edges_.size(); ++c) {
      cell_.assign(edges_[c].begin(), edges_[c].end());
      add_cell(result_.cells.back(), cell_sets_.back());
    }
  }

  static constexpr std::uint32_t kUnknown = 0xffffffffU;

  const Structure& structure_;
  ToLarOptions options_;
  LarModel result_;
  VertexIndex index_;
  WordBudget budget_;
  CountBudget cells_;
  Cells edges_;
  CellSets edge_sets_;
  std::vector<CellSets> cell_sets_;
  std::vector<std::uint32_t> vertices_;  ///< of the current model, in the result
  std::vector<std::uint32_t> cell_;
  std::vector<Number> image_;
};

}  // namespace

LarModel struct_to_lar(const Structure& structure, const ToLarOptions& options,
                       std::size_t max_words) {
  return ToLar(structure, options, max_words).run();
}

}  // namespace plumbline
