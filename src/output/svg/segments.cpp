// Segments as a picture of lines.

#include "output/svg/own_coordinates.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

constexpr double kLinePen = 1.2, kNote = 40, kNoteSize = 16;  // in units

/// The ends of the segments, two of each.
std::vector<PointD> ends_of(const SegmentSet& input, const svg::Frame& frame) {
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
  const svg::OwnCoordinates picture = svg::own_coordinates(extent(input), input.y_up);
  const std::vector<PointD> ends = ends_of(input, picture.frame);
  const double foot = picture.about.empty() ? 0 : kNote * picture.unit;
  std::string svg = svg::open(picture, foot) + "<g fill=\"none\" stroke=\"" + svg::kInk +
                    "\" stroke-linecap=\"round\" stroke-width=\"" +
                    shortest_text(kLinePen * picture.unit) + "\">\n";
  const std::size_t count = input.segments.size();
  for (std::size_t s = 0; s < count;) {
    svg.append("<path").append(svg::kNonScaling).append(" d=\"");
    const SourceId source = input.segment_source[s];
    const std::size_t begin = svg.size();
    for (std::size_t first = s;
         s < count && input.segment_source[s] == source && svg.size() - begin < svg::kLargestPath;
         ++s) {
      const bool goes_on = s > first && ends[2 * s - 1] == ends[2 * s];
      if (!goes_on) svg += 'M' + svg::coordinates(ends[2 * s]);
      svg += 'L' + svg::coordinates(ends[2 * s + 1]);
    }
    svg += "\"/>\n";
  }
  svg += "</g>\n";
  if (foot > 0) {
    svg += svg::text({picture.box.low.x, picture.box.high.y + foot}, kNoteSize * picture.unit,
                     " data-plumbline=\"legend\"", picture.about);
  }
  return svg + svg::kClose;
}

}  // namespace plumbline
