// GeoJSON (RFC 7946), event by event. What an object is may be said after what it holds, so an
// object is judged at its end; features are drawn as they come.

#include <algorithm>
#include <array>
#include <utility>

#include "read/geojson_coordinates.hpp"
#include "read/geojson_crs.hpp"
#include "read/geojson_properties.hpp"
#include "read/streams.hpp"

namespace plumbline {
namespace {

/// What an object stands for by its place in the document.
enum class Slot { Document, Feature, Geometry };

enum Member : unsigned {
  kOther = 0,
  kType = 1,
  kFeatures = 2,
  kGeometry = 4,
  kGeometries = 8,
  kCoordinates = 16,
  kId = 32,
  kProperties = 64,
  kCrs = 128,
};
constexpr unsigned kContent = kFeatures | kGeometry | kGeometries | kCoordinates;

constexpr std::array<std::pair<std::string_view, Member>, 8> kMembers = {
    {{"type", kType},
     {"features", kFeatures},
     {"geometry", kGeometry},
     {"geometries", kGeometries},
     {"coordinates", kCoordinates},
     {"id", kId},
     {"properties", kProperties},
     {"crs", kCrs}}};

Member member_of(std::string_view name) {
  const auto* const known = std::find_if(kMembers.begin(), kMembers.end(),
                                         [name](const auto& pair) { return pair.first == name; });
  return known == kMembers.end() ? kOther : known->second;
}

/// Requires: member != kOther.
std::string name_of(Member member) {
  return std::string(std::find_if(kMembers.begin(), kMembers.end(), [member](const auto& pair) {
                       return pair.second == member;
                     })->first);
}

/// A type of GeoJSON, and the member that holds its content. A `depth` other than 0 is that of the
/// positions in its coordinates.
struct GeoJsonType {
  const char* name;
  Member content;
  std::size_t depth = 0;
};

constexpr std::array<GeoJsonType, 9> kGeoJsonTypes = {{{"Point", kCoordinates, 1},
                                                       {"MultiPoint", kCoordinates, 2},
                                                       {"LineString", kCoordinates, 2},
                                                       {"MultiLineString", kCoordinates, 3},
                                                       {"Polygon", kCoordinates, 3},
                                                       {"MultiPolygon", kCoordinates, 4},
                                                       {"GeometryCollection", kGeometries},
                                                       {"Feature", kGeometry},
                                                       {"FeatureCollection", kFeatures}}};

bool fits(const GeoJsonType& type, Slot slot) {
  if (slot == Slot::Document) return true;
  if (slot == Slot::Feature) return type.content == kGeometry;
  return type.content == kCoordinates || type.content == kGeometries;
}

/// An open object, or an open array of objects.
struct Level {
  bool is_array = false;
  Slot slot = Slot::Document;  ///< of the object, or of those in the array
  unsigned members = 0;        ///< seen so far
  const GeoJsonType* type = nullptr;
  Place place;
};

class GeoJsonReader {
 public:
  GeoJsonReader(ByteStream& bytes, const FeatureOptions& options)
      : bytes_(bytes), table_(bytes.file(), options), properties_(options.layer_property) {}

  Structure read() && {
    parse_json(bytes_, *this);
    return std::move(table_).finish();
  }

  static bool done() { return false; }

  void key(std::string_view name) {
    if (ignored_ > 0) return;
    if (crs_.is_open()) return crs_.key(name);
    if (in_properties_) return properties_.key(name);
    Level& level = levels_.back();
    member_ = member_of(name);
    if (is_misplaced(member_, level.slot)) member_ = kOther;
    if (member_ == kOther) return;
    if ((level.members & member_) != 0) fail("member " + std::string(name) + " is there twice");
    level.members |= member_;
    const unsigned content = level.members & kContent;
    if ((content & (content - 1)) != 0) {
      fail("an object with coordinates, geometries, geometry or features has two of these");
    }
  }

