// Names earlier findings as the cause of a later one.

#include <fmt/format.h>

#include <algorithm>

#include "compare/steps.hpp"

namespace plumbline::compare_steps {

// More numbers than this do not help a reader.
constexpr std::size_t kMaxCauses = 4;

void add_causes(Finding& finding, Numbers numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  if (!numbers.empty() && numbers.front() == 0) numbers.erase(numbers.begin());
  if (numbers.empty()) return;
  std::string text = numbers.size() == 1 ? ", because of finding " : ", because of findings ";
  const std::size_t shown = std::min(numbers.size(), kMaxCauses);
  for (std::size_t i = 0; i < shown; ++i) {
    const bool is_last = i + 1 == numbers.size();
    text += fmt::format("{}{}", i == 0 ? "" : is_last ? " and " : ", ", numbers[i]);
  }
  if (shown < numbers.size()) text += fmt::format(" and {} more", numbers.size() - shown);
  finding.message += text;
  finding.because = std::move(numbers);
}

}  // namespace plumbline::compare_steps
