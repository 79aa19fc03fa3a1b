// Well-known binary (OGC SFA 1.2.1, section 8; ISO Z, M and ZM; EWKB's flags), geometry by
// geometry. Coordinates are the dyadic rationals that the doubles are.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "read/wkt.hpp"

namespace plumbline {
namespace {

enum Kind : std::uint32_t {
  kPoint = 1,
  kLineString,
  kPolygon,
  kMultiPoint,
  kMultiLineString,
  kMultiPolygon,
  kCollection,
  kPolyhedralSurface = 15,
  kTin,
  kTriangle,
};
constexpr std::uint32_t kMany = std::numeric_limits<std::uint32_t>::max();

const char* name_of_kind(std::uint32_t kind) {
  constexpr std::array<const char*, 18> kNames = {
      nullptr,      "Point",           "LineString",   "Polygon",
      "MultiPoint", "MultiLineString", "MultiPolygon", "GeometryCollection",
      nullptr,      nullptr,           nullptr,        nullptr,
      nullptr,      nullptr,           nullptr,        "PolyhedralSurface",
      "Tin",        "Triangle"};
  return kind < kNames.size() ? kNames[kind] : nullptr;
}

/// What the parts of a kind are: 0 for a kind without parts, kMany for any.
std::uint32_t part_of(std::uint32_t kind) {
  switch (kind) {
    case kMultiPoint:
      return kPoint;
    case kMultiLineString:
      return kLineString;
    case kMultiPolygon:
    case kPolyhedralSurface:
      return kPolygon;
    case kTin:
      return kTriangle;
    case kCollection:
      return kMany;
    default:
      return 0;
  }
}

/// The bytes that a stream holds, or that its hexadecimal digits stand for.
class Bytes {
 public:
  Bytes(ByteStream& stream, bool is_hex) : stream_(stream), is_hex_(is_hex) {}

  std::uint8_t take() {
    if (!is_hex_) return take_plain();
    const int high = digit();
    return static_cast<std::uint8_t>(16 * high + digit());
  }

  /// An unsigned integer in this order of bytes.
  template <class Integer>
  Integer take(bool is_little_endian) {
    std::array<std::uint8_t, sizeof(Integer)> bytes{};
    for (std::uint8_t& byte : bytes) byte = take();
    if (is_little_endian) std::reverse(bytes.begin(), bytes.end());
    Integer value = 0;
    for (const std::uint8_t byte : bytes) value = static_cast<Integer>(value << 8U | byte);
    return value;
  }

  /// Of hexadecimal digits the place in the text; else unknown.
  Place place() const { return is_hex_ ? stream_.place() : Place{stream_.file(), 0, 0}; }

  [[noreturn]] void fail(const std::string& message) {
    if (is_hex_) stream_.fail("not WKB: " + message);
    throw Error(ErrorCode::BadInput,
                "not WKB: " + message + ", before byte " + std::to_string(stream_.offset() + 1),
                place());
  }

 private:
  std::uint8_t take_plain() {
    if (stream_.at_end()) fail("it ends within a geometry");
    return static_cast<std::uint8_t>(stream_.take());
  }

  int digit() {
    const char c = stream_.peek();
    int value = 0;
    if (c >= '0' && c <= '9') {
      value = c - '0';
    } else if (c >= 'A' && c <= 'F') {
      value = c - 'A' + 10;
    } else if (c >= 'a' && c <= 'f') {
      value = c - 'a' + 10;
    } else {
      fail("expected a hexadecimal digit");
    }
    stream_.take();
    return value;
  }

  ByteStream& stream_;
  bool is_hex_;
};

class WkbReader {
 public:
  WkbReader(Bytes bytes, FeatureTable& table) : bytes_(bytes), table_(table) {}

  void read_geometry() {
    place_ = bytes_.place();
    read_one(kMany);
    while (!open_.empty()) {
      if (open_.back().parts_left == 0) {
        const Open done = open_.back();
        open_.pop_back();
        if (done.kind != kCollection) draw(done.kind);
      } else {
        --open_.back().parts_left;
        read_one(part_of(open_.back().kind));
      }
    }
  }

 private:
  /// A geometry whose parts are geometries.
  struct Open {
    std::uint32_t kind;
    std::uint32_t parts_left;
  };

  struct Header {
    bool is_little_endian = false;
    std::uint32_t kind = 0;
    std::size_t other_coordinates = 0;
  };

