// One drawing of two.

#include <utility>

#include "plumbline/error.hpp"
#include "plumbline/overlay.hpp"

namespace plumbline {

SegmentSet together(SegmentSet first, const SegmentSet& second) {
  if (!first.crs.empty() && !second.crs.empty() && first.crs != second.crs) {
    throw Error(ErrorCode::BadInput,
                "two systems of coordinates, " + first.crs + " and " + second.crs);
  }
  if (first.crs.empty()) first.crs = second.crs;
  const auto files = static_cast<std::uint32_t>(first.files.size());
  const std::size_t sources = first.sources.size(), segments = first.segments.size();
  first.files.insert(first.files.end(), second.files.begin(), second.files.end());
  const auto moved = [&](Source source) {
    source.file += files;
    return source;
  };
  for (const Source& source : second.sources) first.sources.push_back(moved(source));
  for (std::size_t s = 0; s < second.segments.size(); ++s) {
    const auto n = second.segments.numbers(s);
    first.segments.push_back({n[0], n[1]}, {n[2], n[3]});
    first.segment_source.emplace_back(sources + second.segment_source[s]);
  }
  if (!first.rounding.empty() || !second.rounding.empty()) {
    first.rounding.resize(segments);
    first.rounding.insert(first.rounding.end(), second.rounding.begin(), second.rounding.end());
    first.rounding.resize(first.segments.size());
  }
  for (Ring ring : second.rings) {
    ring.first += static_cast<std::uint32_t>(segments);
    first.rings.push_back(ring);
  }
  for (std::size_t p = 0; p < second.points.size(); ++p) {
    first.points.push_back(second.points[p]);
    first.point_source.emplace_back(sources + second.point_source[p]);
  }
  for (Label label : second.labels) {
    label.source = SourceId(sources + label.source);
    first.labels.push_back(std::move(label));
  }
  first.layers.insert(first.layers.end(), second.layers.begin(), second.layers.end());
  for (Rejected item : second.rejected) {
    item.source = moved(std::move(item.source));
    first.rejected.push_back(std::move(item));
  }
  for (Remark remark : second.remarks) {
    remark.source = moved(std::move(remark.source));
    first.remarks.push_back(std::move(remark));
  }
  for (Replacement replacement : second.ledger) {
    replacement.source = moved(std::move(replacement.source));
    first.ledger.push_back(std::move(replacement));
  }
  return first;
}

}  // namespace plumbline