  void scalar(JsonScalar kind, std::string_view text) {
    if (ignored_ > 0) return;
    if (crs_.is_open()) return crs_.scalar(kind, text);
    if (in_coordinates_) return coordinates_.scalar(kind, text, numbers_);
    if (in_properties_) return properties_.scalar(kind, text);
    if (levels_.empty()) fail("not a GeoJSON object");
    const Level& level = levels_.back();
    if (level.is_array) return refuse_element(level.slot, text);
    if (member_ == kType) return set_type(kind, text);
    if (member_ == kId && has_text(kind)) feature_id_ = text;
    if (member_ == kGeometry) refuse_geometry(kind, text);
    if (member_ == kCoordinates) {
      coordinates_.refuse("coordinates are not an array", std::string(text.substr(0, 100)));
    }
    if (member_ == kFeatures || member_ == kGeometries) fail("not an array");
  }

  void open_object() {
    if (ignored_ > 0 || in_properties_) return ignore();
    if (crs_.is_open() || (!levels_.empty() && !in_coordinates_ && member_ == kCrs)) {
      return crs_.open_object();
    }
    if (in_coordinates_) {
      coordinates_.refuse("coordinates hold an object", {});
      return ignore();
    }
    if (levels_.empty()) return open(Slot::Document);
    const Level& level = levels_.back();
    if (level.is_array) return open(level.slot);
    if (member_ == kGeometry) {
      feature_place_ = level.place;
      return open(Slot::Geometry);
    }
    if (member_ == kFeatures || member_ == kGeometries) fail("not an array");
    if (member_ == kCoordinates) coordinates_.refuse("coordinates are not an array", {});
    if (member_ == kProperties) {
      in_properties_ = true;
      return;
    }
    ignore();
  }

  void close_object() {
    if (ignored_ > 0) {
      --ignored_;
    } else if (crs_.is_open()) {
      crs_.close_object();
    } else if (in_properties_) {
      in_properties_ = false;
    } else {
      close();
    }
  }

  void open_array() {
    if (ignored_ > 0 || in_properties_ || crs_.is_open()) return ignore();
    if (in_coordinates_) return coordinates_.open_array();
    if (levels_.empty()) fail("not a GeoJSON object");
    const Level level = levels_.back();
    if (level.is_array) {
      refuse_element(level.slot, "an array");
      return ignore();
    }
    if (member_ == kCoordinates) {
      coordinates_.open_array();
      in_coordinates_ = true;
    } else if (member_ == kFeatures) {
      levels_.push_back({true, Slot::Feature, 0, nullptr, {}});
    } else if (member_ == kGeometries) {
      levels_.push_back({true, Slot::Geometry, 0, nullptr, {}});
    } else {
      if (member_ == kGeometry) refuse_geometry(JsonScalar::String, "an array");
      ignore();
    }
  }

  void close_array() {
    if (ignored_ > 0) {
      --ignored_;
    } else if (in_coordinates_) {
      in_coordinates_ = !coordinates_.close_array();
    } else {
      levels_.pop_back();
    }
  }

 private:
  static bool has_text(JsonScalar kind) {
    return kind == JsonScalar::String || kind == JsonScalar::Number;
  }

  static bool is_misplaced(Member member, Slot slot) {
    if (member == kFeatures || member == kCrs) return slot != Slot::Document;
    if (member == kGeometry || member == kId || member == kProperties) {
      return slot == Slot::Geometry;
    }
    return false;
  }

  [[noreturn]] void fail(const std::string& message) { bytes_.fail("not GeoJSON: " + message); }

  void ignore() { ++ignored_; }

  void set_type(JsonScalar kind, std::string_view text) {
    Level& level = levels_.back();
    const auto* const known =
        std::find_if(kGeoJsonTypes.begin(), kGeoJsonTypes.end(),
                     [text](const GeoJsonType& type) { return type.name == text; });
    if (kind == JsonScalar::String && known != kGeoJsonTypes.end()) {
      level.type = known;
    } else if (level.slot == Slot::Document) {
      throw Error(ErrorCode::BadInput, "not GeoJSON: unknown type", bytes_.place(),
                  printable(text));
    } else {
      unknown_type_ = text.substr(0, 100);
    }
  }

  void open(Slot slot) {
    if (slot != Slot::Geometry) {
      table_.begin_feature();
      feature_id_.clear();
      properties_.clear();
    }
    coordinates_.clear();
    unknown_type_.clear();
    levels_.push_back({false, slot, 0, nullptr, bytes_.place()});
    member_ = kOther;
  }

