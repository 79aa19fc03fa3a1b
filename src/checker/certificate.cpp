// The text of a certificate. There is one way to write each certificate, and nothing else is read:
// lines that end with \n, fields with one space between them, canonical numbers.

#include "certificate.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "refusal.hpp"

namespace plumbline_checker {
namespace {

/// An integer of at most nine digits and no leading zero, so that it is below kNone.
std::optional<Index> index_of(std::string_view text) {
  constexpr std::size_t kMaxIndexDigits = 9;
  if (text.empty() || text.size() > kMaxIndexDigits || (text[0] == '0' && text.size() > 1)) {
    return std::nullopt;
  }
  Index value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    value = 10 * value + static_cast<Index>(c - '0');
  }
  return value;
}

class Reader {
 public:
  Reader(std::string_view text, const Input& input) : text_(text), input_(input) {}

  Certificate read() {
    next_line();
    if (line_ != "plumbline certificate 1") refuse("it does not start with its title");
    next_line();
    if (field() != "signature") refuse("\"signature\" is missing");
    certificate_.signature = line_;
    vertices();
    edges();
    lines("cycles", certificate_.cycle_line, certificate_.cycles);
    lines("faces", certificate_.face_line, certificate_.faces);
    inside();
    lines("components", certificate_.component_line, certificate_.components);
    next_line();
    if (line_ != "end") refuse("it does not have the line \"end\" here");
    if (!text_.empty()) refuse("something follows its end");
    return std::move(certificate_);
  }

 private:
  [[noreturn]] void refuse(std::string reason) const {
    throw Refusal{std::move(reason), line_number_, ""};
  }

  void next_line() {
    ++line_number_;
    const std::size_t length = text_.find('\n');
    if (length == text_.npos) refuse("it ends before its end");
    line_ = text_.substr(0, length);
    text_.remove_prefix(length + 1);
  }

  /// Takes a field and the space after it from the line.
  std::string_view field() {
    const std::size_t length = line_.find(' ');
    const std::string_view result = line_.substr(0, length);
    line_.remove_prefix(std::min(result.size() + 1, line_.size()));
    // The last field of a line has no space after it.
    if (result.empty() || (line_.empty() && length != line_.npos)) {
      refuse("a line ends too early, or has a space where none belongs");
    }
    return result;
  }

  Index index(std::string_view text, std::size_t bound, const char* what) const {
    const std::optional<Index> value = index_of(text);
    if (!value) refuse("a field is not the number of some " + std::string(what));
    if (*value >= bound) refuse("there is no " + std::string(what) + " " + std::to_string(*value));
    return *value;
  }

  Number number() {
    const std::string_view text = field();
    // So that no number takes longer than those of the input account for.
    if (text.size() > input_.longest_coordinate) {
      refuse("a coordinate is longer than any that this input can have");
    }
    std::optional<Number> value = canonical_number(text);
    if (!value) refuse("a coordinate is not an integer or a fraction in lowest terms");
    return *std::move(value);
  }
  Point point() {
    Number x = number();
    return {std::move(x), number()};
  }

  /// The head of a section. A line has two bytes at least, so that no count asks for more memory
  /// than the text justifies.
  std::size_t section(const std::string& name, std::size_t& first_line) {
    next_line();
    if (field() != name) refuse("\"" + name + "\" is missing");
    const std::optional<Index> count = index_of(line_);
    if (!count) refuse("a count is not written as a number");
    if (*count > text_.size() / 2) refuse("there are fewer lines than it says");
    first_line = line_number_ + 1;
    return *count;
  }

  void vertices() {
    std::vector<Point>& vertices = certificate_.vertices;
    for (std::size_t count = section("vertices", certificate_.vertex_line); count > 0; --count) {
      next_line();
      vertices.push_back(point());
      certificate_.reasons.push_back(line_);
      const auto v = static_cast<Index>(vertices.size() - 1);
      const int order = v > 0 ? compare(vertices[v - 1], vertices[v]) : -1;
      if (order == 0) certificate_.refuse_vertex(v, "is where the one before it is");
      if (order > 0) certificate_.refuse_vertex(v, "should come before the one before it");
    }
  }

