#pragma once

// Step 2: lines in the order of a space-filling curve, so that what is near in the plane is near in
// memory.

#include <algorithm>
#include <cmath>
#include <vector>

#include "arrange/bucket/collinear.hpp"

namespace plumbline::bucket {

/// Position along the Hilbert curve of a square of 2^16 x 2^16 cells.
std::uint32_t hilbert(std::uint32_t x, std::uint32_t y);

struct Box {
  double x0, y0, x1, y1;
};

/// The box around lines; `line(i)` gives each as Approx.
template <class Line>
Box extent_of(std::size_t count, Line line) {
  Box box{INFINITY, INFINITY, -INFINITY, -INFINITY};
  for (std::size_t i = 0; i < count; ++i) {
    const Approx l = line(i);
    box.x0 = std::min(box.x0, l.ax);
    box.x1 = std::max(box.x1, l.bx);
    box.y0 = std::min({box.y0, l.ay, l.by});
    box.y1 = std::max({box.y1, l.ay, l.by});
  }
  return box;
}

/// Up to kSampleSize lines: the coordinates of their middles, sorted, and the mean of their lengths
/// (the greater of width and height), the longest left out.
struct Sample {
  std::vector<double> x, y;
  double mean_length = 0;
};
inline constexpr std::size_t kSampleSize = 1024;

template <class Line>
Sample sample_of(std::size_t count, Line line) {
  Sample sample;
  const std::size_t size = std::min(count, kSampleSize);
  double longest = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const Approx l = line(i * count / size);
    sample.x.push_back(l.ax / 2 + l.bx / 2);
    sample.y.push_back(l.ay / 2 + l.by / 2);
    const double length = std::max(l.bx - l.ax, std::abs(l.by - l.ay));
    longest = std::max(longest, length);
    sample.mean_length += length;
  }
  if (size > 1) sample.mean_length = (sample.mean_length - longest) / static_cast<double>(size - 1);
  std::sort(sample.x.begin(), sample.x.end());
  std::sort(sample.y.begin(), sample.y.end());
  return sample;
}

/// The part of a box where nearly all lines are, if it is much smaller: so that a few far away do
/// not decide how finely the others are told apart.
Box core_of(const Box& whole, const Sample& sample);

/// The lines kept, by the curve's order of their middles.
template <class Kernel>
std::vector<LineId> curve_order(const Kernel& kernel, const std::vector<LineId>& kept, Job& job) {
  constexpr double kCells = 65535;
  const auto line = [&](std::size_t i) { return kernel.approx(kept[i]); };
  const Box box = core_of(extent_of(kept.size(), line), sample_of(kept.size(), line));
  const double side = std::max({box.x1 - box.x0, box.y1 - box.y0, 1e-300});
  std::vector<std::uint64_t> keys(kept.size());
  job.for_each(kept.size(), [&](std::size_t i) {
    const Approx l = line(i);
    const auto cell = [&](double a, double b, double low) {
      return static_cast<std::uint32_t>(
          std::clamp(((a - low) / 2 + (b - low) / 2) / side, 0.0, 1.0) * kCells);
    };
    keys[i] = std::uint64_t{hilbert(cell(l.ax, l.bx, box.x0), cell(l.ay, l.by, box.y0))} << 32U | i;
  });
  job.sort_integers(keys);
  std::vector<LineId> order(kept.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    order[i] = kept[static_cast<std::uint32_t>(keys[i])];
  }
  return order;
}

/// Sorts and renumbers the kernel's lines.
template <class Kernel>
Provenance sort_lines(Kernel& kernel, std::size_t item_count, Merged merged, Job& job) {
  const std::vector<LineId> order = curve_order(kernel, merged.kept, job);
  Provenance provenance{{}, static_cast<std::uint32_t>(item_count), std::move(merged.carriers)};
  Carriers& carriers = provenance.carriers;
  if (!carriers.line.empty()) {
    std::vector<LineId> number(kernel.size(), kNone);
    for (std::size_t s = 0; s < order.size(); ++s) number[order[s]] = static_cast<LineId>(s);
    for (LineId& s : carriers.line) s = number[s];
    for (LineId& s : carriers.breaks.items) s = number[s];
  }
  kernel.reorder(order, job);
  provenance.item = order;
  for (std::size_t c = 0; c < carriers.line.size(); ++c) {
    provenance.item[carriers.line[c]] = static_cast<std::uint32_t>(item_count + c);
  }
  return provenance;
}

}  // namespace plumbline::bucket
