#include "plumbline/arrange.hpp"

#include "arrange/cgal_engine.hpp"
#include "arrange/within_limit.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

void ensure_number_within_limit(const Number& coordinate) {
  if (is_within_limit(coordinate)) return;
  throw Error(ErrorCode::Limit, "a coordinate is beyond 8.7e99", {},
              exact_text(coordinate.rational()));
}

}  // namespace

void ensure_within_limit(const SegmentSet& input) {
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    for (const Number& coordinate : input.segments.numbers(s)) {
      ensure_number_within_limit(coordinate);
    }
  }
  for (const Point& p : input.points) {
    ensure_number_within_limit(p.x);
    ensure_number_within_limit(p.y);
  }
}

ExactComplex arrange(const SegmentSet& input, ExactEngine engine, const ArrangeOptions& options) {
  if (engine == ExactEngine::Bucket) return Arrangement(input, options).complex();
  ensure_within_limit(input);
  return cgal_engine(input);
}

}  // namespace plumbline
