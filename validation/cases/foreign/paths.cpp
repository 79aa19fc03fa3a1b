#include "cases/foreign/paths.hpp"

namespace plumbline::foreign {

Path points(std::string_view text) {
  constexpr std::string_view kBetween = " \t\r\n,";
  std::vector<Rational> numbers;
  for (std::size_t begin = text.find_first_not_of(kBetween); begin != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kBetween, begin), text.size());
    numbers.push_back(parse_decimal(text.substr(begin, end - begin)));
    begin = text.find_first_not_of(kBetween, end);
  }
  if (numbers.size() % 2 != 0) {
    throw Error(ErrorCode::BadInput, "points have two numbers each", {}, std::string(text));
  }
  Path path;
  for (std::size_t i = 0; i < numbers.size(); i += 2) path.push_back({numbers[i], numbers[i + 1]});
  return path;
}

void add_open(SegmentSet& set, const Path& path) {
  const SourceId source = set.add_source({});
  for (std::size_t i = 1; i < path.size(); ++i) set.add({path[i - 1], path[i]}, source);
}

void add_closed(SegmentSet& set, const Path& path) {
  add_open(set, path);
  // Many files repeat the first point.
  if (path.size() > 1 && !(path.front() == path.back())) add_open(set, {path.back(), path.front()});
}

}  // namespace plumbline::foreign
