// Features as WKT, a geometry a line; as CSV with WKT; as WKB in hexadecimal digits, a geometry a
// line.

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <limits>

#include "plumbline/features.hpp"
#include "plumbline/number.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

void append(std::string& text, double value) {
  std::array<char, 32> digits{};  // the longest is 24
  text.append(digits.data(),
              std::to_chars(digits.data(), digits.data() + digits.size(), value + 0.0).ptr);
}

void append(std::string& text, const PointD& p) {
  append(text, p.x);
  append(text += ' ', p.y);
}

void append(std::string& text, const std::vector<PointD>& points, bool is_closed) {
  text += '(';
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) text += ", ";
    append(text, points[i]);
  }
  if (is_closed) append(text += ", ", points.front());
  text += ')';
}

void append_wkt(std::string& text, FeatureGeometry geometry, const Feature& feature) {
  if (feature.parts.empty()) {
    text += "POINT EMPTY";
    return;
  }
  switch (geometry) {
    case FeatureGeometry::Point:
      append(text += "POINT ", feature.parts[0], false);
      break;
    case FeatureGeometry::Line:
      append(text += "LINESTRING ", feature.parts[0], false);
      break;
    case FeatureGeometry::Polygon:
      text += "POLYGON (";
      for (std::size_t i = 0; i < feature.parts.size(); ++i) {
        if (i > 0) text += ", ";
        append(text, feature.parts[i], true);
      }
      text += ')';
      break;
  }
}

/// RFC 4180: quotes where a comma, quote or line end is.
void append_field(std::string& text, const std::string& words) {
  const bool is_plain = std::ranges::none_of(
      words, [](char c) { return c == ',' || c == '"' || c == '\r' || c == '\n'; });
  if (is_plain) {
    text += words;
    return;
  }
  text += '"';
  for (const char c : words) {
    if (c == '"') text += '"';
    text += c;
  }
  text += '"';
}

struct AppendField {
  std::string& text;

  void operator()(std::monostate) const {}
  void operator()(double value) const { append(text, value); }
  void operator()(std::int64_t value) const { text += std::to_string(value); }
  void operator()(const std::string& value) const { append_field(text, value); }
};

/// Bytes as hexadecimal digits, little-endian.
class Hex {
 public:
  explicit Hex(std::string& text) : text_(text) {}
  void byte(std::uint8_t value) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    (text_ += kDigits[value >> 4U]) += kDigits[value & 15U];
  }
  template <class Integer>
  void integer(Integer value) {
    for (std::size_t i = 0; i < sizeof value; ++i) {
      byte(static_cast<std::uint8_t>(value >> (8 * i)));
    }
  }
  void point(const PointD& p) {
    integer(std::bit_cast<std::uint64_t>(p.x));
    integer(std::bit_cast<std::uint64_t>(p.y));
  }
  void points(const std::vector<PointD>& points, bool is_closed) {
    integer(static_cast<std::uint32_t>(points.size() + (is_closed ? 1 : 0)));
    for (const PointD& p : points) point(p);
    if (is_closed) point(points.front());
  }

 private:
  std::string& text_;
};

/// An empty point, as GEOS and PostGIS write it.
constexpr PointD kNoPlace{std::numeric_limits<double>::quiet_NaN(),
                          std::numeric_limits<double>::quiet_NaN()};

void append_wkb(std::string& text, FeatureGeometry geometry, const Feature& feature) {
  Hex hex(text);
  hex.byte(1);  // little-endian
  switch (geometry) {
    case FeatureGeometry::Point:
      hex.integer(std::uint32_t{1});
      hex.point(feature.parts.empty() ? kNoPlace : feature.parts[0][0]);
      break;
    case FeatureGeometry::Line:
      hex.integer(std::uint32_t{2});
      hex.points(feature.parts[0], false);
      break;
    case FeatureGeometry::Polygon:
      hex.integer(std::uint32_t{3});
      hex.integer(static_cast<std::uint32_t>(feature.parts.size()));
      for (const auto& ring : feature.parts) hex.points(ring, true);
      break;
  }
}

template <class Append>
std::string lines_of(const Features& features, Append append) {
  std::string text;
  for (const FeatureLayer& layer : features.layers) {
    for (const Feature& feature : layer.features) {
      append(text, layer.geometry, feature);
      text += '\n';
    }
  }
  return text;
}

}  // namespace

std::string to_wkt(const Features& features) { return lines_of(features, append_wkt); }

std::string to_wkb_hex(const Features& features) { return lines_of(features, append_wkb); }

std::string to_csv(const FeatureLayer& layer) {
  std::string text;
  for (const std::string& column : layer.columns) {
    append_field(text, column);
    text += ',';
  }
  text += "wkt\n";
  std::string wkt;
  for (const Feature& feature : layer.features) {
    for (const FeatureValue& value : feature.values) {
      std::visit(AppendField{text}, value);
      text += ',';
    }
    wkt.clear();
    append_wkt(wkt, layer.geometry, feature);
    append_field(text, wkt);
    text += '\n';
  }
  return text;
}

}  // namespace plumbline
