#include "read/dxf/texts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::dxf {
namespace {

constexpr int kContent = 1;
constexpr int kContentBefore = 3;  ///< of an MTEXT, in pieces
constexpr int kTextPlace = 10;
constexpr int kAlignmentPoint = 11;
constexpr int kAcross = 72;
constexpr int kUpwards = 73;                  ///< of a TEXT
constexpr int kUpwardsOfAttribute = 74;       ///< of an ATTRIB or ATTDEF
constexpr std::int64_t kTextAligned = 3;      ///< of kAcross: from the place to the alignment point
constexpr std::int64_t kTextFitted = 5;       ///< the same, with the height given
constexpr std::int64_t kHiddenAttribute = 1;  ///< of the flags of an ATTRIB or ATTDEF
constexpr std::int64_t kConstantAttribute = 2;

/// Characters of MTEXT's commands that have an argument up to a semicolon.
constexpr std::string_view kWithArgument = "fFhHwWqQtTcCaAp";
constexpr std::string_view kToggles = "LlOoKk";
constexpr std::string_view kBreaks = "PNX~";

/// Walks over a text and leaves out its formatting.
class PlainText {
 public:
  PlainText(std::string_view text, bool is_mtext) : text_(text), is_mtext_(is_mtext) {}

  std::string read() && {
    while (!text_.empty()) {
      if (text_.starts_with("%%")) {
        percent();
      } else if (is_mtext_ && text_.front() == '\\' && text_.size() > 1) {
        command();
      } else if (text_.front() == '^' && text_.size() > 1) {
        add(text_[1] == ' ' ? '^' : ' ');
        text_.remove_prefix(2);
      } else {
        if (!is_mtext_ || (text_.front() != '{' && text_.front() != '}')) add(text_.front());
        text_.remove_prefix(1);
      }
    }
    while (result_.ends_with(' ')) result_.pop_back();
    return std::move(result_);
  }

 private:
  void add(char c) {
    const bool is_blank = c == ' ' || c == '\t';
    if (is_blank && (result_.empty() || result_.back() == ' ')) return;
    result_ += is_blank ? ' ' : c;
  }

  /// Behind "%%".
  void percent() {
    text_.remove_prefix(2);
    if (text_.empty()) return;
    constexpr std::size_t kDigits = 3;
    std::int64_t number = 0;
    if (text_.size() >= kDigits && parse_integer(text_.substr(0, kDigits), number) && number >= 0) {
      if (number >= ' ' && number <= '~') add(static_cast<char>(number));
      text_.remove_prefix(kDigits);
      return;
    }
    switch (text_.front()) {
      case 'c':
      case 'C':
        result_ += "\u00d8";
        break;
      case 'd':
      case 'D':
        result_ += "\u00b0";
        break;
      case 'p':
      case 'P':
        result_ += "\u00b1";
        break;
      case '%':
        result_ += '%';
        break;
      default:  // underlined and the like
        break;
    }
    text_.remove_prefix(1);
  }

  void command() {
    const char name = text_[1];
    text_.remove_prefix(2);
    if (kBreaks.find(name) != kBreaks.npos) {
      add(' ');
    } else if (name == 'S') {
      for (char c : argument()) add(c == '#' ? '/' : c == '^' ? ' ' : c);
    } else if (kWithArgument.find(name) != kWithArgument.npos) {
      argument();
    } else if (kToggles.find(name) == kToggles.npos) {
      add(name);  // \\, \{, \}
    }
  }

  std::string_view argument() {
    const std::size_t end = std::min(text_.find(';'), text_.size());
    const std::string_view result = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    return result;
  }

  std::string_view text_;
  bool is_mtext_;
  std::string result_;
};

Number middle_of(const Number& a, const Number& b) {
  return Number(Rational((a.rational() + b.rational()) / 2));
}

NumberPoint place_of_text(const Entity& entity) {
  const bool is_text = entity.record().type == "TEXT";
  const std::int64_t across = entity.integer(kAcross, 0);
  const std::int64_t upwards = entity.integer(is_text ? kUpwards : kUpwardsOfAttribute, 0);
  NumberPoint place;
  if ((across == 0 && upwards == 0) || !entity.has(kAlignmentPoint)) {
    place = entity.point(kTextPlace);
  } else {
    place = entity.point(kAlignmentPoint);
    if (across == kTextAligned || across == kTextFitted) {
      const NumberPoint from = entity.point(kTextPlace);
      place = {middle_of(from.x, place.x), middle_of(from.y, place.y)};
    }
  }
  if (plane_of(entity) == Plane::Back) place.x = Number::decimal(-1, 0) * place.x;
  return place;
}

/// In UTF-8, an MTEXT's pieces joined.
std::string content_of(const Entity& entity, const Names& names, bool is_mtext) {
  if (!is_mtext) return names.utf8(entity.text(kContent));
  std::string bytes;
  for (const Group& group : entity.record().groups) {
    if (group.code == kContent || group.code == kContentBefore) bytes += group.value;
  }
  return names.utf8(bytes);
}

}  // namespace

bool is_text(std::string_view type) {
  constexpr std::array<std::string_view, 4> kTexts{"TEXT", "MTEXT", "ATTRIB", "ATTDEF"};
  return std::find(kTexts.begin(), kTexts.end(), type) != kTexts.end();
}

std::optional<Model::Text> text_of(const Entity& entity, const Names& names, bool in_block) {
  const std::string_view type = entity.record().type;
  const bool is_mtext = type == "MTEXT", is_attribute = type == "ATTRIB";
  if (is_attribute || type == "ATTDEF") {
    const std::int64_t flags = entity.integer(kFlags, 0);
    if ((flags & kHiddenAttribute) != 0) return {};
    if (!is_attribute && (!in_block || (flags & kConstantAttribute) == 0)) return {};
  }
  std::string text = plain_text(content_of(entity, names, is_mtext), is_mtext);
  if (text.empty()) return {};
  constexpr int kHeight = 40;
  const double height = std::abs(nearest_double(entity.number(kHeight, Number())));
  return Model::Text{std::move(text), is_mtext ? entity.point(kTextPlace) : place_of_text(entity),
                     0, height};
}

std::string plain_text(std::string_view text, bool is_mtext) {
  return PlainText(text, is_mtext).read();
}

}  // namespace plumbline::dxf
