// SVG -> Structure: one walk over the elements, through references too, without recursion.

#include <iterator>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "geometry/rejected.hpp"
#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "read/drawing_tolerance.hpp"
#include "read/svg/element.hpp"
#include "read/svg/index.hpp"
#include "read/svg/names.hpp"
#include "read/svg/selection.hpp"
#include "read/svg/shape.hpp"
#include "read/svg/style.hpp"
#include "read/svg/transform.hpp"
#include "read/svg/unapplied.hpp"
#include "read/svg/undrawn.hpp"
#include "read/svg/viewport.hpp"
#include "read/xml.hpp"
#include "structure/name_path.hpp"

namespace plumbline {
namespace {

/// What may be read again for references, in bytes of its text: percentages make an element anew
/// for each viewport that it is used in.
constexpr std::size_t kMaxTextReadAgain = std::size_t{1} << 24U;

std::string_view attribute(const pugi::xml_node& element, const char* name) {
  return element.attribute(name).value();
}

class SvgReader {
 public:
  SvgReader(std::string_view text, const std::string& file_name, const ReadOptions& options,
            const Rational& least_tolerance)
      : document_(text, file_name),
        index_(document_.root()),
        numbers_(options.shortest_decimals),
        flattener_(options, least_tolerance),
        options_(options),
        selection_(options) {
    structure_.files = {file_name};
    structure_.angle_bound = options.angle_bound;
    structure_.root = StructId(0);
  }

  Reading read() && {
    const pugi::xml_node root = document_.root();
    if (local_name(root) != "svg" || !index_.is_svg(root)) {
      throw Error(ErrorCode::BadInput, "the root element is not svg", document_.place(root),
                  root.name());
    }
    structure_.structs.push_back(named_struct(root));
    list_layers();
    if (!options_.hidden && !is_displayed(root)) {
      reject(root, {"hidden", "display: none", true});
      return {std::move(structure_), flattener_.has_curves()};
    }
    Frame frame = frame_of(root, structure_.root);
    frame.visible = own_visibility(root).value_or(true);
    frame.viewport = viewport_of_root(root);
    structure_.unit = root_unit(root, numbers_);
    frame.wanted = selection_.wants_all() || selection_.wants(root);
    push(std::move(frame));
    for (const SvgUnapplied& item : unapplied(root, index_)) {
      remark(item.element, item.what, item.text);
    }
    while (!frames_.empty()) step();
    for (const auto& [element, path, problem] : selection_.left_out(structure_.files[0])) {
      reject(element, path, problem);
    }
    for (const auto& [element, path] : undrawn_.unused()) {
      reject(element, path, {"not drawn directly", {}, true});
    }
    numbers_.add_to(structure_.ledger);
    return {std::move(structure_), flattener_.has_curves()};
  }

 private:
  /// A container whose children are being visited, or a `use` whose target is.
  struct Frame {
    pugi::xml_node element;
    pugi::xml_node next;     ///< child
    pugi::xml_node target;   ///< what a `use` refers to, until it is visited
    SvgExtents use_extents;  ///< width and height that a `use` gives its target
    StructId id;
    SvgViewport viewport;
    bool visible = true;
    bool wanted = true;  ///< whether its shapes are read, by their layers
    bool again = false;  ///< whether this was read before
  };

  static Frame frame_of(const pugi::xml_node& element, StructId id) {
    Frame frame;
    frame.element = element;
    frame.next = element.first_child();
    frame.id = id;
    return frame;
  }

  void push(Frame frame) {
    open_.insert(frame.element.internal_object());
    frames_.push_back(std::move(frame));
  }

  void pop() {
    open_.erase(frames_.back().element.internal_object());
    frames_.pop_back();
    if (!frames_.empty()) path_.pop();
  }

  SvgViewport viewport_of_root(const pugi::xml_node& root) {
    try {
      return root_viewport(root, numbers_);
    } catch (const Unusable& problem) {
      remark(root, problem.reason, problem.text);
      return {};
    }
  }

