#include "arrange/bucket/buckets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "arrange/bucket/split.hpp"

namespace plumbline::bucket {
std::size_t Buckets::part_at(std::uint32_t node, double x, double y) const {
  while (!nodes_[node].is_bucket()) node = nodes_[node].low + (nodes_[node].is_high(x, y) ? 1 : 0);
  return nodes_[node].low;
}

Box Buckets::cell_box(std::size_t cell) const {
  const std::size_t column = cell % columns_, row = cell / columns_;
  const auto x = [&](std::size_t c) { return extent_.x0 + static_cast<double>(c) * column_width_; };
  const auto y = [&](std::size_t r) { return extent_.y0 + static_cast<double>(r) * row_height_; };
  return {column == 0 ? -INFINITY : x(column), row == 0 ? -INFINITY : y(row),
          column + 1 == columns_ ? INFINITY : x(column + 1),
          row + 1 == rows_ ? INFINITY : y(row + 1)};
}

/// About one cell a line, square, and not much smaller than a line is long.
void Buckets::choose_grid(std::span<const Approx> lines) {
  if (lines.empty()) return;
  const auto line = [&](std::size_t i) { return lines[i]; };
  const Sample sample = sample_of(lines.size(), line);
  extent_ = core_of(extent_of(lines.size(), line), sample);
  const double reach = std::max(
      {std::abs(extent_.x0), std::abs(extent_.y0), std::abs(extent_.x1), std::abs(extent_.y1)});
  margin_.border = std::max(32 * 0x1p-53 * reach, Margin::kLeast);
  constexpr double kOfMeanLength = 0.7;
  const double n = static_cast<double>(lines.size());
  const double width = std::max(extent_.x1 - extent_.x0, margin_.border);
  const double height = std::max(extent_.y1 - extent_.y0, margin_.border);
  const double side =
      std::max({kOfMeanLength * sample.mean_length, std::sqrt(width / n) * std::sqrt(height),
                std::max(width, height) / n, 4 * margin_.border});
  columns_ = static_cast<std::size_t>(std::max(1.0, std::ceil(width / side)));
  rows_ = static_cast<std::size_t>(std::max(1.0, std::ceil(height / side)));
  column_width_ = width > 0 ? width / static_cast<double>(columns_) : 1;
  row_height_ = height > 0 ? height / static_cast<double>(rows_) : 1;
  per_width_ = 1 / column_width_;
  per_height_ = 1 / row_height_;
}

Buckets::Buckets(std::span<const Approx> lines, double parameter_error, Job& job)
    : margin_{parameter_error, 0} {
  choose_grid(lines);
  fill(lines, job);
  split_full_cells(lines, job);
}

void Buckets::fill(std::span<const Approx> lines, Job& job) {
  members_ = group<LineId>(
      columns_ * rows_, lines.size(),
      [&](std::size_t begin, std::size_t end, const auto& visit) {
        for (std::size_t s = begin; s < end; ++s) {
          for_cells(lines[s], [&](std::size_t c) { visit(c, static_cast<LineId>(s)); });
        }
      },
      job);
}

/// Level by level, so that the nodes of a level are split in parallel and numbered in order.
void Buckets::split_full_cells(std::span<const Approx> lines, Job& job) {
  constexpr int kDeepest = 60;
  const std::size_t cells = members_.size();
  cell_node_.assign(cells, kNone);
  std::vector<Open> level, next;
  for (std::size_t c = 0; c < cells; ++c) {
    const std::span<const LineId> here = members_[c];
    if (here.size() <= kFullBucket) continue;
    cell_node_[c] = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({});
    level.push_back({cell_node_[c], cell_box(c), true, {}});
    for (const LineId s : here) {
      level.back().members.push_back(clipped(s, lines, level.back().box, 2 * margin_(lines[s])));
    }
  }
  for (int depth = 0; !level.empty(); ++depth) {
    std::vector<Split> splits(level.size());
    job.for_blocks(level.size(), 1, [&](std::size_t i, std::size_t) {
      if (depth < kDeepest) splits[i] = split(level[i].members, lines, margin_);
    });
    for (std::size_t i = 0; i < level.size(); ++i) settle(level[i], splits[i], next);
    level = std::exchange(next, {});
  }
}

void Buckets::settle(Open& open, Split& split, std::vector<Open>& next) {
  if (!split.useful) {
    nodes_[open.node] = {0, 0, 0, static_cast<std::uint32_t>(size())};
    part_boxes_.push_back(open.box);
    part_is_box_.push_back(open.is_box ? 1 : 0);
    for (const Piece& piece : open.members) parts_.items.push_back(piece.line);
    parts_.begin.push_back(static_cast<std::uint32_t>(parts_.items.size()));
    return;
  }
  const auto child = static_cast<std::uint32_t>(nodes_.size());
  nodes_[open.node] = {split.normal.x, split.normal.y, split.at, child};
  nodes_.resize(nodes_.size() + 2);
  const bool is_box = open.is_box && (split.normal.x == 0 || split.normal.y == 0);
  Box low = open.box, high = open.box;
  if (split.normal.y == 0) low.x1 = high.x0 = split.at;
  if (split.normal.x == 0) low.y1 = high.y0 = split.at;
  next.push_back({child, low, is_box, std::move(split.low)});
  next.push_back({child + 1, high, is_box, std::move(split.high)});
}

}  // namespace plumbline::bucket
