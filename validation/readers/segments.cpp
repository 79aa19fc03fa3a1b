// What a drawing becomes, one item a line, for comparison with other readers.
// Usage: plumbline_segments DRAWING TOLERANCE. Prints "segment ELEMENT LINE ax ay bx by" in
// doubles and "rejected ELEMENT LINE reason", which remarks are, too.

#include <iostream>

#include "plumbline/plumbline.hpp"

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::cerr << "usage: plumbline_segments DRAWING TOLERANCE\n";
    return 2;
  }
  using namespace plumbline;
  ReadOptions options;
  options.chord_tolerance = parse_decimal(argv[2]);
  options.hidden = true;  // as the others do
  const SegmentSet set = evaluate(read(argv[1], options));
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    const Source source = set.sources[set.segment_source[i]];
    const Segment segment = set.segments[i];
    std::cout << "segment " << source.element << ' ' << source.line;
    for (const Rational& number : {segment.a.x, segment.a.y, segment.b.x, segment.b.y}) {
      std::cout << ' ' << shortest_text(nearest_double(number));
    }
    std::cout << '\n';
  }
  for (const Rejected& item : set.rejected) {
    std::cout << "rejected " << item.source.element << ' ' << item.source.line << ' ' << item.reason
              << '\n';
  }
  for (const Remark& item : set.remarks) {
    std::cout << "rejected " << item.source.element << ' ' << item.source.line << ' ' << item.what
              << '\n';
  }
} catch (const plumbline::Error& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
