// Segments as a picture of lines.

#include "output/svg/picture.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

struct Line {
  PointD a, b;
};

std::vector<Line> lines_of(const SegmentSet& input) {
  const double up = input.y_up ? -1 : 1;
  const auto place = [up](const PointD& p) { return PointD{p.x, up * p.y + 0.0}; };
  std::vector<Line> lines;
  lines.reserve(input.segments.size());
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const auto numbers = input.segments.numbers(s);
    lines.push_back({place(nearest(NumberPoint{numbers[0], numbers[1]})),
                     place(nearest(NumberPoint{numbers[2], numbers[3]}))});
  }
  return lines;
}

svg::Box bounds(const std::vector<Line>& lines) {
  FloatComplex ends;  // nothing but its vertices
  for (const Line& line : lines) {
    ends.vertices.push_back(line.a);
    ends.vertices.push_back(line.b);
  }
  return svg::bounds(ends);
}

}  // namespace

std::string to_svg(const SegmentSet& input) {
  constexpr double kMargin = 0.02;
  const std::vector<Line> lines = lines_of(input);
  const svg::Box box = svg::widened(bounds(lines), kMargin);
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"" + svg::coordinates(box.low) + ' ' +
      svg::coordinates({box.width(), box.height()}) + "\">\n<g fill=\"none\" stroke=\"" +
      svg::kInk + "\" stroke-linecap=\"round\" stroke-width=\"" +
      shortest_text(svg::pen_width(box)) + "\">\n";
  for (std::size_t s = 0; s < lines.size();) {
    svg += "<path d=\"";
    const SourceId source = input.segment_source[s];
    const PointD* end = nullptr;
    for (; s < lines.size() && input.segment_source[s] == source; ++s) {
      if (end == nullptr || !(*end == lines[s].a)) svg += 'M' + svg::coordinates(lines[s].a);
      svg += 'L' + svg::coordinates(lines[s].b);
      end = &lines[s].b;
    }
    svg += "\"/>\n";
  }
  return svg + "</g>\n</svg>\n";
}

}  // namespace plumbline
