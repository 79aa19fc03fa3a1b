// The text of a certificate. There is one way to write each certificate, and nothing else is read:
// lines that end with \n, fields with one space between them, canonical numbers.

#include "certificate.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "refusal.hpp"

namespace plumbline_verify {
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
    word("signature");
    certificate_.signature = field();
    end_of_line();
    vertices();
    edges();
    cycles();
    faces();
    components();
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
    at_end_of_line_ = false;
  }

  /// Up to the next space, or the end of the line.
  std::string_view field() {
    if (at_end_of_line_) refuse("a line ends too early");
    const std::size_t length = line_.find(' ');
    at_end_of_line_ = length == line_.npos;
    const std::string_view result = line_.substr(0, length);
    line_.remove_prefix(at_end_of_line_ ? line_.size() : length + 1);
    if (result.empty()) refuse("a space is where none belongs");
    return result;
  }

  void end_of_line() const {
    if (!at_end_of_line_) refuse("a line goes on where it should end");
  }

  void word(std::string_view expected) {
    if (field() != expected) refuse("\"" + std::string(expected) + "\" is missing");
  }

  Index parsed(std::string_view text, std::size_t bound, const char* what) const {
    const std::optional<Index> value = index_of(text);
    if (!value) refuse("a field is not the number of some " + std::string(what));
    if (*value >= bound) refuse("there is no " + std::string(what) + " " + std::to_string(*value));
    return *value;
  }
  Index index(std::size_t bound, const char* what) { return parsed(field(), bound, what); }
  Index index_or_none(std::string_view text, std::size_t bound, const char* what) const {
    return text == "-" ? kNone : parsed(text, bound, what);
  }

  Number number() {
    std::optional<Number> value = canonical_number(field());
    if (!value) refuse("a coordinate is not an integer or a fraction in lowest terms");
    return *std::move(value);
  }
  Point point() {
    Number x = number();
    return {std::move(x), number()};
  }

  /// The head of a section. Its lines have at least `least_length` bytes, so that no count asks for
  /// more memory than the text justifies.
  std::size_t section(const char* name, std::size_t least_length) {
    next_line();
    word(name);
    const std::optional<Index> count = index_of(field());
    if (!count) refuse("a count is not written as a number");
    end_of_line();
    if (*count > text_.size() / least_length) refuse("there are fewer lines than it says");
    return *count;
  }

  void vertices() {
    const std::size_t count = section("vertices", std::string_view("0 0 point 0\n").size());
    certificate_.vertices.reserve(count);
    certificate_.definers.reserve(count);
    certificate_.vertex_line = line_number_ + 1;
    for (std::size_t v = 0; v < count; ++v) {
      next_line();
      certificate_.vertices.push_back(point());
      certificate_.definers.push_back(definer());
      end_of_line();
    }
  }

  Definer definer() {
    const std::string_view kind = field();
    if (kind == "point") {
      return {Definer::Kind::Point, index(input_.points.size(), "point"), kNone};
    }
    if (kind != "end" && kind != "cross") refuse("a vertex is neither end, cross nor point");
    const Index first = index(input_.segments.size(), "segment");
    if (kind == "end") return {Definer::Kind::End, first, index(2, "end")};
    return {Definer::Kind::Cross, first, index(input_.segments.size(), "segment")};
  }

  void edges() {
    const std::size_t count = section("edges", std::string_view("0 1 0:0\n").size());
    certificate_.edges.reserve(count);
    certificate_.segments.begins.reserve(count + 1);
    certificate_.edge_line = line_number_ + 1;
    for (std::size_t e = 0; e < count; ++e) {
      next_line();
      const Index tail = index(certificate_.vertices.size(), "vertex");
      const Index head = index(certificate_.vertices.size(), "vertex");
      if (tail >= head) refuse("the tail of an edge is not before its head");
      certificate_.edges.push_back({tail, head});
      covering_segments();
    }
  }

  void covering_segments() {
    Lists& segments = certificate_.segments;
    do {
      const std::string_view text = field();
      const std::size_t colon = std::min(text.find(':'), text.size() - 1);
      const Index segment = parsed(text.substr(0, colon), input_.segments.size(), "segment");
      if (segments.values.size() > segments.begins.back() && segments.values.back() >= segment) {
        refuse("the segments that cover an edge are not ascending");
      }
      segments.values.push_back(segment);
      certificate_.pieces.push_back(parsed(text.substr(colon + 1), kNone, "piece"));
    } while (!at_end_of_line_);
    segments.close();
  }

  void cycles() {
    const std::size_t count = section("cycles", std::string_view("+0\n").size());
    certificate_.cycles.begins.reserve(count + 1);
    certificate_.cycles.values.reserve(2 * certificate_.edges.size());
    certificate_.cycle_line = line_number_ + 1;
    for (std::size_t c = 0; c < count; ++c) {
      next_line();
      do {
        const std::string_view text = field();
        if (text[0] != '+' && text[0] != '-') refuse("a halfedge has no sign");
        const Index edge = parsed(text.substr(1), certificate_.edges.size(), "edge");
        certificate_.cycles.values.push_back(text[0] == '+' ? along(edge) : against(edge));
      } while (!at_end_of_line_);
      certificate_.cycles.close();
    }
  }

  void faces() {
    constexpr std::string_view kLeast = "outer - depth 0 parent - holes isolated inside -\n";
    const std::size_t count = section("faces", kLeast.size());
    certificate_.faces.reserve(count);
    certificate_.face_line = line_number_ + 1;
    for (std::size_t f = 0; f < count; ++f) {
      next_line();
      word("outer");
      const Index outer = index_or_none(field(), certificate_.cycles.size(), "cycle");
      word("depth");
      const Index depth = index(count, "depth");
      word("parent");
      certificate_.faces.push_back({outer, depth, index_or_none(field(), count, "face")});
      word("holes");
      list(certificate_.holes, "isolated", certificate_.cycles.size(), "cycle");
      list(certificate_.isolated, "inside", certificate_.vertices.size(), "vertex");
      if (f > 0) certificate_.inside.push_back(point());
      if (f == 0) word("-");
      end_of_line();
    }
  }

  void list(Lists& lists, std::string_view end, std::size_t bound, const char* what) {
    for (std::string_view text = field(); text != end; text = field()) {
      lists.values.push_back(parsed(text, bound, what));
    }
    lists.close();
  }

  void components() {
    const std::size_t count = section("components", std::string_view("0 0\n").size());
    certificate_.components.reserve(count);
    certificate_.component_line = line_number_ + 1;
    for (std::size_t c = 0; c < count; ++c) {
      next_line();
      const Index vertex = index(certificate_.vertices.size(), "vertex");
      certificate_.components.push_back({vertex, index(certificate_.faces.size(), "face")});
      end_of_line();
    }
  }

  std::string_view text_;  ///< after the line
  const Input& input_;
  Certificate certificate_;
  std::string_view line_;  ///< what is left of it
  std::size_t line_number_ = 0;
  bool at_end_of_line_ = true;
};

}  // namespace

Certificate read_certificate(std::string_view text, const Input& input) {
  return Reader(text, input).read();
}

}  // namespace plumbline_verify