  void close() {
    const Level level = std::move(levels_.back());
    levels_.pop_back();
    member_ = kOther;
    if (level.slot == Slot::Document) {
      check_document(level);
      if (!crs_.name().empty()) table_.note_crs("crs", level.place, crs_.name());
    }
    try {
      draw(level);
    } catch (const Unusable& problem) {
      table_.refuse(level.type == nullptr ? "object" : level.type->name, level.place, problem,
                    id());
    }
    if (level.slot == Slot::Geometry) return;
    if (level.type == nullptr || level.type->content != kFeatures) {
      table_.name_feature(id(), properties_.label());
      table_.place_feature(properties_.layer());
    }
    feature_place_ = {};
  }

  void check_document(const Level& level) {
    if (level.type == nullptr) fail("no member type");
    if ((level.members & level.type->content) == 0) {
      fail(std::string(level.type->name) + " without member " + name_of(level.type->content));
    }
  }

  const std::string& id() const { return feature_id_.empty() ? properties_.id() : feature_id_; }

  /// Draws the geometry of the object that has been read. What it contains has been drawn.
  void draw(const Level& level) {
    if (level.type == nullptr || !fits(*level.type, level.slot)) return refuse_type(level);
    if ((level.members & level.type->content) == 0) {
      throw Unusable{"no member " + name_of(level.type->content), {}};
    }
    if (level.type->content != kCoordinates) return;
    coordinates_.check(level.type->depth);
    draw_coordinates(*level.type, feature_place_.line == 0 ? level.place : feature_place_);
  }

  void refuse_type(const Level& level) {
    const std::string type = level.type == nullptr ? unknown_type_ : level.type->name;
    const std::string problem = std::string("no ") +
                                (level.slot == Slot::Geometry ? "geometry" : "Feature") +
                                " by its type";
    if ((level.members & (kGeometry | kGeometries)) == 0) throw Unusable{problem, type};
    table_.remark(level.type == nullptr ? "object" : level.type->name, level.place,
                  problem + "; what it contains is drawn", type);
  }

  void draw_coordinates(const GeoJsonType& type, const Place& place) {
    const std::string_view name = type.name;
    if (coordinates_.has_other_coordinates()) table_.note_other_coordinates(name, place);
    if (name.ends_with("Point")) {
      table_.add_points(name, place, coordinates_.lines());
    } else if (name.ends_with("Polygon")) {
      table_.add_rings(name, place, coordinates_.lines());
    } else {
      table_.add_lines(name, place, coordinates_.lines());
    }
  }

  void refuse_element(Slot slot, std::string_view text) {
    table_.refuse(slot == Slot::Feature ? "Feature" : "geometry", bytes_.place(),
                  {"not an object", std::string(text.substr(0, 100))});
  }

  void refuse_geometry(JsonScalar kind, std::string_view text) {
    const bool is_null = kind == JsonScalar::Null;
    table_.refuse("Feature", levels_.back().place,
                  {is_null ? "has no geometry" : "its geometry is not an object",
                   std::string(text.substr(0, 100)), is_null});
  }

  ByteStream& bytes_;
  FeatureTable table_;
  Numbers& numbers_ = table_.numbers();
  std::vector<Level> levels_;
  std::size_t ignored_ = 0;  ///< depth of open objects and arrays that are passed over
  Member member_ = kOther;   ///< whose value comes next
  GeoJsonCoordinates coordinates_;
  GeoJsonCrs crs_;
  bool in_coordinates_ = false;
  bool in_properties_ = false;
  GeoJsonProperties properties_;
  Place feature_place_;  ///< line 0 outside of a Feature
  std::string feature_id_, unknown_type_;
};

}  // namespace

Structure read_geojson(ByteStream& bytes, const FeatureOptions& options) {
  return GeoJsonReader(bytes, options).read();
}

Structure read_geojson(std::string_view text, const std::string& file_name,
                       const ReadOptions& options) {
  ByteStream bytes(text, {file_name, 1, 1});
  return read_geojson(bytes, feature_options(options));
}

}  // namespace plumbline
