#include "read/svg/path.hpp"

#include <array>
#include <utility>

#include "geometry/text_rounding.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kMostArguments = 7;
constexpr const char* kMalformed = "malformed path data";
/// Of a refused piece no more text is kept than this.
constexpr std::size_t kKeptText = 100;

/// The piece from `begin` on, refused for a problem at the scanner's position.
Unusable refused_rest(const Unusable& problem, const Scanner& scanner, std::size_t begin) {
  return {problem.reason + " at character " + std::to_string(scanner.position() + 1),
          std::string(scanner.rest(begin).substr(0, kKeptText))};
}

constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// Number of arguments of a command; none for what is no command.
std::optional<std::size_t> argument_count(char command) {
  switch (upper(command)) {
    case 'M':
    case 'L':
    case 'T':
      return 2;
    case 'H':
    case 'V':
      return 1;
    case 'S':
    case 'Q':
      return 4;
    case 'C':
      return 6;
    case 'A':
      return kMostArguments;
    case 'Z':
      return 0;
    default:
      return std::nullopt;
  }
}

class PathParser {
 public:
  PathParser(std::string_view data, Numbers& numbers, SvgPen pen)
      : scanner_(data), numbers_(numbers), pen_(std::move(pen)) {}

  Pieces parse() && {
    try {
      scanner_.skip_blanks();
      while (!scanner_.at_end()) take_command();
    } catch (const Unusable& problem) {
      pen_.refuse(refused_rest(problem, scanner_, piece_begin_));
    }
    return std::move(pen_).finish();
  }

 private:
  void take_command() {
    piece_begin_ = scanner_.position();
    char command = scanner_.peek();
    const auto count = argument_count(command);
    if (!count) throw Unusable{kMalformed, {}};
    if (!started_ && upper(command) != 'M') {
      throw Unusable{"path data without a moveto at its beginning", {}};
    }
    started_ = true;
    scanner_.advance();
    scanner_.skip_blanks();
    if (*count == 0) {
      pen_.close();
      drawn_ = 'Z';
      return;
    }
    do {
      take_arguments(command, *count);
      draw(command);
      drawn_ = upper(command);
      if (command == 'M') command = 'L';  // further pairs are lines
      if (command == 'm') command = 'l';
    } while (more_arguments());
  }