  void step() {
    Frame& frame = frames_.back();
    if (const pugi::xml_node target = std::exchange(frame.target, {})) {
      visit(target, frame.use_extents);
      return;
    }
    if (!frame.next) {
      pop();
      return;
    }
    const pugi::xml_node child = frame.next;
    frame.next = child.next_sibling();
    if (child.type() == pugi::node_element) visit(child, {});
  }

  void visit(const pugi::xml_node& element, const SvgExtents& use_extents) {
    const bool is_target = local_name(frames_.back().element) == "use";
    const std::string_view name = local_name(element);
    SvgKind kind = index_.is_svg(element) ? svg_kind(name) : SvgKind::Undrawn;
    if (is_target && kind == SvgKind::Undrawn && name == "symbol") kind = SvgKind::Container;
    if (kind == SvgKind::Text && holds_shape(element)) kind = SvgKind::Unknown;
    try {
      if (kind == SvgKind::Undrawn && is_target) {
        throw Unusable{"use of an element that is not drawn", {}, !holds_shape(element)};
      }
      if (kind == SvgKind::Undrawn) return pass_over(element);
      const bool visible = own_visibility(element).value_or(frames_.back().visible);
      const bool wanted = frames_.back().wanted || selection_.wants(element);
      if (selection_.leaves_out(element, kind, visible, wanted, path_.text())) return;
      if (kind == SvgKind::Unknown) {
        throw Unusable{
            "element " + std::string(name) + " is not understood yet", {}, !holds_shape(element)};
      }
      if (is_target) undrawn_.used(element);
      StructId* const known = index_.is_referenced(element)
                                  ? &struct_of_same_use(element, use_extents, visible, wanted)
                                  : nullptr;
      if (known != nullptr && known->valid()) {
        structure_.structs[frames_.back().id].body.emplace_back(*known);
        return;
      }
      const bool again = frames_.back().again ||
                         (known != nullptr && !read_.insert(element.internal_object()).second);
      if (again) count_reading_again(element);
      if (kind == SvgKind::Container) {
        const StructId id = open(element, name, use_extents, visible);
        frames_.back().wanted = wanted;
        frames_.back().again = again;
        if (known != nullptr) *known = id;
      } else if (const auto id = add_model(element, name, known != nullptr)) {
        if (known != nullptr) *known = *id;
      }
    } catch (const Unusable& problem) {
      reject(element, problem);
    }
  }

  void list_layers() {
    for (const pugi::xml_node& layer : index_.layers()) {
      const bool is_hidden = !is_displayed(layer) || !own_visibility(layer).value_or(true);
      structure_.layers.push_back({named_struct(layer).name, {}, is_hidden});
    }
  }

  /// The Struct made of a referenced element before, where everything was the same that it depends
  /// on; else an invalid one, to be set.
  StructId& struct_of_same_use(const pugi::xml_node& element, const SvgExtents& use_extents,
                               bool visible, bool wanted) {
    const auto text_of_extent = [](const std::optional<Rational>& extent) {
      return extent ? extent->get_str() : std::string();
    };
    const SvgViewport& around = frames_.back().viewport;
    std::string key = std::to_string(element.offset_debug()) + ' ' + text_of_extent(around.width) +
                      ' ' + text_of_extent(around.height) + ' ' + (visible ? "1 " : "0 ") +
                      (wanted ? "1 " : "0 ");
    key.append(use_extents.width).append(" ").append(use_extents.height);
    return made_[std::move(key)];
  }

