#include "arrange/bucket/buckets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumbline::bucket {
namespace {

/// A cell with more lines is split.
constexpr std::size_t kFull = 24;
/// A split must leave fewer than this times the lines in its two parts together.
constexpr double kProgress = 1.5;
constexpr int kDeepest = 60;

/// The x coordinates that a line takes at heights within [low, high], widened by the margin.
std::pair<double, double> x_range(const Approx& l, double low, double high, double margin) {
  const double dy = l.by - l.ay;
  double x0 = l.ax, x1 = l.bx;
  if (dy != 0) {
    const double slope = (l.bx - l.ax) / dy;
    const double bottom = std::min(l.ay, l.by), top = std::max(l.ay, l.by);
    const auto at = [&](double y) { return l.ax + (std::clamp(y, bottom, top) - l.ay) * slope; };
    x0 = at(low - margin);
    x1 = at(high + margin);
    if (x1 < x0) std::swap(x0, x1);
    // A steep slope magnifies rounding; the line has no other x.
    x0 = std::clamp(x0, l.ax, l.bx);
    x1 = std::clamp(x1, l.ax, l.bx);
  }
  return {x0 - margin, x1 + margin};
}

Approx transposed(const Approx& l) {
  return l.ay <= l.by ? Approx{l.ay, l.ax, l.by, l.bx} : Approx{l.by, l.bx, l.ay, l.ax};
}

}  // namespace

std::size_t Buckets::column(double x) const {
  const double c = (x - extent_.x0) / column_width_;
  return c <= 0 ? 0 : std::min(static_cast<std::size_t>(c), columns_ - 1);
}

std::size_t Buckets::row(double y) const {
  const double r = (y - extent_.y0) / row_height_;
  return r <= 0 ? 0 : std::min(static_cast<std::size_t>(r), rows_ - 1);
}

std::size_t Buckets::bucket_at(double x, double y) const {
  std::uint32_t node = cells_[row(y) * columns_ + column(x)];
  while (nodes_[node].kind != Node::Leaf) {
    const double c = nodes_[node].kind == Node::SplitX ? x : y;
    node = nodes_[node].low + (c < nodes_[node].at ? 0 : 1);
  }
  return nodes_[node].low;
}

/// About one cell a line, square, and not much smaller than a line is long.
void Buckets::choose_grid(std::span<const Approx> lines) {
  if (lines.empty()) return;
  Box e{lines[0].ax, lines[0].ay, lines[0].ax, lines[0].ay};
  double length = 0;
  for (const Approx& l : lines) {
    e.x0 = std::min(e.x0, l.ax);
    e.x1 = std::max(e.x1, l.bx);
    e.y0 = std::min({e.y0, l.ay, l.by});
    e.y1 = std::max({e.y1, l.ay, l.by});
    length += std::max(l.bx - l.ax, std::abs(l.by - l.ay));
  }
  extent_ = e;
  constexpr double kOfMeanLength = 0.7;
  const double n = static_cast<double>(lines.size());
  const double width = std::max(e.x1 - e.x0, margin_), height = std::max(e.y1 - e.y0, margin_);
  const double side = std::max({kOfMeanLength * length / n, std::sqrt(width / n * height),
                                std::max(width, height) / n, 4 * margin_});
  columns_ = static_cast<std::size_t>(std::max(1.0, std::ceil(width / side)));
  rows_ = static_cast<std::size_t>(std::max(1.0, std::ceil(height / side)));
  column_width_ = width > 0 ? width / static_cast<double>(columns_) : 1;
  row_height_ = height > 0 ? height / static_cast<double>(rows_) : 1;
}

template <class Visit>
void Buckets::for_cells(const Approx& line, Visit visit) const {
  const auto [bottom, top] = std::minmax(line.ay, line.by);
  const std::size_t first = row(bottom - margin_), last = row(top + margin_);
  for (std::size_t r = first; r <= last; ++r) {
    const double low = extent_.y0 + static_cast<double>(r) * row_height_;
    const auto [x0, x1] = first == last ? std::pair(line.ax - margin_, line.bx + margin_)
                                        : x_range(line, low, low + row_height_, margin_);
    const std::size_t end = column(x1);
    for (std::size_t c = column(x0); c <= end; ++c) visit(r * columns_ + c);
  }
}