  void take_arguments(char command, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) scanner_.skip_separator();
      const bool is_flag = upper(command) == 'A' && (i == 3 || i == 4);
      arguments_[i] = is_flag ? take_flag() : numbers_.take(scanner_, kMalformed);
    }
  }

  /// A flag is one character and needs no separator behind it.
  Number take_flag() {
    const char flag = scanner_.peek();
    if (flag != '0' && flag != '1') throw Unusable{kMalformed, {}};
    scanner_.advance();
    return Number::decimal(flag - '0', 0);
  }

  /// Whether another group of arguments follows; moves to it.
  bool more_arguments() {
    const std::size_t behind = scanner_.position();
    const bool comma = scanner_.skip_separator();
    if (comma || scanner_.at_number()) piece_begin_ = comma ? behind : scanner_.position();
    return comma || scanner_.at_number();
  }

  void draw(char command) {
    const bool relative = command != upper(command);
    switch (upper(command)) {
      case 'M':
        pen_.move_to(point(0, relative));
        break;
      case 'L':
        pen_.line_to(point(0, relative));
        break;
      case 'H':
        pen_.line_to({coordinate(pen_.position().x, 0, relative), pen_.position().y});
        break;
      case 'V':
        pen_.line_to({pen_.position().x, coordinate(pen_.position().y, 0, relative)});
        break;
      case 'A':
        draw_arc(command, point(kMostArguments - 2, relative));
        break;
      default:
        draw_bezier(command, relative);
    }
  }

  void draw_bezier(char command, bool relative) {
    const char kind = upper(command);
    std::vector<NumberPoint> controls;
    if (kind == 'S') controls.push_back(reflected(drawn_ == 'C' || drawn_ == 'S'));
    if (kind == 'T') controls.push_back(reflected(drawn_ == 'Q' || drawn_ == 'T'));
    const std::size_t count = *argument_count(command);
    for (std::size_t i = 0; i < count; i += 2) controls.push_back(point(i, relative));
    last_control_ = controls[controls.size() - 2];
    draw_curve(command, controls.back(),
               [&](const std::string& what) { pen_.curve_to(controls, what); });
  }

  void draw_arc(char command, NumberPoint end) {
    const NumberPoint& from = pen_.position();
    if (end == from) return;  // the arc is left out (SVG 1.1, F.6.2)
    // An arc without radius is a line (the same).
    if (sgn(arguments_[0]) == 0 || sgn(arguments_[1]) == 0) {
      pen_.line_to(std::move(end));
      return;
    }
    const SvgArc arc{
        {from.x.rational(), from.y.rational()},
        {end.x.rational(), end.y.rational()},
        arguments_[0].rational(),
        arguments_[1].rational(),
        arguments_[2].rational(),
        sgn(arguments_[3]) != 0,
        sgn(arguments_[4]) != 0,
        text_rounding(from) + text_rounding(end) + text_rounding(arguments_[0], arguments_[1])};
    draw_curve(command, end, [&](const std::string& what) { pen_.arc_to(arc, what); });
  }

  /// Draws, or refuses the piece and goes on from its end.
  template <class Draw>
  void draw_curve(char command, const NumberPoint& end, Draw draw) {
    try {
      draw(std::string("curve ") + upper(command));
    } catch (const Unusable& problem) {
      std::string text(scanner_.since(piece_begin_).substr(0, kKeptText));
      if (text.front() != command) text.insert(0, {command, ' '});
      pen_.refuse({problem.reason, std::move(text)});
      pen_.jump_to(end);
    }
  }

  /// The last control point mirrored at the current point, which it is itself where there was none.
  NumberPoint reflected(bool has_control) const {
    const NumberPoint& p = pen_.position();
    if (!has_control) return p;
    return {p.x + p.x - last_control_.x, p.y + p.y - last_control_.y};
  }

  NumberPoint point(std::size_t i, bool relative) const {
    return {coordinate(pen_.position().x, i, relative),
            coordinate(pen_.position().y, i + 1, relative)};
  }

  Number coordinate(const Number& current, std::size_t i, bool relative) const {
    return relative ? current + arguments_[i] : arguments_[i];
  }

  Scanner scanner_;
  Numbers& numbers_;
  SvgPen pen_;
  bool started_ = false;
  char drawn_ = 'M';  ///< the last command, absolute
  NumberPoint last_control_;
  std::size_t piece_begin_ = 0;  ///< of the command or, for repeated ones, of its arguments
  std::array<Number, kMostArguments> arguments_;
};

}  // namespace

Pieces parse_path(std::string_view data, Numbers& numbers, SvgPen pen) {
  return PathParser(data, numbers, std::move(pen)).parse();
}

Pieces parse_points(std::string_view points, bool closed, Numbers& numbers) {
  constexpr const char* kMalformedList = "malformed list of points";
  Pieces pieces;
  std::optional<NumberPoint> first;
  NumberPoint last;
  Scanner scanner(points);
  scanner.skip_blanks();
  std::size_t begin = 0;  // of the current point, its separator included
  try {
    while (!scanner.at_end()) {
      NumberPoint point;
      point.x = numbers.take(scanner, kMalformedList);
      scanner.skip_separator();
      point.y = numbers.take(scanner, kMalformedList);
      if (first) pieces.segments.push_back(std::move(last), point);
      if (!first) first = point;
      last = std::move(point);
      begin = scanner.position();
      const bool comma = scanner.skip_separator();
      if (comma && scanner.at_end()) throw Unusable{kMalformedList, {}};
    }
  } catch (const Unusable& problem) {
    pieces.refused.push_back(refused_rest(problem, scanner, begin));
    return pieces;
  }
  if (closed && first && !(last == *first)) pieces.segments.push_back(std::move(last), *first);
  if (closed && !pieces.segments.empty()) {
    pieces.rings.push_back({0, static_cast<std::uint32_t>(pieces.segments.size()), RingRole::Line});
  }
  return pieces;
}

}  // namespace plumbline
