#include <iostream>
#include <plumbline/geometry.hpp>

// Exact decimals reach a user: in doubles, 0.1 + 0.2 is not 0.3.
int main() {
  using plumbline::parse_decimal;
  plumbline::SegmentSet set;
  set.add({{0, 0}, {parse_decimal("0.1") + parse_decimal("0.2"), 1}}, set.add_source({}));
  std::cout << to_text(set.segments.front()) << '\n';
  return to_text(set.segments.front()) == "0 0, 0.3 1" ? 0 : 1;
}
