#include "read/json_kind.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "read/json_events.hpp"

namespace plumbline {
namespace {

constexpr std::array<std::pair<std::string_view, JsonKind>, 12> kTelling = {
    {{"features", JsonKind::GeoJson},
     {"geometry", JsonKind::GeoJson},
     {"geometries", JsonKind::GeoJson},
     {"coordinates", JsonKind::GeoJson},
     {"V", JsonKind::Lar},
     {"EV", JsonKind::Lar},
     {"FV", JsonKind::Lar},
     {"lines", JsonKind::Lar},
     {"root", JsonKind::Struct},
     {"defs", JsonKind::Struct},
     {"signature", JsonKind::Arrangement},
     {"outputs", JsonKind::LarTrace}}};

/// Formats that are not read.
constexpr std::array<std::pair<std::string_view, const char*>, 5> kForeign = {
    {{"arcs", "TopoJSON"},
     {"stories", "floorspace.js"},
     {"layers", "react-planner"},
     {"subjPaths", "iOverlay"},
     {"fillRule", "iOverlay"}}};

template <class Names>
auto known_name(const Names& names, std::string_view name) {
  return std::find_if(names.begin(), names.end(),
                      [name](const auto& known) { return known.first == name; });
}

/// A target of parse_json that looks at the members of the outermost value.
class KindFinder {
 public:
  explicit KindFinder(ByteStream& bytes) : bytes_(bytes) {}

  bool done() const { return kind_.has_value(); }
  std::optional<JsonKind> kind() const { return kind_; }

  void key(std::string_view name) {
    if (depth_ != 1 || kind_) return;
    is_type_ = name == "type";
    const auto* const telling = known_name(kTelling, name);
    if (telling != kTelling.end()) kind_ = telling->second;
    const auto* const foreign = known_name(kForeign, name);
    if (foreign == kForeign.end() || kind_) return;
    throw Error(ErrorCode::BadInput,
                std::string("JSON of a format that is not read: ") + foreign->second,
                bytes_.place(), printable(name));
  }

  void scalar(JsonScalar, std::string_view text) {
    if (depth_ != 1 || !is_type_ || text == "Topology") return;
    kind_ = JsonKind::GeoJson;
  }

  void open_object() { ++depth_; }
  void close_object() { --depth_; }
  void open_array() {
    if (depth_++ == 0) kind_ = JsonKind::Lar;
  }
  void close_array() { --depth_; }

 private:
  ByteStream& bytes_;
  std::size_t depth_ = 0;
  bool is_type_ = false;
  std::optional<JsonKind> kind_;
};

}  // namespace

JsonKind json_kind(ByteStream& bytes) {
  KindFinder teller(bytes);
  parse_json(bytes, teller);
  if (teller.kind()) return *teller.kind();
  throw Error(
      ErrorCode::BadInput,
      "JSON of no known format: neither GeoJSON (type) nor LAR (V, EV, FV, lines; root, defs)",
      {bytes.file(), 1, 1});
}

}  // namespace plumbline
