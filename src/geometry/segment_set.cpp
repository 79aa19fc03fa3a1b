#include <cmath>
#include <utility>

#include "geometry/rejected.hpp"
#include "plumbline/geometry.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kShownText = 60;

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

bool is_finite(const PointD& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

std::string to_text(const PointD& p) { return shortest_text(p.x) + " " + shortest_text(p.y); }

}  // namespace

Rejected make_rejected(Source source, std::string reason, std::string text) {
  if (text.size() > kShownText) {
    std::size_t end = kShownText - 3;
    while (end > 0 && continues_character(text[end])) --end;
    text.resize(end);
    text += "...";
  }
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return {std::move(source), std::move(reason), std::move(text)};
}

std::uint32_t SegmentSet::add_file(std::string name) {
  files.push_back(std::move(name));
  return static_cast<std::uint32_t>(files.size() - 1);
}

SourceId SegmentSet::add_source(Source source) {
  sources.push_back(std::move(source));
  return SourceId(sources.size() - 1);
}

void SegmentSet::add(Segment segment, SourceId source) {
  if (segment.a == segment.b) {
    rejected.push_back(
        make_rejected(sources.at(source), "zero-length segment", plumbline::to_text(segment)));
    return;
  }
  segments.push_back(std::move(segment));
  segment_source.push_back(source);
}

void SegmentSet::add(PointD a, PointD b, SourceId source) {
  if (is_finite(a) && is_finite(b)) {
    add(Segment{exact(a), exact(b)}, source);
    return;
  }
  rejected.push_back(make_rejected(sources.at(source), "coordinate is not a finite number",
                                   to_text(a) + ", " + to_text(b)));
}

void SegmentSet::add(Point point, SourceId source) {
  points.push_back(std::move(point));
  point_source.push_back(source);
}

}  // namespace plumbline
