#include "read/dxf/entity_reader.hpp"

#include <algorithm>
#include <utility>

#include "read/dxf/unread.hpp"

namespace plumbline::dxf {
namespace {

constexpr int kHandle = 5;
constexpr int kBlockName = 2;
constexpr int kInvisible = 60;
constexpr int kPaperSpace = 67;
constexpr const char* kHeightLeftOut = "z is left out: drawn as it is seen from above";

/// Follows the vertices of a POLYLINE and the attributes of an INSERT.
constexpr std::string_view kSequenceEnd = "SEQEND";

}  // namespace

EntityReader::EntityReader(Drawing& drawing, const Names& names, const Layers& layers,
                           Numbers& numbers, const ReadOptions& options)
    : drawing_(drawing), names_(names), layers_(layers), numbers_(numbers), pen_(options) {}

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
  const Layers::Layer layer = layers_.of(entity);
  std::string reason;
  bool harmless = true;
  if (space == 0 && entity.integer(kPaperSpace, 0) == 1) {
    reason = kInPaperSpace;
  } else if (type != "POLYLINE" && type != "INSERT" && !is_shape(type)) {
    const Unread left_out = unread(type);
    reason = left_out.reason;
    harmless = left_out.harmless;
  } else if (pen_.visible_only) {
    reason = reason_to_hide(entity, layer, space != 0);
  }
  if (!reason.empty()) {
    in.tally.leave_out(in.placed(source, layer.name), reason, harmless);
    if (type == "POLYLINE") open_ = {source, layer.name, space, std::nullopt};
  } else if (type == "POLYLINE") {
    open_polyline(entity, source, space, layer.name);
  } else if (type == "INSERT") {
    add_insert(entity, source, space, layer);
  } else {
    add_drawn(draw_shape(entity, pen_), source, space, layer.name, has_height(entity));
  }
}

/// Empty for what is to be seen. What a block has on layer "0" is seen as its insert is; so is what
/// other layers of a block show while the layer of the insert is off.
std::string EntityReader::reason_to_hide(const Entity& entity, const Layers::Layer& layer,
                                         bool in_block) const {
  if (entity.integer(kInvisible, 0) == 1) return "hidden: marked as invisible";
  if (in_block && layer.name == kLayerZero) return {};
  if (layer.state == LayerState::Frozen) return "hidden: layer " + layer.name + " is frozen";
  if (layer.state == LayerState::Off && entity.record().type != "INSERT") {
    return "hidden: layer " + layer.name + " is off";
  }
  return {};
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
  if (pen_.visible_only && layer.state == LayerState::Off && !inherits) {
    reference.hides_layer_zero = true;
    in.tally.leave_out(
        at, "hidden: what the block has on layer 0, since layer " + layer.name + " is off", true);
  }
  in.add(layer.name, std::move(reference));
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
