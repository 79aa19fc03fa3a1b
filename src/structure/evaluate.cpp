// Flattening a hierarchy in the plane to segments.

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "geometry/text_rounding.hpp"
#include "plumbline/error.hpp"
#include "plumbline/structure.hpp"
#include "structure/joints.hpp"
#include "structure/plane_map.hpp"
#include "structure/words.hpp"

namespace plumbline {
namespace {

std::size_t words(const NumberPoint& p) { return plumbline::words(p.x) + plumbline::words(p.y); }

class Evaluation {
 public:
  Evaluation(const Structure& structure, const EvaluateOptions& options)
      : structure_(structure),
        traversal_(structure),
        budget_(options.max_words),
        segments_(options.max_segments, "segments") {
    result_.files = structure.files;
    result_.rejected = structure.rejected;
    result_.ledger = structure.ledger;
    result_.y_up = structure.y_up;
    reserve();
  }

  void run() {
    while (traversal_.next()) {
      const Struct::Item& item = traversal_.model();
      if (traversal_.map().dimension() != 2) {
        throw Error(ErrorCode::BadInput, "a structure of dimension " +
                                             std::to_string(traversal_.map().dimension()) +
                                             " has no segments in the plane; project it first");
      }
      const PlaneMap map(traversal_.map());
      if (const auto* model = std::get_if<Model>(&item)) {
        add(*model, map);
      } else {
        add(std::get<LarModel>(item), map);
      }
    }
  }
  SegmentSet segments() && { return std::move(result_); }
  /// Of what `segments` gives.
  PlacedCurves curves() const {
    std::vector<double> rounding = rounding_;
    rounding.resize(result_.segments.size());
    return {result_, curves_, std::move(rounding)};
  }

 private:
  /// Room for as many models and segments as are stored; shared Structs will need more.
  void reserve() {
    std::size_t models = 0;
    std::size_t segments = 0;
    for (const Struct& s : structure_.structs) {
      for (const auto& item : s.body) {
        const auto* model = std::get_if<Model>(&item);
        if (model == nullptr) continue;
        models += model->rows.empty() ? 1 : model->rows.size();
        has_curves_ = has_curves_ || !model->curves.empty();
        segments += model->segments.size();
      }
    }
    result_.sources.reserve(models);
    result_.segments.reserve(segments);
    result_.segment_source.reserve(segments);
  }

  SourceId add_source(Source source) {
    budget_.spend(1);
    source.path = traversal_.path();
    return result_.add_source(source);
  }

  void add(const Model& model, const PlaneMap& map) {
    Source source = model.source;
    if (model.rows.empty()) {
      const std::size_t first = result_.segments.size();
      add(model.segments, 0, model.segments.size(), add_source(source), map);
      const bool is_whole = result_.segments.size() == first + model.segments.size();
      if (is_whole) add_curves(model, first);
      return;
    }
    source.path = traversal_.path();
    std::size_t begin = 0;
    for (const Model::Row& row : model.rows) {
      source.line = row.line;
      source.column = row.column;
      source.id = row.id == 0 ? model.source.id : model.row_ids[row.id - 1];
      budget_.spend(1);
      add(model.segments, begin, row.segment_count, result_.add_source(source), map);
      begin += row.segment_count;
    }
  }

  void add(const SegmentList& segments, std::size_t begin, std::size_t count, SourceId source,
           const PlaneMap& map) {
    segments_.spend(count);
    for (std::size_t i = begin; i < begin + count; ++i) {
      const auto numbers = segments.numbers(i);
      const std::size_t before = result_.segments.size();
      NumberPoint a = map({numbers[0], numbers[1]});
      NumberPoint b = map({numbers[2], numbers[3]});
      budget_.spend(words(a) + words(b));
      add(std::move(a), std::move(b), source);
      if (has_curves_ && result_.segments.size() > before) add_rounding(numbers);
    }
  }

  void add_rounding(std::span<const Number, 4> numbers) {
    const double ends =
        std::max(text_rounding(numbers[0], numbers[1]), text_rounding(numbers[2], numbers[3]));
    rounding_.resize(result_.segments.size());
    rounding_.back() = ends == 0 ? 0 : ends * stretch(traversal_.map());
  }

