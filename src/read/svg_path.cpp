#include "read/svg_path.hpp"

#include <array>
#include <utility>

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
  PathParser(std::string_view data, Numbers& numbers) : scanner_(data), numbers_(numbers) {}

  Pieces parse() && {
    try {
      scanner_.skip_blanks();
      while (!scanner_.at_end()) take_command();
    } catch (const Unusable& problem) {
      pieces_.refused.push_back(refused_rest(problem, scanner_, piece_begin_));
    }
    return std::move(pieces_);
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
      close();
      return;
    }
    do {
      take_arguments(command, *count);
      draw(command);
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
    const std::size_t count = *argument_count(command);
    NumberPoint end = current_;
    if (upper(command) == 'V') {
      move(end.y, arguments_[0], relative);
    } else if (upper(command) == 'H') {
      move(end.x, arguments_[0], relative);
    } else {
      move(end.x, arguments_[count - 2], relative);
      move(end.y, arguments_[count - 1], relative);
    }
    switch (upper(command)) {
      case 'M':
        start_ = current_ = std::move(end);
        break;
      case 'L':
      case 'H':
      case 'V':
        line_to(std::move(end));
        break;
      case 'A':
        // An arc without radius is a line (SVG 1.1, F.6.2).
        if (sgn(arguments_[0]) == 0 || sgn(arguments_[1]) == 0) {
          line_to(std::move(end));
          break;
        }
        [[fallthrough]];
      default:
        refuse_curve(command);
        current_ = std::move(end);
    }
  }

  static void move(Number& coordinate, const Number& argument, bool relative) {
    coordinate = relative ? coordinate + argument : argument;
  }

  void line_to(NumberPoint end) {
    pieces_.segments.push_back(std::move(current_), end);
    current_ = std::move(end);
  }

  void close() {
    if (!(current_ == start_)) line_to(start_);
  }

  void refuse_curve(char command) {
    std::string text(scanner_.since(piece_begin_));
    if (text.front() != command) text.insert(0, {command, ' '});
    pieces_.refused.push_back(
        {"command " + std::string(1, command) + " is not understood yet", std::move(text)});
  }

  Scanner scanner_;
  Numbers& numbers_;
  Pieces pieces_;
  bool started_ = false;
  std::size_t piece_begin_ = 0;  ///< of the command or, for repeated ones, of its arguments
  std::array<Number, kMostArguments> arguments_;
  NumberPoint current_;
  NumberPoint start_;  ///< of the subpath
};

}  // namespace

Pieces parse_path(std::string_view data, Numbers& numbers) {
  return PathParser(data, numbers).parse();
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
  return pieces;
}

}  // namespace plumbline
