// Flattening a hierarchy in the plane to segments.

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

#include "geometry/authored_unit.hpp"
#include "number/short_decimal.hpp"
#include "plumbline/error.hpp"
#include "plumbline/structure.hpp"
#include "structure/joints.hpp"
#include "structure/map_rounding.hpp"
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
    result_.remarks = structure.remarks;
    result_.ledger = structure.ledger;
    result_.crs = structure.crs;
    result_.unit = structure.unit;
    result_.layers = structure.layers;
    result_.y_up = structure.y_up;
    reserve();
  }

  void run() {
    const double angle = largest_angle(structure_);
    while (traversal_.next()) {
      const Struct::Item& item = traversal_.model();
      if (traversal_.map().dimension() != 2) {
        throw Error(ErrorCode::BadInput, "a structure of dimension " +
                                             std::to_string(traversal_.map().dimension()) +
                                             " has no segments in the plane; project it first");
      }
      const PlaneMap map(traversal_.map());
      rounding_.emplace(traversal_.map(), angle);
      if (const auto* model = std::get_if<Model>(&item)) {
        add(*model, map);
      } else {
        add(std::get<LarModel>(item), map);
      }
    }
    for (Replacement& replaced : traversal_.replaced()) {
      result_.ledger.push_back(std::move(replaced));
    }
  }
  SegmentSet segments() && {
    result_.authored_unit = unit_.unit();
    return std::move(result_);
  }
  /// Of what `segments` gives.
  PlacedCurves curves() const {
    std::vector<double> rounding = result_.rounding;
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
        segments += model->segments.size();
      }
    }
    result_.sources.reserve(models);
    result_.segments.reserve(segments);
    result_.segment_source.reserve(segments);
  }

  /// The source with the names that stand above it.
  Source placed(Source source) const {
    source.path = traversal_.path();
    if (source.layer.empty()) source.layer = traversal_.layer();
    return source;
  }
  SourceId add_source(const Source& source) {
    budget_.spend(1);
    return result_.add_source(source);
  }

  void add(const Model& model, const PlaneMap& map) {
    Source source = placed(model.source);
    if (model.rows.empty()) {
      const SourceId id = add_source(source);
      const std::size_t first = result_.segments.size();
      add(model.segments, 0, model.segments.size(), id, map);
      for (const Model::Text& label : model.labels) add_label(label, id, map);
      const bool is_whole = result_.segments.size() == first + model.segments.size();
      add_rings(model);
      if (is_whole) add_curves(model, first);
      return;
    }
    std::size_t begin = 0;
    auto label = model.labels.begin();
    for (const Model::Row& row : model.rows) {
      source.line = row.line;
      source.column = row.column;
      source.id = row.id == 0 ? model.source.id : model.row_ids[row.id - 1];
      const SourceId id = add_source(source);
      add(model.segments, begin, row.segment_count, id, map);
      begin += row.segment_count;
      const auto number = static_cast<std::size_t>(&row - model.rows.data());
      for (; label != model.labels.end() && label->row == number; ++label) {
        add_label(*label, id, map);
      }
    }
    add_rings(model);
  }

  void add_label(const Model::Text& label, SourceId source, const PlaneMap& map) {
    constexpr std::size_t kWordsOfLabel = 20;
    budget_.spend(kWordsOfLabel + label.text.size() / 8);
    Label placed{source, label.text, {}, label.height * rounding_->stretch()};
    if (label.place) {
      const NumberPoint place = map(*label.place);
      placed.place = Point{place.x.rational(), place.y.rational()};
    }
    result_.labels.push_back(std::move(placed));
  }

  void add(const SegmentList& segments, std::size_t begin, std::size_t count, SourceId source,
           const PlaneMap& map) {
    segments_.spend(count);
    if (begin == 0) places_.clear();
    for (std::size_t i = begin; i < begin + count; ++i) {
      const auto numbers = segments.numbers(i);
      const std::size_t before = result_.segments.size();
      places_.push_back(static_cast<std::uint32_t>(before));
      NumberPoint a = map({numbers[0], numbers[1]});
      NumberPoint b = map({numbers[2], numbers[3]});
      budget_.spend(words(a) + words(b));
      add(std::move(a), std::move(b), source);
      if (result_.segments.size() == before) continue;
      for (const Number& number : numbers) unit_.add(number, rounding_->scale());
      note_rounding(
          std::max(rounding_->of(numbers[0], numbers[1]), rounding_->of(numbers[2], numbers[3])));
    }
  }

  /// The rings of the model whose segments have just been added: of what is left of them. One that
  /// has lost more than segments without length is none.
  void add_rings(const Model& model) {
    places_.push_back(static_cast<std::uint32_t>(result_.segments.size()));
    const auto is_broken = [&](std::uint32_t i) {
      const auto from = result_.segments.numbers(i - 1), to = result_.segments.numbers(i);
      return from[2] != to[0] || from[3] != to[1];
    };
    for (const Ring& ring : model.rings) {
      const std::uint32_t first = places_[ring.first], end = places_[ring.first + ring.count];
      const Ring placed{first, end - first, ring.role};
      bool is_whole = true;
      if (placed.count != ring.count) {
        for (std::uint32_t i = first + 1; i < end; ++i) is_whole = is_whole && !is_broken(i);
      }
      if (is_whole) result_.rings.push_back(placed);
    }
  }

  /// Of the last segment.
  void note_rounding(double rounding) {
    if (rounding == 0) return;
    result_.rounding.resize(result_.segments.size());
    result_.rounding.back() = rounding;
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
        *bound *= rounding_->stretch();
      }
      curves_.push_back(std::move(curve));
    }
  }

  void add(NumberPoint a, NumberPoint b, SourceId source) {
    constexpr std::size_t kWordsOfRejected = 50;
    const std::size_t rejected = result_.rejected.size();
    result_.add(std::move(a), std::move(b), source);
    if (result_.rejected.size() > rejected) budget_.spend(kWordsOfRejected);
  }

  void add(const LarModel& model, const PlaneMap& map) {
    const SourceId id = add_source(placed(model.source));
    const ModelEdges& known = edges_of(model);
    segments_.spend(known.edges.size());
    budget_.spend(model.vertex_count());
    images_.clear();
    for (std::size_t v = 0; v < model.vertex_count(); ++v) {
      images_.push_back(map({model.vertex(v)[0], model.vertex(v)[1]}));
    }
    for (std::size_t v = 0; v < model.vertex_count(); ++v) {
      for (const std::size_t axis : {0, 1}) unit_.add(model.vertex(v)[axis], rounding_->scale());
    }
    const auto rounding = [&](std::uint32_t v) {
      return rounding_->of(model.vertex(v)[0], model.vertex(v)[1]);
    };
    for (const auto& [tail, head] : known.edges) {
      budget_.spend(words(images_[tail]) + words(images_[head]));
      const std::size_t before = result_.segments.size();
      add(images_[tail], images_[head], id);
      if (result_.segments.size() > before) note_rounding(std::max(rounding(tail), rounding(head)));
    }
  }

  /// The edges of a model, which are looked for once.
  const ModelEdges& edges_of(const LarModel& model) {
    const auto [place, is_new] = edges_.try_emplace(&model);
    if (!is_new) return place->second;
    place->second = edges(model);
    const Source source = placed(model.source);
    for (const auto& [cell, reason] : place->second.refused) {
      result_.rejected.push_back({source, reason, "cell " + std::to_string(cell)});
    }
    return place->second;
  }

  const Structure& structure_;
  Traversal traversal_;
  SegmentSet result_;
  std::unordered_map<const LarModel*, ModelEdges> edges_;
  std::vector<NumberPoint> images_;    ///< of the current LarModel's vertices
  std::vector<std::uint32_t> places_;  ///< of the current Model's segments in the result
  std::vector<Curve> curves_;
  std::optional<MapRounding> rounding_;  ///< of the current model
  AuthoredUnit unit_;
  WordBudget budget_;
  CountBudget segments_;
};

