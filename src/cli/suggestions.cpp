#include "cli/suggestions.hpp"

#include <algorithm>
#include <numeric>

#include "cli/formats.hpp"

namespace plumbline::cli {
namespace {

/// Letters to add, take away, replace or swap with their neighbours until one is the other.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> rows(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) rows[i][0] = i;
  std::iota(rows[0].begin(), rows[0].end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = rows[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      rows[i][j] = std::min({rows[i - 1][j] + 1, rows[i][j - 1] + 1, replaced});
      const bool is_swap = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (is_swap) rows[i][j] = std::min(rows[i][j], rows[i - 2][j - 2] + 1);
    }
  }
  return rows[a.size()][b.size()];
}

}  // namespace

std::string probable(std::string_view word, const std::vector<std::string>& names) {
  constexpr std::size_t kLongest = 60;  // no name is longer
  if (word.empty() || word.size() > kLongest) return "";
  const auto is_begun = [&](std::string_view name) { return name.starts_with(word); };
  const std::size_t dashes = std::min(word.find_first_not_of('-'), word.size());
  if (word.size() > dashes + 1 && std::ranges::count_if(names, is_begun) == 1) {
    return *std::ranges::find_if(names, is_begun);
  }
  std::string best;
  std::size_t least = std::max<std::size_t>((word.size() - dashes) / 3, 1) + 1;
  for (const std::string& name : names) {
    const std::size_t found = distance(word, name);
    if (found >= least || found + dashes + 1 >= name.size()) continue;
    least = found;
    best = name;
  }
  return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names) {
  const std::string meant = probable(word, names);
  return meant.empty() ? "" : "; did you mean " + meant + "?";
}

CLI::Validator one_of(std::vector<std::string> names) {
  const std::string described = CLI::detail::join(names, "|");
  const auto choose = [names = std::move(names)](std::string& value) -> std::string {
    const std::string lower = CLI::detail::to_lower(value);
    if (std::ranges::find(names, lower) != names.end()) {
      value = lower;
      return "";
    }
    const std::vector<std::string_view> known(names.begin(), names.end());
    const std::string meant = did_you_mean(lower, names);
    return "not " + (value.empty() ? "an empty text" : value) +
           (meant.empty() ? ", but " : meant + " It is ") + listed(known);
  };
  return {choose, described};
}

std::string value_name(const CLI::Option& option) {
  const std::string name = option.get_type_size() == 0 ? "" : option.get_type_name();
  return name.substr(0, name.find(':'));
}

std::vector<std::string> choices(const CLI::Option& option) {
  const std::string name = option.get_type_size() == 0 ? "" : option.get_type_name();
  const std::size_t colon = name.find(':');
  if (colon == std::string::npos || name.find('|') == std::string::npos) return {};
  return CLI::detail::split(name.substr(colon + 1), '|');
}

}  // namespace plumbline::cli
