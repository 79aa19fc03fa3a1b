// Which elements of a file no longer have the segments that they had.

#include "output/patch/changed.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace plumbline::patch {
namespace {

using Place = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

Place place_of(const Source& source) { return {source.file, source.line, source.column}; }

/// Segments by their sources; each with the lesser end first.
std::vector<std::pair<std::size_t, Segment>> by_source(const SegmentSet& set, std::size_t sources) {
  std::vector<std::pair<std::size_t, Segment>> all;
  for (std::size_t s = 0; s < set.segments.size(); ++s) {
    if (set.segment_source[s] >= sources) continue;
    Segment segment = set.segments[s];
    if (segment.b < segment.a) std::swap(segment.a, segment.b);
    all.emplace_back(set.segment_source[s], std::move(segment));
  }
  std::sort(all.begin(), all.end(), [](const auto& x, const auto& y) {
    return std::tie(x.first, x.second.a, x.second.b) < std::tie(y.first, y.second.a, y.second.b);
  });
  return all;
}

/// Per source whether its segments are others.
std::vector<bool> changed_sources(const SegmentSet& input, const SegmentSet& output) {
  const std::size_t count = input.sources.size();
  std::vector<bool> changed(count);
  const auto before = by_source(input, count), after = by_source(output, count);
  for (std::size_t i = 0, j = 0; i < before.size() || j < after.size();) {
    const std::size_t source = std::min(i < before.size() ? before[i].first : count,
                                        j < after.size() ? after[j].first : count);
    const std::size_t i0 = i, j0 = j;
    while (i < before.size() && before[i].first == source) ++i;
    while (j < after.size() && after[j].first == source) ++j;
    const auto at = [](const auto& list, std::size_t k) {
      return list.begin() + static_cast<std::ptrdiff_t>(k);
    };
    changed[source] = !std::equal(at(before, i0), at(before, i), at(after, j0), at(after, j));
  }
  return changed;
}

}  // namespace

Changes changes_of(const SegmentSet& input, const SegmentSet& output,
                   const std::vector<bool>& also) {
  const std::vector<bool> changed = changed_sources(input, output);
  std::map<Place, Changed> elements;
  for (std::size_t s = 0; s < changed.size(); ++s) {
    if (!changed[s] && (also.empty() || !also[s])) continue;
    const Source source = input.sources[s];
    elements.emplace(place_of(source), Changed{source, 0, {}});
  }
  for (const Source& source : input.sources) {
    if (const auto found = elements.find(place_of(source)); found != elements.end()) {
      ++found->second.drawn;
    }
  }
  Changes result;
  for (std::size_t s = 0; s < output.segments.size(); ++s) {
    const SourceId source = output.segment_source[s];
    if (source >= input.sources.size()) {
      result.added.emplace_back(s);
    } else if (const auto found = elements.find(place_of(input.sources[source]));
               found != elements.end()) {
      found->second.lines.emplace_back(s);
    }
  }
  for (auto& element : elements) result.elements.push_back(std::move(element.second));
  return result;
}

std::string replaced(std::string_view text, std::vector<Replacement> replacements) {
  std::stable_sort(replacements.begin(), replacements.end(),
                   [](const Replacement& a, const Replacement& b) { return a.begin < b.begin; });
  std::string result;
  std::size_t at = 0;
  for (const Replacement& replacement : replacements) {
    (result += text.substr(at, replacement.begin - at)) += replacement.text;
    at = replacement.end;
  }
  return result += text.substr(at);
}

std::string coordinate(const Number& number) {
  std::string exact = exact_text(number.rational());
  return exact.find('/') == std::string::npos ? exact : shortest_text(nearest_double(number));
}

}  // namespace plumbline::patch