/// The segments, with what programs and curves add to the rounding of their texts: a program that
/// prints long numbers has computed them from others as large as the drawing is but for a tenth of
/// it, which may lie far away; the chords of a curve are known no better than the curve.
SegmentSet with_rounding(SegmentSet set, const std::vector<Curve>& curves) {
  if (set.rounding.empty() && curves.empty()) return set;
  set.rounding.resize(set.segments.size());
  for (const Curve& curve : curves) {
    for (std::size_t i = curve.first; i < curve.first + curve.count; ++i) {
      set.rounding[i] = std::max(set.rounding[i], curve.bound);
    }
  }
  std::vector<double> largest;  // coordinate, per segment
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    largest.push_back(0);
    for (const Number& n : set.segments.numbers(i)) {
      largest.back() = std::max(largest.back(), std::abs(nearest_double(n)));
    }
  }
  std::vector<double> sorted = largest;
  const auto most = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 9 / 10);
  std::nth_element(sorted.begin(), most, sorted.end());
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    const double size = most == sorted.end() ? 0 : std::max(*most, largest[i]);
    double& rounding = set.rounding[i];
    if (rounding > 0) rounding = std::max(rounding, kDriftOfPrograms * kUnit * size);
  }
  return set;
}

}  // namespace

SegmentSet evaluate(const Structure& structure, const EvaluateOptions& options) {
  Evaluation evaluation(structure, options);
  evaluation.run();
  const PlacedCurves curves = evaluation.curves();
  const Joints joints = find_joints(curves);
  SegmentSet result = std::move(evaluation).segments();
  return with_joints(with_rounding(std::move(result), curves.curves), joints);
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
