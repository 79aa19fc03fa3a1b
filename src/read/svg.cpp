// SVG -> Structure: one walk over the elements, without recursion.

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <utility>

#include "geometry/rejected.hpp"
#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "read/svg_element.hpp"
#include "read/svg_shape.hpp"
#include "read/svg_transform.hpp"
#include "read/xml.hpp"
#include "structure/name_path.hpp"

namespace plumbline {
namespace {

std::string_view attribute(const pugi::xml_node& element, const char* name) {
  return element.attribute(name).value();
}

/// The property of a style attribute that would change the geometry, or an empty text.
std::string_view geometric_property(std::string_view style, std::string_view element_name) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const auto among = [](std::string_view name, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  while (!style.empty()) {
    const std::string_view declaration = style.substr(0, style.find(';'));
    style.remove_prefix(std::min(declaration.size() + 1, style.size()));
    std::string_view name = declaration.substr(0, declaration.find(':'));
    name.remove_prefix(std::min(name.find_first_not_of(kBlanks), name.size()));
    name = name.substr(0, name.find_last_not_of(kBlanks) + 1);
    if (among(name, {"transform", "transform-origin", "translate", "rotate", "scale", "zoom"}) ||
        (element_name == "rect" && among(name, {"x", "y", "width", "height", "rx", "ry"})) ||
        (element_name == "svg" && among(name, {"x", "y"})) ||
        (element_name == "path" && name == "d")) {
      return name;
    }
  }
  return {};
}

/// Throws: Unusable where something other than the attributes that are read places the element.
void check_placement(const pugi::xml_node& element, std::string_view name) {
  const std::string_view property = geometric_property(attribute(element, "style"), name);
  if (!property.empty()) {
    throw Unusable{"property " + std::string(property) + " of a style is not understood yet",
                   std::string(attribute(element, "style"))};
  }
  if (element.attribute("transform") && element.attribute("transform-origin")) {
    throw Unusable{"transform-origin is not understood yet",
                   std::string(attribute(element, "transform-origin"))};
  }
}

class SvgReader {
 public:
  SvgReader(std::string_view text, const std::string& file_name) : document_(text, file_name) {
    structure_.files = {file_name};
    structure_.root = StructId(0);
  }

  Structure read() && {
    const pugi::xml_node root = document_.root();
    namespaces_.enter(root);
    if (local_name(root) != "svg" || !namespaces_.is_svg(root)) {
      throw Error(ErrorCode::BadInput, "the root element is not svg", document_.place(root),
                  root.name());
    }
    structure_.structs.push_back(named_struct(root));
    frames_.push_back({root, root.first_child(), structure_.root});
    list_what_root_adds(root);
    while (!frames_.empty()) step();
    return std::move(structure_);
  }

 private:
  /// A container whose children are being visited.
  struct Frame {
    pugi::xml_node element;
    pugi::xml_node next;  ///< child
    StructId id;
  };

  /// Coordinates are user units of the root's viewBox. What maps them to a page from outside is
  /// listed.
  void list_what_root_adds(const pugi::xml_node& root) {
    try {
      check_placement(root, "svg");
    } catch (const Unusable& problem) {
      reject(root, problem);
    }
    if (!root.attribute("transform")) return;
    reject(root, {"transform of the root svg maps its user units to the page; it is not applied",
                  std::string(attribute(root, "transform"))});
  }

  void step() {
    Frame& frame = frames_.back();
    if (!frame.next) {
      namespaces_.leave();
      frames_.pop_back();
      if (!frames_.empty()) path_.pop();
      return;
    }
    const pugi::xml_node child = frame.next;
    frame.next = child.next_sibling();
    if (child.type() == pugi::node_element) visit(child);
  }

  void visit(const pugi::xml_node& element) {
    namespaces_.enter(element);
    const std::size_t depth = frames_.size();
    const std::string_view name = local_name(element);
    const SvgKind kind = namespaces_.is_svg(element) ? svg_kind(name) : SvgKind::Undrawn;
    try {
      if (kind == SvgKind::Container) open(element, name);
      if (kind == SvgKind::Shape) add_shape(element, name);
      if (kind == SvgKind::Undrawn) pass_over(element);
      if (kind == SvgKind::Unknown) {
        throw Unusable{"element " + std::string(name) + " is not understood yet", {}};
      }
    } catch (const Unusable& problem) {
      reject(element, problem);
    }
    if (frames_.size() == depth) namespaces_.leave();
  }

