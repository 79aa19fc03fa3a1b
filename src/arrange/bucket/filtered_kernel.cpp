#include "arrange/bucket/filtered_kernel.hpp"

#include <utility>

#include "arrange/bucket/median.hpp"
#include "arrange/bucket/weighted_input.hpp"

namespace plumbline::bucket {
FilteredKernel::FilteredKernel(GridInput input, Job& job) : approx_(input.lines.size()) {
  const auto& lines = input.lines;
  if (!lines.empty()) {
    const Int128 x = median_of<Int128>(lines.size(), [&](std::size_t i) { return lines[i][0]; });
    const Int128 y = median_of<Int128>(lines.size(), [&](std::size_t i) { return lines[i][1]; });
    job.for_each(lines.size(), [&](std::size_t s) {
      approx_[s] = {static_cast<double>(lines[s][0] - x), static_cast<double>(lines[s][1] - y),
                    static_cast<double>(lines[s][2] - x), static_cast<double>(lines[s][3] - y)};
    });
  }
  exact_ = ExactLines<Int128>(std::move(input.lines), std::move(input.frame));
}

FilteredKernel::FilteredKernel(const SegmentSet& input, Job& job) {
  WeightedInput weighted = WeightedInput::from(input, job);
  std::visit([&](auto& lines) { exact_ = std::move(lines); }, weighted.lines);
  approx_ = std::move(weighted.approx);
}

LineId FilteredKernel::join(EndId a, EndId b) {
  const PointD p = place(a), q = place(b);
  approx_.push_back({p.x, p.y, q.x, q.y});
  if (!std::visit([&](const auto& exact) { return exact.can_join(a, b); }, exact_)) {
    exact_ = of_any_size(std::get<ExactLines<Words>>(exact_));
  }
  return std::visit([&](auto& exact) { return exact.join(a, b); }, exact_);
}

void FilteredKernel::resize(std::size_t size) {
  approx_.resize(size);
  std::visit([&](auto& exact) { exact.resize(size); }, exact_);
}

void FilteredKernel::reorder(const std::vector<LineId>& order, Job& job) {
  std::vector<Approx> approx(order.size());
  job.for_each(order.size(), [&](std::size_t i) { approx[i] = approx_[order[i]]; });
  approx_ = std::move(approx);
  std::visit([&](auto& exact) { exact.reorder(order, job); }, exact_);
}

void FilteredKernel::keys(std::size_t begin, std::size_t end, std::uint64_t* key) const {
  std::visit([&](const auto& exact) { exact.keys(begin, end, key); }, exact_);
}

double FilteredKernel::parameter(LineId s, LineId o) const {
  const Relation r = relate(s, o);
  return r.cross() ? r.at_s : exact_parameter(s, o);
}

int FilteredKernel::compare_directions(LineId s, LineId o) const {
  const Approx &l = approx_[s], &m = approx_[o];
  const double dx = l.bx - l.ax, dy = l.by - l.ay, ex = m.bx - m.ax, ey = m.by - m.ay;
  const double size = largest({dx, dy, ex, ey});
  const double error = error_of(size, std::max(reach(l), reach(m)));
  const double value = dx * ey - dy * ex;
  if (value > error) return 1;
  if (value < -error) return -1;
  return std::visit([&](const auto& exact) { return exact.compare_directions(s, o); }, exact_);
}

bool FilteredKernel::exact_is_point(LineId s) const {
  return std::visit([&](const auto& exact) { return exact.is_point(s); }, exact_);
}
int FilteredKernel::exact_side(LineId s, EndId end) const {
  // Mostly it is one of its ends, which is told without a product.
  const PointD p = place(end);
  for (const EndId e : {first_end(s), last_end(s)}) {
    if (place(e) == p && exact_compare(e, end) == 0) return 0;
  }
  return std::visit([&](const auto& exact) { return exact.side(s, end); }, exact_);
}
int FilteredKernel::exact_compare(EndId p, EndId q) const {
  return std::visit([&](const auto& exact) { return exact.compare(p, q); }, exact_);
}
int FilteredKernel::exact_compare_x(EndId p, EndId q) const {
  return std::visit([&](const auto& exact) { return exact.compare_x(p, q); }, exact_);
}
double FilteredKernel::exact_parameter(LineId s, LineId o) const {
  return std::visit([&](const auto& exact) { return exact.parameter(s, o); }, exact_);
}
int FilteredKernel::compare_along(LineId s, LineId o, LineId q) const {
  return std::visit([&](const auto& exact) { return exact.compare_along(s, o, q); }, exact_);
}
int FilteredKernel::side_of_crossing(LineId c, LineId s, LineId o) const {
  return std::visit([&](const auto& exact) { return exact.side_of_crossing(c, s, o); }, exact_);
}
int FilteredKernel::compare_x(LineId s, LineId o, EndId end) const {
  return std::visit([&](const auto& exact) { return exact.compare_x(s, o, end); }, exact_);
}
int FilteredKernel::compare_heights(LineId s, LineId o, EndId end) const {
  return std::visit([&](const auto& exact) { return exact.compare_heights(s, o, end); }, exact_);
}
LongPoint FilteredKernel::point(EndId end) const {
  return std::visit([&](const auto& exact) { return exact.point(end); }, exact_);
}
LongPoint FilteredKernel::crossing(LineId s, LineId o) const {
  return std::visit([&](const auto& exact) { return exact.crossing(s, o); }, exact_);
}

}  // namespace plumbline::bucket
