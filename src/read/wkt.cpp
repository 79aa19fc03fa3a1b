// Well-known text (OGC SFA 1.2.1, section 7; ISO Z, M and ZM; EWKT's SRID), geometry by geometry.

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "read/attribute.hpp"
#include "read/feature_table.hpp"
#include "read/wkt.hpp"

namespace plumbline {
namespace {

/// A type, its name in other formats, how deep its positions stand in parentheses.
struct WktType {
  std::string_view word;
  std::string_view element;
  std::size_t depth;
};

constexpr std::array<WktType, 11> kWktTypes = {{{"POINT", "Point", 1},
                                                {"LINESTRING", "LineString", 1},
                                                {"LINEARRING", "LinearRing", 1},
                                                {"POLYGON", "Polygon", 2},
                                                {"TRIANGLE", "Triangle", 2},
                                                {"MULTIPOINT", "MultiPoint", 1},
                                                {"MULTILINESTRING", "MultiLineString", 2},
                                                {"MULTIPOLYGON", "MultiPolygon", 3},
                                                {"POLYHEDRALSURFACE", "PolyhedralSurface", 3},
                                                {"TIN", "Tin", 3},
                                                {"GEOMETRYCOLLECTION", "GeometryCollection", 0}}};

/// Types of the standard that hold arcs.
constexpr std::array<std::string_view, 5> kCurved = {"CIRCULARSTRING", "COMPOUNDCURVE",
                                                     "CURVEPOLYGON", "MULTICURVE", "MULTISURFACE"};

bool has_rings(const WktType& type) {
  return type.depth > 1 ? type.word != "MULTILINESTRING" : type.word == "LINEARRING";
}

bool has_points(const WktType& type) { return type.word.ends_with("POINT"); }

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }

/// Of numbers and of the words nan and inf.
bool continues_number(char c) {
  return (c >= '0' && c <= '9') || is_letter(c) || c == '.' || c == '+' || c == '-' || c == '/';
}

class WktReader {
 public:
  WktReader(ByteStream& bytes, FeatureTable& table, Numbers& numbers)
      : bytes_(bytes), table_(table), numbers_(numbers) {}

  void read_geometry() {
    place_ = bytes_.place();
    std::size_t collections = 0;  // that are open
    do {
      bytes_.skip_blanks();
      const std::optional<WktType> type = take_type();
      if (type && type->depth == 0) {
        if (take_empty()) {
          close_collections(collections);
          continue;
        }
        expect('(');
        ++collections;
        continue;
      }
      if (type) {
        read_body(*type);
        draw(*type);
      }
      close_collections(collections);
    } while (collections > 0);
  }

 private:
  /// Behind a geometry: closes the collections that end here. Moves to the next geometry else.
  void close_collections(std::size_t& collections) {
    while (collections > 0) {
      bytes_.skip_blanks();
      if (bytes_.peek() == ',') {
        bytes_.take();
        return;
      }
      expect(')');
      --collections;
    }
  }

  void expect(char c) {
    bytes_.skip_blanks();
    if (bytes_.peek() != c) bytes_.fail(std::string("not WKT: expected '") + c + "'");
    bytes_.take();
  }

  /// The word that starts here in capitals; empty where none does.
  std::string take_word() {
    constexpr std::size_t kLongestWord = 20;
    std::string word;
    while (is_letter(bytes_.peek())) {
      const char c = bytes_.take();
      word += static_cast<char>(c >= 'a' ? c - 'a' + 'A' : c);
      if (word.size() > kLongestWord) bytes_.fail("not WKT: unknown word " + word + "...");
    }
    return word;
  }

  void skip_srid() {
    expect('=');
    bytes_.skip_blanks();
    constexpr std::size_t kLongest = 10;
    const Place here = bytes_.place();
    std::string digits;
    while (bytes_.peek() >= '0' && bytes_.peek() <= '9') {
      const char c = bytes_.take();
      if (digits.size() < kLongest) digits += c;
    }
    expect(';');
    bytes_.skip_blanks();
    table_.note_srid("SRID", here, digits);
  }

  /// The type that starts here with its Z and M; none for a curved one, which is passed over.
  std::optional<WktType> take_type() {
    const Place here = bytes_.place();
    std::string word = take_word();
    if (word == "SRID") {
      skip_srid();
      word = take_word();
    }
    const auto fits = [&word](std::string_view name) {
      return word.starts_with(name) && among_dimensions(std::string_view(word).substr(name.size()));
    };
    const auto* const known = std::find_if(kWktTypes.begin(), kWktTypes.end(),
                                           [&](const WktType& type) { return fits(type.word); });
    const bool is_curved = std::any_of(kCurved.begin(), kCurved.end(), fits);
    if (known == kWktTypes.end() && !is_curved) {
      throw Error(ErrorCode::BadInput, "not WKT: unknown geometry", here,
                  word.empty() ? printable(bytes_.ahead().substr(0, 1)) : word);
    }
    take_dimensions();
    if (!is_curved) return *known;
    table_.refuse(word, here, {"curved geometry is not understood yet", {}});
    pass_over();
    return std::nullopt;
  }

  static bool among_dimensions(std::string_view text) {
    return text.empty() || text == "Z" || text == "M" || text == "ZM";
  }

  /// The words Z, M, ZM where they stand by themselves. Leaves EMPTY in `word_`.
  void take_dimensions() {
    bytes_.skip_blanks();
    word_ = take_word();
    if (!word_.empty() && among_dimensions(word_)) {
      bytes_.skip_blanks();
      word_ = take_word();
    }
    if (!word_.empty() && word_ != "EMPTY") bytes_.fail("not WKT: unknown word " + word_);
  }

