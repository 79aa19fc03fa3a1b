#include "read/svg/pen.hpp"

#include <algorithm>
#include <utility>

#include "geometry/text_rounding.hpp"
#include "number/bound_text.hpp"

namespace plumbline {
namespace {

Point exact_point(const NumberPoint& p) { return {p.x.rational(), p.y.rational()}; }

}  // namespace

void SvgPen::move_to(NumberPoint point) {
  start_ = current_ = std::move(point);
  subpath_ = pieces_.segments.size();
  is_ring_ = true;
}

void SvgPen::jump_to(NumberPoint point) {
  current_ = std::move(point);
  is_ring_ = false;
}

void SvgPen::line_to(NumberPoint end) {
  pieces_.segments.push_back(std::move(current_), end);
  current_ = std::move(end);
}

void SvgPen::curve_to(std::span<const NumberPoint> controls, const std::string& what) {
  std::vector<Point> points{exact_point(current_)};
  for (const NumberPoint& control : controls) points.push_back(exact_point(control));
  draw(flattener_.bezier(points), what);
}

void SvgPen::arc_to(const SvgArc& arc, const std::string& what) {
  const PlacedArc placed = place_arc(arc, bound_);
  draw(placed.arc, what, placed.bound + arc.rounding);
  for (const Replacement& replaced : placed.replaced) {
    auto& all = pieces_.replaced;
    if (std::find(all.begin(), all.end(), replaced) == all.end()) all.push_back(replaced);
  }
}

void SvgPen::draw(const EllipticArc& arc, const std::string& what, double bound) {
  const Chords chords = flattener_.arc(arc);
  const auto end_bound = [&](const NumberPoint& p) { return text_rounding(p) > 0 ? bound : 0; };
  pieces_.curves.push_back({static_cast<std::uint32_t>(pieces_.segments.size()),
                            static_cast<std::uint32_t>(chords.points.size() - 1),
                            arc.ellipse,
                            chords.bound,
                            {end_bound(chords.points.front()), end_bound(chords.points.back())},
                            bound});
  draw(chords, what);
}

void SvgPen::draw(const Chords& chords, const std::string& what) {
  is_ring_ = false;
  for (std::size_t i = 1; i < chords.points.size(); ++i) line_to(chords.points[i]);
  if (chords.bound == 0) return;
  const auto is_same = [&what](const Tally& tally) { return tally.what == what; };
  auto tally = std::find_if(tallies_.begin(), tallies_.end(), is_same);
  if (tally == tallies_.end()) tally = tallies_.insert(tally, {what, 0, 0, 0});
  ++tally->curves;
  tally->chords += chords.points.size() - 1;
  tally->bound = std::max(tally->bound, chords.bound);
}

void SvgPen::close() {
  if (!(current_ == start_)) line_to(start_);
  const std::size_t end = pieces_.segments.size();
  if (is_ring_ && end > subpath_) {
    pieces_.rings.push_back({static_cast<std::uint32_t>(subpath_),
                             static_cast<std::uint32_t>(end - subpath_), RingRole::Line});
  }
  subpath_ = end;
  is_ring_ = true;
}

Pieces SvgPen::finish() && {
  for (const Tally& tally : tallies_) {
    Replacement replaced;
    replaced.what = tally.what;
    if (tally.curves > 1) replaced.what += " (" + std::to_string(tally.curves) + " times)";
    replaced.what += " by " + std::to_string(tally.chords) + " chords";
    replaced.bound = bound_text(tally.bound) + " units";
    pieces_.replaced.push_back(std::move(replaced));
  }
  return std::move(pieces_);
}

}  // namespace plumbline