  /// Starts on the children of a container, or on the target of a `use`.
  StructId open(const pugi::xml_node& element, std::string_view name, const SvgExtents& use_extents,
                bool visible) {
    const auto transform = transform_of(element, name);
    Frame frame = frame_of(element, {});
    frame.visible = visible;
    frame.viewport = frames_.back().viewport;
    Struct child = named_struct(element, transform ? transform->maps.size() : 0);
    if (transform) append_maps(element, *transform, child);
    if (name == "use") {
      frame.next = {};
      frame.target = target_of(element);
      frame.use_extents = {attribute(element, "width"), attribute(element, "height")};
      const auto& [width, height] = frame.viewport;
      child.body.emplace_back(
          translation(length_attribute(element, "x", width, numbers_).rational(),
                      length_attribute(element, "y", height, numbers_).rational()));
    }
    if (name == "svg" || name == "symbol") {
      SvgPlacement placement = place_viewport(element, use_extents, frame.viewport, numbers_);
      if (placement.clips) remark(element, "clipping by a viewport is not applied", {});
      child.body.emplace_back(std::move(placement.map));
      frame.viewport = std::move(placement.inside);
    }
    if (transform) record(element, transform->replaced);
    path_.push(child.name);
    frame.id = append(std::move(child));
    const StructId id = frame.id;
    push(std::move(frame));
    return id;
  }

  /// Throws: Unusable; Error for a cycle.
  pugi::xml_node target_of(const pugi::xml_node& use) const {
    const std::string reference(svg_reference(use));
    if (reference.empty()) throw Unusable{"use without a reference", {}};
    if (reference.front() != '#') throw Unusable{"use of another file", reference};
    const pugi::xml_node target = index_.find(reference.substr(1));
    if (!target) throw Unusable{"use of an element that does not exist", reference};
    if (open_.count(target.internal_object()) != 0 || target == use) {
      const std::string path = path_.text().empty() ? "" : path_.text() + "/";
      throw Error(ErrorCode::BadInput, "cycle of references", document_.place(use),
                  path + reference);
    }
    return target;
  }

  /// Adds a shape or a text, in a Struct of its own where it needs one.
  std::optional<StructId> add_model(const pugi::xml_node& element, std::string_view name,
                                    bool is_referenced) {
    const auto transform = transform_of(element, name);
    Model model{source_of(element), {}};
    std::vector<Replacement> curves;
    if (name == "text") {
      if (auto text = text_of(element, frames_.back().viewport, numbers_)) {
        model.labels.push_back(*std::move(text));
      }
    } else {
      curves = add_pieces(element, name, model);
    }
    const bool is_empty = model.segments.empty() && model.labels.empty();
    if (transform && !is_empty) record(element, transform->replaced);
    record(element, curves);
    if (!transform && !is_referenced) {
      if (!is_empty) structure_.structs[frames_.back().id].body.emplace_back(std::move(model));
      return std::nullopt;
    }
    Struct own;  // keeps the map from what follows
    own.body.reserve(1 + (transform ? transform->maps.size() : 0));
    if (transform) append_maps(element, *transform, own);
    if (!is_empty) own.body.emplace_back(std::move(model));
    return append(std::move(own));
  }

  /// What a shape draws, and its name; what replaced its curves.
  std::vector<Replacement> add_pieces(const pugi::xml_node& element, std::string_view name,
                                      Model& model) {
    Pieces pieces = parse_shape(element, name, frames_.back().viewport,
                                {numbers_, flattener_, options_.angle_bound});
    for (const Unusable& problem : pieces.refused) reject(element, problem);
    for (const auto& child : element.children()) {
      if (child.type() == pugi::node_element) pass_over(child);
    }
    model.segments = std::move(pieces.segments);
    if (options_.join_curves) model.curves = std::move(pieces.curves);
    model.rings = std::move(pieces.rings);
    std::string label = model.segments.empty() ? std::string() : shape_name(element);
    if (!label.empty()) model.labels.push_back({std::move(label), std::nullopt});
    return std::move(pieces.replaced);
  }

  void pass_over(const pugi::xml_node& element) {
    if (holds_drawing(element)) undrawn_.add(element, path_.text());
  }