  void edges() {
    std::vector<Edge>& edges = certificate_.edges;
    for (std::size_t count = section("edges", certificate_.edge_line); count > 0; --count) {
      next_line();
      const Index tail = index(field(), certificate_.vertices.size(), "vertex");
      const Index head = index(field(), certificate_.vertices.size(), "vertex");
      if (tail >= head) refuse("the tail of an edge is not before its head");
      if (!edges.empty() &&
          std::pair(edges.back().tail, edges.back().head) >= std::pair(tail, head)) {
        refuse("an edge has the ends of the one before it, or should come before that");
      }
      edges.push_back({tail, head});
      do {
        covering_segment();
      } while (!line_.empty());
      certificate_.segments.close();
    }
  }

  void covering_segment() {
    Lists& segments = certificate_.segments;
    const std::string_view text = field();
    const std::size_t colon = std::min(text.find(':'), text.size() - 1);
    const Index segment = index(text.substr(0, colon), input_.segments.size(), "segment");
    if (segments.values.size() > segments.begins.back() && segments.values.back() >= segment) {
      refuse("the segments that cover an edge are not ascending");
    }
    segments.values.push_back(segment);
    certificate_.pieces.push_back(index(text.substr(colon + 1), kNone, "piece"));
  }

  void lines(const std::string& name, std::size_t& first_line,
             std::vector<std::string_view>& lines) {
    for (std::size_t count = section(name, first_line); count > 0; --count) {
      next_line();
      lines.push_back(line_);
    }
  }

  /// Parts the lines of faces in front of " inside".
  void inside() {
    constexpr std::string_view kInside = " inside ";
    for (std::string_view& face : certificate_.faces) {
      const std::size_t end = std::min(face.rfind(kInside), face.size());
      certificate_.inside.push_back(face.substr(std::min(end + kInside.size(), face.size())));
      face = face.substr(0, end);
    }
  }

  std::string_view text_;  ///< after the line
  const Input& input_;
  Certificate certificate_;
  std::string_view line_;  ///< what is left of it
  std::size_t line_number_ = 0;
};

}  // namespace

Certificate read_certificate(std::string_view text, const Input& input) {
  return Reader(text, input).read();
}

void Certificate::refuse_vertex(Index v, const std::string& problem) const {
  throw Refusal{"vertex " + std::to_string(v) + " " + problem, vertex_line + v,
                text_of(vertices[v])};
}

void Certificate::refuse_edge(Index e, const std::string& problem, const Point& place) const {
  throw Refusal{"edge " + std::to_string(e) + " " + problem, edge_line + e, text_of(place)};
}

void require(const std::string& item, std::string_view said, std::string_view right,
             std::size_t line, const Point* place) {
  if (said == right) return;
  // What is around the first difference.
  const auto [in_said, in_right] =
      std::mismatch(said.begin(), said.end(), right.begin(), right.end());
  constexpr std::ptrdiff_t kBefore = 40;
  constexpr std::size_t kShown = 80;
  const auto begin =
      static_cast<std::size_t>(std::max(in_said - said.begin() - kBefore, std::ptrdiff_t{0}));
  const auto shown = [&](std::string_view text) {
    std::string part(text.substr(begin, kShown));
    for (char& c : part) c = c >= ' ' && c <= '~' ? c : '?';
    return (begin > 0 ? "\"... " : "\"") + part + (begin + kShown < text.size() ? " ...\"" : "\"");
  };
  throw Refusal{item + " is " + shown(said) + ", not " + shown(right), line,
                place != nullptr ? text_of(*place) : ""};
}

}  // namespace plumbline_checker
