// Segments as a picture of lines.

#include "output/svg/kit.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

/// The ends of the segments, two of each.
std::vector<PointD> ends_of(const SegmentSet& input) {
  svg::Frame frame;
  frame.y_up = input.y_up;
  std::vector<PointD> ends;
  ends.reserve(2 * input.segments.size());
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const auto numbers = input.segments.numbers(s);
    ends.push_back(frame(nearest(NumberPoint{numbers[0], numbers[1]})));
    ends.push_back(frame(nearest(NumberPoint{numbers[2], numbers[3]})));
  }
  return ends;
}

}  // namespace

std::string to_svg(const SegmentSet& input) {
  constexpr double kMargin = 0.02;
  const std::vector<PointD> ends = ends_of(input);
  const svg::Box box = svg::widened(svg::bounds(ends), kMargin);
  std::string svg = svg::open_drawing(box) + "<g fill=\"none\" stroke=\"" + svg::kInk +
                    "\" stroke-linecap=\"round\" stroke-width=\"" +
                    shortest_text(svg::pen_width(box)) + "\">\n";
  const std::size_t count = input.segments.size();
  for (std::size_t s = 0; s < count;) {
    svg += "<path d=\"";
    const SourceId source = input.segment_source[s];
    for (std::size_t first = s; s < count && input.segment_source[s] == source; ++s) {
      const bool goes_on = s > first && ends[2 * s - 1] == ends[2 * s];
      if (!goes_on) svg += 'M' + svg::coordinates(ends[2 * s]);
      svg += 'L' + svg::coordinates(ends[2 * s + 1]);
    }
    svg += "\"/>\n";
  }
  return svg + "</g>\n</svg>\n";
}

}  // namespace plumbline
