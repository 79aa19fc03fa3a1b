// A file with changes, which is read again before anyone relies on it.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "plumbline/edits.hpp"
#include "plumbline/error.hpp"
#include "plumbline/patch.hpp"
#include "plumbline/pipeline.hpp"
#include "read/input_file.hpp"

namespace plumbline {
namespace {

constexpr int kMostTries = 5;

/// A format whose files can be patched.
struct Patcher {
  std::string_view format;
  std::optional<Patch> (*patch)(std::string_view, const SegmentSet&, const SegmentSet&,
                                const std::vector<bool>&);
  Structure (*read)(std::string_view, const std::string&, const ReadOptions&);
};
constexpr std::array kPatchers{Patcher{"dxf", patched_dxf, read_dxf},
                               Patcher{"svg", patched_svg, read_svg}};

/// The nearest doubles of a segment's ends, the lesser first, and the segment.
struct Rounded {
  PointD a, b;
  std::size_t segment = 0;

  friend bool operator<(const Rounded& x, const Rounded& y) {
    return x.a != y.a ? x.a < y.a : x.b < y.b;
  }
};

/// Those that have a length in doubles, in order.
std::vector<Rounded> rounded_segments(const SegmentSet& set) {
  std::vector<Rounded> all;
  all.reserve(set.segments.size());
  for (std::size_t s = 0; s < set.segments.size(); ++s) {
    const auto n = set.segments.numbers(s);
    Rounded next{nearest(NumberPoint{n[0], n[1]}), nearest(NumberPoint{n[2], n[3]}), s};
    if (next.b < next.a) std::swap(next.a, next.b);
    if (next.a != next.b) all.push_back(next);
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Those of the first that the second does not have.
std::vector<Rounded> lacking(const std::vector<Rounded>& of, const std::vector<Rounded>& in) {
  std::vector<Rounded> result;
  std::set_difference(of.begin(), of.end(), in.begin(), in.end(), std::back_inserter(result));
  return result;
}

/// Counts the elements of these segments as changed; false where that is nothing new.
bool add_elements(const std::vector<Rounded>& missing, const SegmentSet& input,
                  const SegmentSet& output, std::vector<bool>& also) {
  bool is_new = false;
  for (const Rounded& each : missing) {
    const SourceId source = output.segment_source[each.segment];
    if (source >= input.sources.size() || also[source]) continue;
    also[source] = is_new = true;
  }
  return is_new;
}

}  // namespace

PatchedFile patched_file(const std::filesystem::path& file, std::string_view format,
                         const ReadOptions& options, const SegmentSet& input,
                         const SegmentSet& output) {
  PatchedFile result;
  if (!std::filesystem::is_regular_file(file)) {
    result.why_not = "what is read is no file";
    return result;
  }
  InputFile bytes(file);
  const std::string read_as = bytes.format(kFormats, options.format);
  const auto patcher = std::find_if(kPatchers.begin(), kPatchers.end(),
                                    [&](const Patcher& each) { return each.format == format; });
  if (patcher == kPatchers.end() || format != read_as) {
    result.why_not = fmt::format("a .{} file is made of a .{} one", format, read_as);
    return result;
  }
  const std::string text = bytes.text();
  ReadOptions reading = options;
  const bool has_virtual = std::any_of(output.sources.begin(), output.sources.end(),
                                       [](const Source& s) { return s.layer == kVirtualLayer; });
  if (!reading.layers.empty() && has_virtual) reading.layers.emplace_back(kVirtualLayer);
  const std::vector<Rounded> wanted = rounded_segments(output);
  std::vector<bool> also(input.sources.size());
  for (int tries = 0; tries < kMostTries; ++tries) {
    std::optional<Patch> patch = patcher->patch(text, input, output, also);
    if (!patch) {
      result.why_not = "its elements are not found in the text";
      return result;
    }
    const SegmentSet again = evaluate(patcher->read(patch->text, file.string(), reading));
    const std::vector<Rounded> found = rounded_segments(again);
    const std::vector<Rounded> missing = lacking(wanted, found);
    if (missing.empty() && found.size() == wanted.size() &&
        count_lost(again.rejected) <= count_lost(input.rejected)) {
      return {std::move(patch->text), std::move(patch->replaced), ""};
    }
    result.why_not =
        fmt::format("read again, {} of {} lines would be others", missing.size(), wanted.size());
    if (!missing.empty()) {
      const PointD& at = missing.front().a;
      result.why_not += fmt::format(", one at ({}, {})", shortest_text(at.x), shortest_text(at.y));
    }
    if (!add_elements(missing, input, output, also)) break;
  }
  return result;
}

PatchedFile patched_file(const std::filesystem::path& file, const ReadOptions& options,
                         const std::vector<DrawnPolygon>& polygons) {
  PatchedFile result;
  if (!std::filesystem::is_regular_file(file)) {
    result.why_not = "what is read is no file";
    return result;
  }
  InputFile bytes(file);
  const std::string read_as = bytes.format(kFormats, options.format);
  if (read_as != "geojson") {
    result.why_not = fmt::format("a .geojson file is made of a .{} one", read_as);
    return result;
  }
  std::optional<Patch> patch = patched_geojson(bytes.text(), polygons);
  if (!patch) {
    result.why_not = "its polygons are not found in the text";
    return result;
  }
  return {std::move(patch->text), std::move(patch->replaced), ""};
}

}  // namespace plumbline