  std::optional<SvgTransform> transform_of(const pugi::xml_node& element, std::string_view name) {
    check_placement(element, name);
    const pugi::xml_attribute map = map_attribute(element);
    if (!map) return {};
    return parse_transform(map.value(), numbers_, options_.angle_bound);
  }

  void append_maps(const pugi::xml_node& element, const SvgTransform& transform, Struct& to) {
    for (Struct::Item map : transform.maps) {
      if (auto* turn = std::get_if<Turn>(&map)) {
        turn->source = source_with_path(element, path_.text());
      }
      to.body.push_back(std::move(map));
    }
  }

  /// Adds a Struct and a reference to it at the end of the current one.
  StructId append(Struct child) {
    const StructId id(structure_.structs.size());
    structure_.structs.push_back(std::move(child));
    structure_.structs[frames_.back().id].body.emplace_back(id);
    return id;
  }

  static Struct named_struct(const pugi::xml_node& element, std::size_t maps = 0) {
    const std::string_view label = attribute(element, "inkscape:label");
    Struct result;
    // Growing a body would copy its models: Affine has no noexcept move.
    constexpr std::ptrdiff_t kOwnMaps = 2;
    const auto children = element.children();
    const auto items = std::distance(children.begin(), children.end()) + kOwnMaps;
    result.body.reserve(static_cast<std::size_t>(items) + maps);
    result.name = label.empty() ? attribute(element, "id") : label;
    result.category = attribute(element, "inkscape:groupmode");
    return result;
  }

  void count_reading_again(const pugi::xml_node& element) {
    constexpr std::size_t kElement = 64;
    text_read_again_ +=
        kElement + attribute(element, "d").size() + attribute(element, "points").size();
    if (text_read_again_ <= kMaxTextReadAgain) return;
    throw Error(ErrorCode::Limit, "too much is used in too many viewports",
                document_.place(element));
  }

  Source source_of(const pugi::xml_node& element) const {
    const auto [line, column] = document_.position(element);
    return {0, line, column, element.name(), std::string(attribute(element, "id")), {}};
  }

  Source source_with_path(const pugi::xml_node& element, const std::string& path) const {
    Source source = source_of(element);
    source.path = path;
    return source;
  }

  void record(const pugi::xml_node& element, const std::vector<Replacement>& replacements) {
    for (const Replacement& replaced : replacements) {
      structure_.ledger.push_back(
          {source_with_path(element, path_.text()), replaced.what, replaced.bound});
    }
  }

  void reject(const pugi::xml_node& element, const Unusable& problem) {
    reject(element, path_.text(), problem);
  }
  void reject(const pugi::xml_node& element, const std::string& path, const Unusable& problem) {
    structure_.rejected.push_back(make_rejected(source_with_path(element, path), problem.reason,
                                                problem.text, problem.harmless));
  }
  void remark(const pugi::xml_node& element, const std::string& what, const std::string& text) {
    structure_.remarks.push_back(make_remark(source_with_path(element, path_.text()), what, text));
  }

  XmlDocument document_;
  SvgIndex index_;
  Numbers numbers_;
  Flattener flattener_;
  const ReadOptions& options_;
  SvgSelection selection_;
  Structure structure_;
  std::vector<Frame> frames_;
  std::unordered_set<const void*> open_;  ///< the frames' elements
  NamePath path_;
  std::unordered_map<std::string, StructId> made_;
  SvgUndrawn undrawn_;
  std::unordered_set<const void*> read_;  ///< referenced elements
  std::size_t text_read_again_ = 0;
};

}  // namespace

Structure read_svg(std::string_view text, const std::string& file_name,
                   const ReadOptions& options) {
  return read_within_tolerance(options, [&](const ReadOptions& how, const Rational& least) {
    return SvgReader(text, file_name, how, least).read();
  });
}

}  // namespace plumbline