  bool take_empty() { return !std::exchange(word_, {}).empty(); }

  /// Whatever stands in parentheses.
  void pass_over() {
    if (take_empty()) return;
    expect('(');
    for (std::size_t depth = 1; depth > 0;) {
      if (bytes_.at_end()) bytes_.fail("not WKT: a parenthesis is not closed");
      const char c = bytes_.take();
      if (c == '(') ++depth;
      if (c == ')') --depth;
    }
  }

  void read_body(const WktType& type) {
    lines_.clear();
    problem_ = {};
    most_numbers_ = 0;
    if (take_empty()) return;
    expect('(');
    bool is_item_next = true;
    for (std::size_t depth = 1; depth > 0;) {
      bytes_.skip_blanks();
      const char c = bytes_.peek();
      if (!is_item_next) {
        if (c != ',' && c != ')') bytes_.fail("not WKT: expected ',' or ')'");
        bytes_.take();
        if (c == ')') close_list(type, depth--);
        is_item_next = c == ',';
      } else if (c == '(') {
        bytes_.take();
        if (++depth > type.depth + (type.word == "MULTIPOINT" ? 1 : 0)) {
          bytes_.fail("not WKT: too many parentheses");
        }
      } else {
        read_item(type, depth);
        is_item_next = false;
      }
    }
  }

  void close_list(const WktType& type, std::size_t depth) {
    if (depth == type.depth) lines_.end_line();
    if (depth + 1 == type.depth) lines_.end_polygon();
  }

  void read_item(const WktType& type, std::size_t depth) {
    const bool is_word = bytes_.peek() == 'E' || bytes_.peek() == 'e';  // no number begins so
    if (is_word && (depth < type.depth || has_points(type))) {
      if (take_word() != "EMPTY") bytes_.fail("not WKT: expected a list or EMPTY");
      return;
    }
    if (depth < type.depth) bytes_.fail("not WKT: expected '('");
    read_position();
  }

  void read_position() {
    constexpr std::size_t kMostNumbers = 4;
    NumberPoint point;
    std::size_t count = 0;
    for (; continues_number(bytes_.peek()); ++count) {
      const std::string_view text = take_number();
      try {
        if (count == 0) point.x = numbers_.parse(text);
        if (count == 1) point.y = numbers_.parse(text);
      } catch (const Unusable& problem) {
        if (problem_.reason.empty()) problem_ = problem;
      }
      bytes_.skip_blanks();
    }
    if (count < 2 || count > kMostNumbers) {
      bytes_.fail("not WKT: position of " + std::to_string(count) + " numbers, before this");
    }
    most_numbers_ = std::max(most_numbers_, count);
    lines_.points.push_back(std::move(point));
  }

  /// Valid until the next call.
  std::string_view take_number() {
    constexpr std::size_t kLongest = 2 * kMaxDecimalDigits + 100;  // those beyond are refused
    const std::string_view ahead = bytes_.ahead();
    const auto end = std::find_if_not(ahead.begin(), ahead.end(), continues_number);
    if (end != ahead.end()) {  // it is in memory as a whole
      bytes_.advance(static_cast<std::size_t>(end - ahead.begin()));
      return {ahead.begin(), end};
    }
    number_.clear();
    while (continues_number(bytes_.peek())) {
      const char c = bytes_.take();
      if (number_.size() < kLongest) number_ += c;
    }
    return number_;
  }

  void draw(const WktType& type) {
    if (!problem_.reason.empty()) {
      table_.refuse(type.element, place_, problem_);
      return;
    }
    if (most_numbers_ > 2) table_.note_other_coordinates(type.element, place_);
    if (has_points(type)) {
      table_.refuse_points(type.element, place_, lines_.points.size());
    } else if (has_rings(type)) {
      table_.add_rings(type.element, place_, lines_);
    } else {
      table_.add_lines(type.element, place_, lines_);
    }
  }

  ByteStream& bytes_;
  FeatureTable& table_;
  Numbers& numbers_;
  Place place_;  ///< of the outermost geometry
  std::string word_;
  std::string number_;
  Polylines lines_;
  Unusable problem_;  ///< the first of the geometry; its reason is empty where there is none
  std::size_t most_numbers_ = 0;
};

/// Moves to the next geometry, past blanks, semicolons and lines that begin with #.
void skip_to_geometry(ByteStream& bytes) {
  for (bytes.skip_blanks(); bytes.peek() == ';' || bytes.peek() == '#'; bytes.skip_blanks()) {
    const bool is_comment = bytes.take() == '#';
    while (is_comment && !bytes.at_end() && bytes.take() != '\n') {
    }
  }
}

}  // namespace

void read_wkt_geometry(ByteStream& bytes, FeatureTable& table, Numbers& numbers) {
  WktReader(bytes, table, numbers).read_geometry();
}

Structure read_wkt(ByteStream& bytes, const FeatureOptions& options) {
  FeatureTable table(bytes.file(), options);
  WktReader reader(bytes, table, table.numbers());
  for (skip_to_geometry(bytes); !bytes.at_end(); skip_to_geometry(bytes)) {
    table.begin_feature();
    reader.read_geometry();
    table.name_feature({});
  }
  return std::move(table).finish();
}

Structure read_wkt(std::string_view text, const std::string& file_name,
                   const ReadOptions& options) {
  ByteStream bytes(text, {file_name, 1, 1});
  return read_wkt(bytes, feature_options(options));
}

}  // namespace plumbline