  void open(const pugi::xml_node& element, std::string_view name) {
    const auto transform = transform_of(element, name);
    Struct child = named_struct(element);
    if (name == "svg") child.body.emplace_back(viewport_of(element));
    if (transform) {
      child.body.emplace_back(transform->map);
      record(element, *transform);
    }
    path_.push(child.name);
    frames_.push_back({element, element.first_child(), append(std::move(child))});
  }

  void add_shape(const pugi::xml_node& element, std::string_view name) {
    const auto transform = transform_of(element, name);
    Pieces pieces = parse_shape(element, name, numbers_);
    for (const Unusable& problem : pieces.refused) reject(element, problem);
    for (const auto& child : element.children()) {
      if (child.type() == pugi::node_element) pass_over(child);
    }
    if (pieces.segments.empty()) return;
    Model model{source_of(element), std::move(pieces.segments), {}};
    if (!transform) {
      structure_.structs[frames_.back().id].body.emplace_back(std::move(model));
      return;
    }
    record(element, *transform);
    Struct own;  // keeps the map from what follows
    own.body.emplace_back(transform->map);
    own.body.emplace_back(std::move(model));
    append(std::move(own));
  }

  void pass_over(const pugi::xml_node& element) {
    if (holds_drawing(element)) reject(element, {"not drawn directly", {}});
    if (local_name(element) != "style") return;
    const std::string_view sheet = element.child_value();
    for (const char* word : {"transform", "display", "visibility"}) {
      if (sheet.find(word) == sheet.npos) continue;
      reject(element,
             {"style sheets are not interpreted: " + std::string(word), std::string(sheet)});
      return;
    }
  }

  /// The map of the element's transform, if it has one.
  std::optional<SvgTransform> transform_of(const pugi::xml_node& element, std::string_view name) {
    check_placement(element, name);
    if (!element.attribute("transform")) return std::nullopt;
    return parse_transform(attribute(element, "transform"), numbers_);
  }

  /// The map of a nested svg's own coordinates.
  Affine viewport_of(const pugi::xml_node& element) {
    for (const char* name : {"viewBox", "transform"}) {
      if (element.attribute(name)) {
        throw Unusable{std::string(name) + " of a nested svg is not understood yet",
                       std::string(attribute(element, name))};
      }
    }
    const std::string_view width = attribute(element, "width");
    const std::string_view height = attribute(element, "height");
    const auto clips = [](std::string_view extent) { return !extent.empty() && extent != "100%"; };
    if ((clips(width) || clips(height)) && attribute(element, "overflow") != "visible") {
      reject(element, {"clipping by a nested svg is not understood yet",
                       std::string(width) + " " + std::string(height)});
    }
    return translation(length_attribute(element, "x", numbers_).rational(),
                       length_attribute(element, "y", numbers_).rational());
  }

  /// Adds a Struct and a reference to it at the end of the current one.
  StructId append(Struct child) {
    const StructId id(structure_.structs.size());
    structure_.structs.push_back(std::move(child));
    structure_.structs[frames_.back().id].body.emplace_back(id);
    return id;
  }

  static Struct named_struct(const pugi::xml_node& element) {
    const std::string_view label = attribute(element, "inkscape:label");
    Struct result;
    // Growing a body would copy its models: Affine has no noexcept move.
    constexpr std::ptrdiff_t kOwnMaps = 2;
    const auto children = element.children();
    const auto items = std::distance(children.begin(), children.end()) + kOwnMaps;
    result.body.reserve(static_cast<std::size_t>(items));
    result.name = label.empty() ? attribute(element, "id") : label;
    result.category = attribute(element, "inkscape:groupmode");
    return result;
  }

  Source source_of(const pugi::xml_node& element) const {
    const Place place = document_.place(element);
    return {0, place.line, place.column, element.name(), std::string(attribute(element, "id")), {}};
  }

  Source source_with_path(const pugi::xml_node& element) const {
    Source source = source_of(element);
    source.path = path_.text();
    return source;
  }

  void record(const pugi::xml_node& element, const SvgTransform& transform) {
    for (const Replacement& replaced : transform.replaced) {
      structure_.ledger.push_back({source_with_path(element), replaced.what, replaced.bound});
    }
  }

  void reject(const pugi::xml_node& element, const Unusable& problem) {
    structure_.rejected.push_back(
        make_rejected(source_with_path(element), problem.reason, problem.text));
  }

  XmlDocument document_;
  Structure structure_;
  std::vector<Frame> frames_;
  Namespaces namespaces_;
  NamePath path_;
  Numbers numbers_;
};

}  // namespace

Structure read_svg(std::string_view text, const std::string& file_name,
                   const ReadOptions& /*options*/) {
  return SvgReader(text, file_name).read();
}

}  // namespace plumbline
