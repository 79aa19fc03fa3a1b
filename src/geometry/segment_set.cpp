#include <algorithm>
#include <cmath>
#include <utility>

#include "error/shown_text.hpp"
#include "geometry/rejected.hpp"
#include "plumbline/geometry.hpp"

namespace plumbline {
namespace {

/// Whether |c| < 2^kMaxCoordinateBits; sizes in bits decide all but borderline cases.
bool is_below_limit(const Rational& c) {
  const auto bits = [](mpz_srcptr z) { return static_cast<long>(mpz_sizeinbase(z, 2)); };
  const long exponent = bits(c.get_num_mpz_t()) - bits(c.get_den_mpz_t());
  if (exponent < kMaxCoordinateBits) return true;
  static const Rational limit(mpz_class(1) << kMaxCoordinateBits);
  return exponent == kMaxCoordinateBits && abs(c) < limit;
}

constexpr const char* kBeyondLimit = "a coordinate is beyond 8.7e99";

bool is_finite(const PointD& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

std::string to_text(const PointD& p) { return shortest_text(p.x) + " " + shortest_text(p.y); }

}  // namespace

Rejected make_rejected(Source source, std::string reason, std::string text, bool harmless) {
  return {std::move(source), std::move(reason), shown_text(std::move(text)), harmless};
}

Remark make_remark(Source source, std::string what, std::string text) {
  return {std::move(source), std::move(what), shown_text(std::move(text))};
}

std::size_t count_lost(const std::vector<Rejected>& rejected) {
  return static_cast<std::size_t>(std::ranges::count(rejected, false, &Rejected::harmless));
}

bool is_within_limit(const Point& p) { return is_below_limit(p.x) && is_below_limit(p.y); }

bool is_within_limit(const Number& coordinate) {
  return coordinate.is_decimal() || is_below_limit(coordinate.held_rational());  // decimals < 2^63
}

std::uint32_t SegmentSet::add_file(std::string name) {
  files.push_back(std::move(name));
  return static_cast<std::uint32_t>(files.size() - 1);
}

SourceId SegmentSet::add_source(const Source& source) {
  sources.push_back(source);
  return SourceId(sources.size() - 1);
}

void SegmentSet::add(Segment segment, SourceId source) {
  add({std::move(segment.a.x), std::move(segment.a.y)},
      {std::move(segment.b.x), std::move(segment.b.y)}, source);
}

void SegmentSet::add(NumberPoint a, NumberPoint b, SourceId source) {
  const auto reject = [&](const char* reason, bool harmless) {
    rejected.push_back(
        make_rejected(sources.at(source), reason, to_text(a) + ", " + to_text(b), harmless));
  };
  if (a == b) {
    reject("zero-length segment", true);
  } else if (!is_within_limit(a.x) || !is_within_limit(a.y) || !is_within_limit(b.x) ||
             !is_within_limit(b.y)) {
    reject(kBeyondLimit, false);
  } else {
    segments.push_back(std::move(a), std::move(b));
    segment_source.push_back(source);
  }
}

void SegmentSet::add(PointD a, PointD b, SourceId source) {
  if (is_finite(a) && is_finite(b)) {
    add(Segment{exact(a), exact(b)}, source);
    return;
  }
  rejected.push_back(make_rejected(sources.at(source), "coordinate is not a finite number",
                                   to_text(a) + ", " + to_text(b)));
}

void SegmentSet::add_point(Point point, SourceId source) {
  if (!is_within_limit(point)) {
    rejected.push_back(make_rejected(sources.at(source), kBeyondLimit, plumbline::to_text(point)));
    return;
  }
  points.push_back(std::move(point));
  point_source.push_back(source);
}

}  // namespace plumbline