  Header take_header() {
    constexpr std::uint32_t kFlagZ = 0x80000000U;
    constexpr std::uint32_t kFlagM = 0x40000000U;
    constexpr std::uint32_t kFlagSrid = 0x20000000U;
    Header header;
    const std::uint8_t order = bytes_.take();
    if (order > 1) bytes_.fail("byte order " + std::to_string(order));
    header.is_little_endian = order == 1;
    const auto code = bytes_.take<std::uint32_t>(header.is_little_endian);
    const std::uint32_t iso = code & ~(kFlagZ | kFlagM | kFlagSrid);
    const std::uint32_t dimensions = iso / 1000;  // 1: Z, 2: M, 3: ZM
    header.kind = iso % 1000;
    if (name_of_kind(header.kind) == nullptr || dimensions > 3) {
      bytes_.fail("geometry of unknown type " + std::to_string(code));
    }
    const bool has_z = (code & kFlagZ) != 0 || dimensions == 1 || dimensions == 3;
    const bool has_m = (code & kFlagM) != 0 || dimensions >= 2;
    header.other_coordinates = (has_z ? 1U : 0U) + (has_m ? 1U : 0U);
    if ((code & kFlagSrid) != 0) {
      const auto srid = bytes_.take<std::uint32_t>(header.is_little_endian);
      table_.note_srid(name_of_kind(header.kind), place_, std::to_string(srid));
    }
    return header;
  }

  /// Reads a geometry of this kind; of one that has geometries as parts, the header only.
  void read_one(std::uint32_t expected) {
    const Header header = take_header();
    if (expected != kMany && header.kind != expected) {
      bytes_.fail(std::string(name_of_kind(header.kind)) + " where a " + name_of_kind(expected) +
                  " was expected");
    }
    const bool is_part = expected != kMany;
    if (!is_part) clear();
    if (header.other_coordinates > 0) has_other_coordinates_ = true;
    if (part_of(header.kind) != 0) {
      open_.push_back({header.kind, bytes_.take<std::uint32_t>(header.is_little_endian)});
      return;
    }
    read_points(header);
    if (!is_part) draw(header.kind);
  }

  void read_points(const Header& header) {
    const auto count = [&] { return bytes_.take<std::uint32_t>(header.is_little_endian); };
    if (header.kind == kPoint) return read_line(header, 1);
    const std::uint32_t lines = header.kind == kLineString ? 1 : count();
    for (std::uint32_t i = 0; i < lines; ++i) read_line(header, count());
    if (header.kind != kLineString) lines_.end_polygon();
  }

  void read_line(const Header& header, std::uint32_t point_count) {
    for (std::uint32_t i = 0; i < point_count; ++i) {
      const double x = take_double(header);
      const double y = take_double(header);
      for (std::size_t k = 0; k < header.other_coordinates; ++k) take_double(header);
      const bool is_empty = header.kind == kPoint && std::isnan(x) && std::isnan(y);
      if (is_empty) continue;  // as POINT EMPTY is written
      if (!std::isfinite(x) || !std::isfinite(y)) {
        is_finite_ = false;
        continue;
      }
      Numbers& numbers = table_.numbers();
      lines_.points.push_back(
          {numbers.read(Number(rational_from(x))), numbers.read(Number(rational_from(y)))});
    }
    lines_.end_line();
  }

  double take_double(const Header& header) {
    return std::bit_cast<double>(bytes_.take<std::uint64_t>(header.is_little_endian));
  }

  void clear() {
    lines_.clear();
    is_finite_ = true;
    has_other_coordinates_ = false;
  }

  void draw(std::uint32_t kind) {
    const char* const name = name_of_kind(kind);
    if (!is_finite_) {
      table_.refuse(name, place_, {"coordinate is not a finite number", {}});
      return;
    }
    if (has_other_coordinates_) table_.note_other_coordinates(name, place_);
    if (kind == kPoint || kind == kMultiPoint) {
      table_.refuse_points(name, place_, lines_.points.size());
    } else if (kind == kLineString || kind == kMultiLineString) {
      table_.add_lines(name, place_, lines_);
    } else {
      table_.add_rings(name, place_, lines_);
    }
  }

  Bytes bytes_;
  FeatureTable& table_;
  Place place_;
  std::vector<Open> open_;
  Polylines lines_;
  bool is_finite_ = true;
  bool has_other_coordinates_ = false;
};

}  // namespace

void read_wkb_geometry(ByteStream& bytes, FeatureTable& table) {
  WkbReader(Bytes(bytes, false), table).read_geometry();
}

void read_hex_wkb_geometry(ByteStream& bytes, FeatureTable& table) {
  WkbReader(Bytes(bytes, true), table).read_geometry();
}

Structure read_wkb(ByteStream& bytes, const FeatureOptions& options) {
  FeatureTable table(bytes.file(), options);
  const bool is_hex = bytes.peek() > '\1';  // bytes begin with their order, 0 or 1
  std::uint64_t number = 0;
  for (;;) {
    if (is_hex) bytes.skip_blanks();
    if (bytes.at_end()) break;
    table.begin_feature();
    if (is_hex) {
      read_hex_wkb_geometry(bytes, table);
      table.name_feature({});
    } else {
      read_wkb_geometry(bytes, table);
      table.name_feature(std::to_string(++number));
    }
  }
  return std::move(table).finish();
}

Structure read_wkb(std::string_view text, const std::string& file_name,
                   const ReadOptions& options) {
  ByteStream bytes(text, {file_name, 1, 1});
  return read_wkb(bytes, feature_options(options));
}

}  // namespace plumbline
