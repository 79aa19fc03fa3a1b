// A GeoJSON text whose polygons have other rings. The text was read before, so it is JSON; objects
// are followed on a stack of their own.

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "output/patch/changed.hpp"
#include "plumbline/patch.hpp"

namespace plumbline {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// A geometry with coordinates: where it stands, and where readers say that it does.
struct Geometry {
  std::size_t begin = 0, end = 0, place = 0;
  std::string type;
};

/// Finds the geometries of a text, in its order.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::vector<Geometry> run() {
    for (std::size_t i = 0; i < text_.size(); ++i) {
      const char c = text_[i];
      if (c == '{' || c == '[') open(i);
      if ((c == '}' || c == ']') && !levels_.empty()) close(i);
      if (c == ':') is_value_ = true;
      if (c == ',') is_value_ = false;
      if (c == '"') i = string(i);
    }
    return std::move(found_);
  }

 private:
  struct Level {
    bool is_object = false, is_passed_over = false, has_coordinates = false;
    std::size_t begin = 0;
    std::size_t feature = kNone;  ///< where the feature begins that it is within
    std::string key, type;        ///< the last one; of an object its type
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  void open(std::size_t at) {
    Level level;
    level.is_object = text_[at] == '{';
    level.begin = at;
    if (!levels_.empty()) {
      const Level& above = levels_.back();
      level.feature = above.feature;
      level.is_passed_over = above.is_passed_over;
      if (above.is_object) {
        const bool is_of_feature = above.key == "geometry";
        if (is_of_feature) level.feature = above.begin;
        if (!is_of_feature && above.key != "features" && above.key != "geometries") {
          level.is_passed_over = true;
        }
      }
    }
    levels_.push_back(std::move(level));
    is_value_ = false;
  }

  void close(std::size_t at) {
    const Level level = std::move(levels_.back());
    levels_.pop_back();
    is_value_ = false;
    if (level.is_passed_over || !level.has_coordinates) return;
    const std::size_t place = level.feature == kNone ? level.begin : level.feature;
    found_.push_back({level.begin, at + 1, place, level.type});
  }

  /// Where the string ends.
  std::size_t string(std::size_t begin) {
    std::size_t end = begin + 1;
    for (; end < text_.size() && text_[end] != '"'; ++end) {
      if (text_[end] == '\\') ++end;
    }
    if (levels_.empty() || !levels_.back().is_object) return end;
    Level& level = levels_.back();
    const std::string_view content = text_.substr(begin + 1, end - begin - 1);
    if (!is_value_) {
      level.key = content;
      level.has_coordinates = level.has_coordinates || content == "coordinates";
    } else if (level.key == "type") {
      level.type = content;
    }
    return end;
  }

  std::string_view text_;
  std::vector<Level> levels_;
  bool is_value_ = false;  ///< whether a member's name was read, and not its value
  std::vector<Geometry> found_;
};

void append(std::string& text, const std::vector<PointD>& ring) {
  text += '[';
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    const PointD& p = ring[i < ring.size() ? i : 0];
    text += (i > 0 ? ",[" : "[") + shortest_text(p.x) + ',' + shortest_text(p.y) + ']';
  }
  text += ']';
}

std::string geometry_text(const PolygonParts& parts) {
  const bool is_multi = parts.size() > 1;
  std::string text = is_multi ? R"({"type":"MultiPolygon","coordinates":[)"
                              : R"({"type":"Polygon","coordinates":)";
  if (parts.empty()) text += "[]";
  for (std::size_t p = 0; p < parts.size(); ++p) {
    text += p > 0 ? ",[" : "[";
    for (std::size_t r = 0; r < parts[p].size(); ++r) {
      if (r > 0) text += ',';
      append(text, parts[p][r]);
    }
    text += ']';
  }
  return text + (is_multi ? "]}" : "}");
}

/// Line and column from 1, columns in bytes.
using TextPlace = std::pair<std::size_t, std::size_t>;

/// Per place in the text and type of geometry what stands there, in order.
using Places = std::map<std::tuple<TextPlace, std::string>, std::vector<const Geometry*>>;

Places places_of(std::string_view text, const std::vector<Geometry>& geometries) {
  std::vector<std::size_t> lines{0};
  for (std::size_t at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1)) {
    lines.push_back(at + 1);
  }
  Places result;
  for (const Geometry& geometry : geometries) {
    const auto next = std::upper_bound(lines.begin(), lines.end(), geometry.place);
    const auto line = static_cast<std::size_t>(next - lines.begin());
    result[{{line, geometry.place - lines[line - 1] + 1}, geometry.type}].push_back(&geometry);
  }
  return result;
}

}  // namespace

std::optional<Patch> patched_geojson(std::string_view text,
                                     const std::vector<DrawnPolygon>& polygons) {
  const std::string_view mark = text.starts_with(kByteOrderMark) ? kByteOrderMark : "";
  text.remove_prefix(mark.size());
  const std::vector<Geometry> geometries = Scanner(text).run();
  const Places places = places_of(text, geometries);
  std::map<std::tuple<TextPlace, std::string>, std::vector<const DrawnPolygon*>> drawn;
  for (const DrawnPolygon& polygon : polygons) {
    const Source& source = polygon.source;
    drawn[{{source.line, source.column}, source.element}].push_back(&polygon);
  }
  Patch result;
  std::vector<patch::Replacement> replacements;
  for (const auto& [place, there] : drawn) {
    const auto found = places.find(place);
    if (found == places.end() || found->second.size() != there.size()) return std::nullopt;
    for (std::size_t i = 0; i < there.size(); ++i) {
      if (there[i]->is_as_drawn) continue;
      const Geometry& geometry = *found->second[i];
      replacements.push_back({geometry.begin, geometry.end, geometry_text(there[i]->parts)});
      result.replaced.push_back(there[i]->source);
    }
  }
  result.text = std::string(mark) + patch::replaced(text, std::move(replacements));
  return result;
}

}  // namespace plumbline