  /// The curves of a model whose segments are in their places, from `first` on.
  void add_curves(const Model& model, std::size_t first) {
    constexpr std::size_t kWordsOfCurve = 40;
    const Affine& map = traversal_.map();
    const auto turned = [&](const Point& p) {
      const Point zero = apply(map, Point{}), image = apply(map, p);
      return Point{image.x - zero.x, image.y - zero.y};
    };
    for (Curve curve : model.curves) {
      budget_.spend(kWordsOfCurve);
      curve.first += static_cast<std::uint32_t>(first);
      if (curve.ellipse) {
        curve.ellipse = Ellipse{apply(map, curve.ellipse->centre), turned(curve.ellipse->u),
                                turned(curve.ellipse->v)};
      }
      for (double* bound :
           {&curve.chord_bound, &curve.end_bounds[0], &curve.end_bounds[1], &curve.bound}) {
        *bound *= stretch(map);
      }
      curves_.push_back(std::move(curve));
    }
  }

  /// No point of the plane is moved further from another one by the map than so many times.
  static double stretch(const Affine& map) {
    double sum = 0;
    for (const std::size_t row : {0, 1}) {
      for (const std::size_t column : {0, 1}) {
        const double entry = nearest_double(map(row, column));
        sum += entry * entry;
      }
    }
    return std::sqrt(sum);
  }

  void add(NumberPoint a, NumberPoint b, SourceId source) {
    constexpr std::size_t kWordsOfRejected = 50;
    const std::size_t rejected = result_.rejected.size();
    result_.add(std::move(a), std::move(b), source);
    if (result_.rejected.size() > rejected) budget_.spend(kWordsOfRejected);
  }

  void add(const LarModel& model, const PlaneMap& map) {
    const SourceId id = add_source(model.source);
    const ModelEdges& known = edges_of(model);
    segments_.spend(known.edges.size());
    budget_.spend(model.vertex_count());
    images_.clear();
    for (std::size_t v = 0; v < model.vertex_count(); ++v) {
      images_.push_back(map({model.vertex(v)[0], model.vertex(v)[1]}));
    }
    for (const auto& [tail, head] : known.edges) {
      budget_.spend(words(images_[tail]) + words(images_[head]));
      add(images_[tail], images_[head], id);
    }
  }

  /// The edges of a model, which are looked for once.
  const ModelEdges& edges_of(const LarModel& model) {
    const auto [place, is_new] = edges_.try_emplace(&model);
    if (!is_new) return place->second;
    place->second = edges(model);
    Source source = model.source;
    source.path = traversal_.path();
    for (const auto& [cell, reason] : place->second.refused) {
      result_.rejected.push_back({source, reason, "cell " + std::to_string(cell)});
    }
    return place->second;
  }

  const Structure& structure_;
  Traversal traversal_;
  SegmentSet result_;
  std::unordered_map<const LarModel*, ModelEdges> edges_;
  std::vector<NumberPoint> images_;  ///< of the current LarModel's vertices
  bool has_curves_ = false;
  std::vector<Curve> curves_;
  std::vector<double> rounding_;  ///< where there are curves, per segment
  WordBudget budget_;
  CountBudget segments_;
};

}  // namespace

SegmentSet evaluate(const Structure& structure, const EvaluateOptions& options) {
  Evaluation evaluation(structure, options);
  evaluation.run();
  const Joints joints = find_joints(evaluation.curves());
  return with_joints(std::move(evaluation).segments(), joints);
}

SegmentSet evaluate_rounded(const Structure& structure, const EvaluateOptions& options) {
  Evaluation evaluation(structure, options);
  evaluation.run();
  const PlacedCurves curves = evaluation.curves();
  SegmentSet result = evaluate(rounded(structure), options);
  if (result.segments.size() != curves.set.segments.size()) return result;
  return with_joints(std::move(result), find_joints(curves));
}

}  // namespace plumbline
