// The text formats of Clipper2, CDT and poly2tri.

#include <cmath>
#include <map>
#include <optional>
#include <sstream>

#include "cases/foreign/foreign.hpp"
#include "cases/foreign/paths.hpp"

namespace plumbline::foreign {

namespace {

std::vector<std::string> lines_of(std::string_view text) {
  std::istringstream stream{std::string(text)};
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

template <class Value>
Value named(const std::map<std::string, Value>& values, const std::string& name) {
  const auto found = values.find(name);
  if (found == values.end()) throw Error(ErrorCode::BadInput, "unknown word", {}, name);
  return found->second;
}

/// A case of Clipper2 as it is read. Its words that are not known are refused.
struct Clipping {
  std::string caption, operation, rule;
  Rational area = -1;
  std::vector<Path> subjects, open, clips;

  Case made() const {
    Case one;
    one.name = caption;
    for (const Path& path : subjects) add_closed(one.input, path);
    const std::size_t first_clip = one.input.segments.size();
    for (const Path& path : clips) add_closed(one.input, path);
    using Rule = AreaClaim::Rule;
    using Operation = AreaClaim::Operation;
    const AreaClaim claim{named<Rule>({{"EVENODD", Rule::EvenOdd},
                                       {"NONZERO", Rule::NonZero},
                                       {"POSITIVE", Rule::Positive},
                                       {"NEGATIVE", Rule::Negative}},
                                      rule),
                          named<Operation>({{"INTERSECTION", Operation::Intersection},
                                            {"UNION", Operation::Union},
                                            {"DIFFERENCE", Operation::Difference},
                                            {"XOR", Operation::Xor}},
                                           operation),
                          first_clip,
                          area,
                          std::sqrt(0.5),
                          0};  // to integers
    for (const Path& path : open) add_open(one.input, path);
    // Of open paths the file gives no length; and -1 stands for an area that nobody knows.
    if (open.empty() && area >= 0) one.areas.push_back(claim);
    return one;
  }
};

}  // namespace

std::vector<Case> clipper2(std::string_view text) {
  std::vector<Case> cases;
  std::optional<Clipping> current;
  std::vector<Path>* paths = nullptr;
  const auto finish = [&] {
    if (current) cases.push_back(current->made());
  };
  for (const std::string& line : lines_of(text)) {
    const auto after = [&](std::string_view word) { return line.substr(word.size()); };
    const auto starts = [&](std::string_view word) { return line.starts_with(word); };
    if (starts("CAPTION:")) {
      finish();
      current.emplace().caption = after("CAPTION: ");
      paths = nullptr;
      continue;
    }
    if (line.find_first_not_of(" \t") == std::string::npos) continue;
    if (!current) throw Error(ErrorCode::BadInput, "text before the first CAPTION", {}, line);
    if (starts("CLIPTYPE: ")) {
      current->operation = after("CLIPTYPE: ");
    } else if (starts("FILLRULE: ")) {
      current->rule = after("FILLRULE: ");
    } else if (starts("SOL_AREA: ")) {
      current->area = parse_decimal(after("SOL_AREA: "));
    } else if (line == "SUBJECTS") {
      paths = &current->subjects;
    } else if (line == "SUBJECTS_OPEN") {
      paths = &current->open;
    } else if (line == "CLIPS") {
      paths = &current->clips;
    } else if (!starts("SOL_COUNT: ")) {
      if (paths == nullptr) throw Error(ErrorCode::BadInput, "unknown line", {}, line);
      paths->push_back(points(line));
    }
  }
  finish();
  return cases;
}

std::vector<Case> cdt(std::string_view text) {
  std::istringstream words{std::string(text)};
  const auto next = [&] {
    std::string word;
    if (!(words >> word)) throw Error(ErrorCode::BadInput, "the file ends early");
    return parse_decimal(word);
  };
  const auto index = [&](std::size_t end) {
    const Rational value = next();
    if (value.get_den() != 1 || value < 0 || value >= end) {
      throw Error(ErrorCode::BadInput, "not an index", {}, value.get_str());
    }
    return value.get_num().get_ui();
  };
  constexpr std::size_t kMost = 10'000'000;
  const std::size_t point_count = index(kMost), edge_count = index(kMost);
  Case one;
  const SourceId source = one.input.add_source({});
  std::vector<Point> all;
  for (std::size_t i = 0; i < point_count; ++i) {
    const Rational x = next();
    all.push_back({x, next()});
    one.input.add_point(all.back(), source);
  }
  for (std::size_t i = 0; i < edge_count; ++i) {
    const std::size_t tail = index(point_count);
    one.input.add({all[tail], all[index(point_count)]}, source);
  }
  if (std::string rest; words >> rest) {
    throw Error(ErrorCode::BadInput, "text after the last edge", {}, rest);
  }
  return {one};
}

std::vector<Case> poly2tri(std::string_view text) {
  Case one;
  add_closed(one.input, points(text));
  return {one};
}

}  // namespace plumbline::foreign
