#include "plumbline/arrange.hpp"

#include "arrange/cgal_engine.hpp"
#include "arrange/within_limit.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

void ensure_point_within_limit(const Point& p) {
  if (is_within_limit(p)) return;
  throw Error(ErrorCode::Limit, "a coordinate is beyond 8.7e99", {}, to_text(p));
}

}  // namespace

void ensure_within_limit(const SegmentSet& input) {
  for (const Segment& s : input.segments) {
    ensure_point_within_limit(s.a);
    ensure_point_within_limit(s.b);
  }
  for (const Point& p : input.points) ensure_point_within_limit(p);
}

ExactComplex arrange(const SegmentSet& input, Engine engine, const ArrangeOptions& options) {
  if (engine == Engine::Bucket) return Arrangement(input, options).complex();
  ensure_within_limit(input);
  return cgal_engine(input);
}

}  // namespace plumbline