Buckets::Buckets(std::span<const Approx> lines, double margin) : margin_(margin) {
  choose_grid(lines);
  const std::size_t count = columns_ * rows_;
  std::vector<std::uint32_t> begin(count + 1, 0);
  for (const Approx& line : lines) for_cells(line, [&](std::size_t c) { ++begin[c + 1]; });
  for (std::size_t c = 0; c < count; ++c) begin[c + 1] += begin[c];
  std::vector<LineId> members(begin[count]);
  std::vector<std::uint32_t> end(begin.begin(), begin.end() - 1);
  for (std::size_t s = 0; s < lines.size(); ++s) {
    for_cells(lines[s], [&](std::size_t c) { members[end[c]++] = static_cast<LineId>(s); });
  }
  cells_.resize(count);
  nodes_.resize(count);
  for (std::size_t c = 0; c < count; ++c) {
    cells_[c] = static_cast<std::uint32_t>(c);
    const std::size_t column = c % columns_, row = c / columns_;
    const double x = extent_.x0 + static_cast<double>(column) * column_width_;
    const double y = extent_.y0 + static_cast<double>(row) * row_height_;
    const Box box{x, y, x + column_width_, y + row_height_};
    const std::span<const LineId> here(members.data() + begin[c], begin[c + 1] - begin[c]);
    if (here.size() <= kFull) {
      nodes_[c] = {0, static_cast<std::uint32_t>(boxes_.size()), Node::Leaf};
      add_bucket(box, here);
    } else {
      refine(static_cast<std::uint32_t>(c), box, {here.begin(), here.end()}, lines, 0);
    }
  }
}

void Buckets::add_bucket(const Box& box, std::span<const LineId> lines) {
  boxes_.push_back(box);
  lines_.insert(lines_.end(), lines.begin(), lines.end());
  begin_.push_back(static_cast<std::uint32_t>(lines_.size()));
}

namespace {

struct Split {
  double at = 0;
  std::vector<LineId> low, high;
  std::size_t size() const { return low.size() + high.size(); }
};

/// Splits along x at the centroid of the parts of the lines inside the box.
template <class Line>
Split split(const Box& box, const std::vector<LineId>& members, double margin, Line line) {
  std::vector<std::pair<double, double>> ranges;
  Split result;
  for (const LineId s : members) {
    ranges.push_back(x_range(line(s), box.y0, box.y1, margin));
    const auto [x0, x1] = ranges.back();
    result.at += (std::clamp(x0, box.x0, box.x1) + std::clamp(x1, box.x0, box.x1)) / 2;
  }
  result.at /= static_cast<double>(members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (ranges[i].first <= result.at) result.low.push_back(members[i]);
    if (ranges[i].second >= result.at) result.high.push_back(members[i]);
  }
  return result;
}

}  // namespace

void Buckets::refine(std::uint32_t node, const Box& box, std::vector<LineId> members,
                     std::span<const Approx> lines, int depth) {
  Split best;
  bool along_x = true, useful = false;
  if (members.size() > kFull && depth < kDeepest) {
    best = split(box, members, margin_, [&](LineId s) { return lines[s]; });
    const Box turned{box.y0, box.x0, box.y1, box.x1};
    Split other = split(turned, members, margin_, [&](LineId s) { return transposed(lines[s]); });
    if (other.size() < best.size()) {
      best = std::move(other);
      along_x = false;
    }
    const double low = along_x ? box.x0 : box.y0, high = along_x ? box.x1 : box.y1;
    useful = low < best.at && best.at < high &&
             static_cast<double>(best.size()) < kProgress * static_cast<double>(members.size());
  }
  if (!useful) {
    nodes_[node] = {0, static_cast<std::uint32_t>(boxes_.size()), Node::Leaf};
    add_bucket(box, members);
    return;
  }
  members = {};
  const auto child = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node] = {best.at, child, along_x ? Node::SplitX : Node::SplitY};
  nodes_.resize(nodes_.size() + 2);
  Box low = box, high = box;
  (along_x ? low.x1 : low.y1) = best.at;
  (along_x ? high.x0 : high.y0) = best.at;
  refine(child, low, std::move(best.low), lines, depth + 1);
  refine(child + 1, high, std::move(best.high), lines, depth + 1);
}

}  // namespace plumbline::bucket
