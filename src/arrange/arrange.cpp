#include "plumbline/arrange.hpp"

#include "arrange/bucket_engine.hpp"
#include "arrange/cgal_engine.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

void ensure_within_limit(const Point& p) {
  if (is_within_limit(p)) return;
  throw Error(ErrorCode::Limit, "a coordinate is beyond 8.7e99", {}, to_text(p));
}

}  // namespace

ExactComplex arrange(const SegmentSet& input, Engine engine) {
  for (const Segment& s : input.segments) {
    ensure_within_limit(s.a);
    ensure_within_limit(s.b);
  }
  for (const Point& p : input.points) ensure_within_limit(p);
  return engine == Engine::Cgal ? cgal_engine(input) : bucket_engine(input);
}

}  // namespace plumbline
