// What a repair changed on the whole, and the way back.

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "geometry/union_find.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/edits.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

/// The nearest doubles of a segment's ends, the lesser first.
using Key = std::array<PointD, 2>;

Key key_of(std::span<const Number, 4> segment) {
  const PointD a{nearest_double(segment[0]), nearest_double(segment[1])};
  const PointD b{nearest_double(segment[2]), nearest_double(segment[3])};
  return b < a ? Key{b, a} : Key{a, b};
}

Key key_of(const Segment& segment) {
  const PointD a = nearest(segment.a), b = nearest(segment.b);
  return b < a ? Key{b, a} : Key{a, b};
}

bool is_unchanged(std::span<const Number, 4> input, std::span<const Number, 4> output) {
  const bool is_same = std::ranges::equal(input, output);
  return is_same || (input[0] == output[2] && input[1] == output[3] && input[2] == output[0] &&
                     input[3] == output[1]);
}

/// Segments of the input, then those of the output, in sets that hang together; the output's are
/// united where they look the same to one who has their nearest doubles only.
UnionFind connected(const SegmentSet& input, const Repair& repair) {
  const std::size_t count = input.segments.size();
  UnionFind sets(count + repair.output.segments.size());
  std::vector<std::pair<Key, std::size_t>> keys;
  keys.reserve(repair.output.segments.size());
  for (std::size_t i = 0; i < repair.output.segments.size(); ++i) {
    for (const SegmentId s : repair.origins[i]) sets.unite(s, count + i);
    keys.emplace_back(key_of(repair.output.segments.numbers(i)), count + i);
  }
  std::ranges::sort(keys);
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (keys[i].first == keys[i - 1].first) sets.unite(keys[i].second, keys[i - 1].second);
  }
  return sets;
}

/// Per set whether each of its segments is there before and after. Indexed by the representative.
std::vector<bool> unchanged_sets(const SegmentSet& input, const Repair& repair, UnionFind& sets) {
  const std::size_t count = input.segments.size();
  std::vector<bool> is_same(count + repair.output.segments.size(), true);
  std::vector<bool> is_kept(count, false);
  for (std::size_t i = 0; i < repair.output.segments.size(); ++i) {
    const auto origins = repair.origins[i];
    const bool is =
        origins.size() == 1 && !is_kept[origins[0]] &&
        is_unchanged(input.segments.numbers(origins[0]), repair.output.segments.numbers(i));
    if (is) {
      is_kept[origins[0]] = true;
    } else {
      is_same[sets.find(count + i)] = false;
    }
  }
  for (std::size_t s = 0; s < count; ++s) {
    if (!is_kept[s]) is_same[sets.find(s)] = false;
  }
  return is_same;
}

SourcedSegment sourced(const SegmentSet& input, std::size_t s) {
  const Source source = input.sources[input.segment_source[s]];
  const std::string file = source.file < input.files.size() ? input.files[source.file] : "";
  return {input.segments[s], source, file};
}

std::uint32_t file_index(SegmentSet& set, const std::string& name) {
  const auto known = std::ranges::find(set.files, name);
  if (known == set.files.end()) return set.add_file(name);
  return static_cast<std::uint32_t>(known - set.files.begin());
}

/// Throws unless the output has each segment of a change as often as the changes say.
void check_found(const std::map<Key, std::size_t>& said, const std::map<Key, std::size_t>& found,
                 const std::vector<NetChange>& changes) {
  for (const NetChange& change : changes) {
    for (const Segment& segment : change.after) {
      const Key key = key_of(segment);
      const auto place = found.find(key);
      const std::size_t times = place == found.end() ? 0 : place->second;
      if (times == said.at(key)) continue;
      throw Error(ErrorCode::BadInput,
                  "the drawing has a segment that the repair made " + std::to_string(times) +
                      " times instead of " + std::to_string(said.at(key)),
                  {}, to_text(segment));
    }
  }
}

/// Everything of a drawing but its segments and rings.
SegmentSet without_segments(const SegmentSet& drawing) {
  SegmentSet result = drawing;
  result.segments = {};
  result.segment_source.clear();
  result.rounding.clear();
  result.rings.clear();
  return result;
}

}  // namespace

std::vector<NetChange> net_changes(const SegmentSet& input, const Repair& repair) {
  UnionFind sets = connected(input, repair);
  const std::vector<bool> is_unchanged = unchanged_sets(input, repair, sets);
  const std::size_t count = input.segments.size();
  std::map<std::size_t, NetChange> changes;  // a representative is the set's least member
  for (std::size_t i = 0; i < count + repair.output.segments.size(); ++i) {
    const std::size_t set = sets.find(i);
    if (is_unchanged[set]) continue;
    if (i < count) {
      changes[set].before.push_back(sourced(input, i));
    } else {
      changes[set].after.push_back(repair.output.segments[i - count]);
    }
  }
  std::vector<NetChange> result;
  result.reserve(changes.size());
  for (auto& change : changes) result.push_back(std::move(change.second));
  return result;
}

SegmentSet undo(const SegmentSet& output, const std::vector<NetChange>& changes) {
  std::map<Key, std::size_t> said, found;
  for (const NetChange& change : changes) {
    for (const Segment& segment : change.after) ++said[key_of(segment)];
  }
  SegmentSet result = without_segments(output);
  for (std::size_t i = 0; i < output.segments.size(); ++i) {
    const auto numbers = output.segments.numbers(i);
    const Key key = key_of(numbers);
    if (said.contains(key)) {
      ++found[key];
      continue;
    }
    result.segments.push_back(NumberPoint{numbers[0], numbers[1]},
                              NumberPoint{numbers[2], numbers[3]});
    result.segment_source.push_back(output.segment_source[i]);
    if (!output.rounding.empty()) result.rounding.push_back(output.rounding[i]);
  }
  check_found(said, found, changes);
  for (const NetChange& change : changes) {
    for (const SourcedSegment& segment : change.before) {
      Source source = segment.source;
      source.file = file_index(result, segment.file);
      result.add(segment.segment, result.add_source(source));
      if (!output.rounding.empty()) result.rounding.push_back(0);
    }
  }
  return result;
}

std::string rounded_signature(const SegmentSet& drawing) {
  SegmentSet rounded;
  const SourceId source = rounded.add_source({});
  for (std::size_t s = 0; s < drawing.segments.size(); ++s) {
    const auto n = drawing.segments.numbers(s);
    const SegmentD segment{nearest(NumberPoint{n[0], n[1]}), nearest(NumberPoint{n[2], n[3]})};
    if (!(segment.a == segment.b)) rounded.add(segment.a, segment.b, source);
  }
  return signature(arrange(rounded));
}

}  // namespace plumbline
