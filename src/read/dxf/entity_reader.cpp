#include "read/dxf/entity_reader.hpp"

#include <algorithm>
#include <utility>

#include "read/dxf/hatch.hpp"
#include "read/dxf/texts.hpp"
#include "read/dxf/unread.hpp"

namespace plumbline::dxf {
namespace {

constexpr int kHandle = 5;
constexpr int kBlockName = 2;
constexpr int kInvisible = 60;
constexpr int kPaperSpace = 67;
constexpr std::string_view kMultiline = "MLINE";
constexpr const char* kHeightLeftOut = "z is left out: drawn as it is seen from above";

/// Follows the vertices of a POLYLINE and the attributes of an INSERT.
constexpr std::string_view kSequenceEnd = "SEQEND";

}  // namespace

EntityReader::EntityReader(Drawing& drawing, const Names& names, Layers& layers,
                           MlineStyles& styles, Numbers& numbers, const ReadOptions& options,
                           const Rational& least_tolerance)
    : drawing_(drawing),
      names_(names),
      layers_(layers),
      styles_(styles),
      numbers_(numbers),
      pen_(options, least_tolerance) {}

Source EntityReader::source(const Record& record) const {
  const auto handle = std::find_if(record.groups.begin(), record.groups.end(),
                                   [](const Group& group) { return group.code == kHandle; });
  return {0,
          record.line,
          0,
          names_.utf8(record.type),
          handle == record.groups.end() ? std::string() : names_.utf8(handle->value),
          {}};
}

void EntityReader::visit(const Record& record, std::size_t space) {
  const Entity entity(record, numbers_);
  const Source from = source(record);
  if (record.type == "VERTEX" && open_) return add_vertex(entity, from);
  finish();
  if (record.type == kSequenceEnd) return;
  try {
    add(entity, from, space);
  } catch (const Unusable& problem) {
    Space& in = drawing_.spaces[space];
    in.tally.refuse(in.placed(from, layers_.of(entity).name), problem);
  }
}

void EntityReader::add(const Entity& entity, const Source& source, std::size_t space) {
  Space& in = drawing_.spaces[space];
  const std::string_view type = entity.record().type;
  const Layers::Layer& layer = layers_.of(entity);
  Unread left_out{type, nullptr, true};
  if (space == 0 && entity.integer(kPaperSpace, 0) == 1) {
    left_out.reason = kInPaperSpace;
  } else if (hides(entity, source, in, layer)) {
    if (type == "POLYLINE") open_ = {source, layer.name, space, std::nullopt};
    if (type == "INSERT") hides_attributes_ = true;
    return;
  } else if (type == "ATTRIB" && hides_attributes_) {
    return;  // with its INSERT
  } else if (type != "POLYLINE" && type != "INSERT" && !is_drawn(type) && !is_text(type)) {
    left_out = unread(type);
  }
  if (left_out.reason != nullptr) {
    in.tally.leave_out(in.placed(source, layer.name), left_out.reason, left_out.harmless);
    if (type == "POLYLINE") open_ = {source, layer.name, space, std::nullopt};
  } else if (type == "POLYLINE") {
    open_polyline(entity, source, space, layer.name);
  } else if (type == "INSERT") {
    hides_attributes_ = false;
    add_insert(entity, source, space, layer);
  } else if (is_text(type)) {
    add_text(entity, source, in, layer.name);
  } else {
    add_drawn(drawn(entity), source, space, layer.name, has_height(entity));
  }
}

bool EntityReader::is_drawn(std::string_view type) const {
  return is_shape(type) || type == kMultiline || (type == kHatch && pen_.draws_hatches);
}

DrawnEntity EntityReader::drawn(const Entity& entity) {
  constexpr int kStyle = 2;
  const std::string_view type = entity.record().type;
  if (type == kMultiline) return draw_mline(entity, styles_.flags(entity.text(kStyle)), pen_);
  return type == kHatch ? draw_hatch(entity, pen_) : draw_shape(entity, pen_);
}

/// What a block has on layer "0" is seen as its insert is; so is what other layers of a block show
/// while the layer of the insert is not shown; it is gone where that is frozen.
bool EntityReader::hides(const Entity& entity, const Source& source, Space& in,
                         const Layers::Layer& layer) {
  if (!pen_.draws_hidden && entity.integer(kInvisible, 0) == 1) {
    in.tally.leave_out(in.placed(source, layer.name), "hidden: marked as invisible", true);
    return true;
  }
  const bool in_block = &in != &drawing_.spaces.front();
  if (layer.state == LayerState::Shown || (in_block && layer.name == kLayerZero)) return false;
  if (layer.state != LayerState::Frozen && entity.record().type == "INSERT") return false;
  // One item for each layer.
  Source from = in.placed(source, layer.name);
  from.element = "LAYER";
  from.id.clear();
  in.tally.leave_out(from, "what is on layer " + layer.name + ", which is " + to_text(layer.state),
                     true);
  return true;
}

void EntityReader::open_polyline(const Entity& entity, const Source& source, std::size_t space,
                                 const std::string& layer) {
  open_ = {source, layer, space, std::nullopt};
  open_->polyline = polyline_of(entity);
  open_->has_height = has_height(entity);
}

void EntityReader::add_vertex(const Entity& entity, const Source& source) {
  if (!open_->polyline) return;  // listed with the POLYLINE
  try {
    open_->polyline->vertices.push_back(polyline_vertex_of(entity));
    open_->has_height = open_->has_height || has_height(entity);
  } catch (const Unusable& problem) {
    Space& in = drawing_.spaces[open_->space];
    in.tally.refuse(in.placed(open_->source, open_->layer),
                    {"its VERTEX in line " + std::to_string(source.line) + ": " + problem.reason,
                     problem.text});
    open_->polyline.reset();
  }
}

void EntityReader::finish() {
  if (!open_) return;
  const Open done = *std::exchange(open_, std::nullopt);
  if (!done.polyline) return;
  try {
    add_drawn(draw_polyline(*done.polyline, pen_), done.source, done.space, done.layer,
              done.has_height);
  } catch (const Unusable& problem) {
    Space& in = drawing_.spaces[done.space];
    in.tally.refuse(in.placed(done.source, done.layer), problem);
  }
}

void EntityReader::add_insert(const Entity& entity, const Source& source, std::size_t space,
                              const Layers::Layer& layer) {
  Space& in = drawing_.spaces[space];
  const Source at = in.placed(source, layer.name);
  const std::string_view name = entity.text(kBlockName);
  Reference reference{source, names_.utf8(name), insert_of(entity, names_.key(name), at), false};
  if (has_height(entity)) in.tally.remark(at, kHeightLeftOut);
  const bool inherits = space != 0 && layer.name == kLayerZero;
  if (layer.state != LayerState::Shown && !inherits) {
    reference.hides_layer_zero = true;
    in.tally.leave_out(
        at,
        "what the block has on layer 0, since layer " + layer.name + " is " + to_text(layer.state),
        true);
  }
  in.add(layer.name, std::move(reference));
}

void EntityReader::add_text(const Entity& entity, const Source& source, Space& in,
                            const std::string& layer) {
  try {
    auto text = text_of(entity, names_, &in != &drawing_.spaces.front());
    if (!text) return;
    Model model{source, {}};
    model.labels.push_back(*std::move(text));
    in.add(layer, std::move(model));
  } catch (const Unusable& problem) {
    in.tally.refuse(in.placed(source, layer), {problem.reason, problem.text, true});  // no lines
  }
}

void EntityReader::add_drawn(DrawnEntity drawn, const Source& source, std::size_t space,
                             const std::string& layer, bool has_height) {
  Space& in = drawing_.spaces[space];
  const auto at = [&] { return in.placed(source, layer); };
  for (const Substitution& item : drawn.replaced) in.tally.replace(at(), item);
  for (const Unusable& problem : drawn.refused) {
    if (problem.text.empty()) {
      in.tally.leave_out(at(), problem.reason, problem.harmless);
    } else {
      in.tally.refuse(at(), problem);
    }
  }
  if (has_height) in.tally.remark(at(), kHeightLeftOut);
  if (drawn.segments.empty()) return;
  if (!pen_.join_curves) drawn.curves.clear();
  in.add(layer, Model{source,
                      std::move(drawn.segments),
                      {},
                      {},
                      std::move(drawn.curves),
                      std::move(drawn.rings)});
}

}  // namespace plumbline::dxf
