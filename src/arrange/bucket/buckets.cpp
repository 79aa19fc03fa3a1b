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
/// Where more than this share of the pairs cross, tests of pairs are not wasted, but smaller
/// buckets are done in parallel; then a split may leave nearly all lines on both sides.
constexpr double kDense = 0.2, kProgressIfDense = 1.9;
constexpr int kDeepest = 60;

/// The x coordinates that a line takes at heights within a range, widened by the margin.
class Band {
 public:
  Band(const Approx& l, double margin)
      : l_(l),
        margin_(margin),
        bottom_(std::min(l.ay, l.by)),
        top_(std::max(l.ay, l.by)),
        slope_((l.bx - l.ax) / (l.by - l.ay)) {}

  std::pair<double, double> between(double low, double high) const {
    if (!(bottom_ < top_)) return {l_.ax - margin_, l_.bx + margin_};
    double x0 = at(low - margin_), x1 = at(high + margin_);
    if (x1 < x0) std::swap(x0, x1);
    // A steep slope magnifies rounding; the line has no other x.
    return {std::clamp(x0, l_.ax, l_.bx) - margin_, std::clamp(x1, l_.ax, l_.bx) + margin_};
  }

 private:
  double at(double y) const { return l_.ax + (std::clamp(y, bottom_, top_) - l_.ay) * slope_; }

  const Approx& l_;
  double margin_, bottom_, top_, slope_;
};

Approx transposed(const Approx& l) {
  return l.ay <= l.by ? Approx{l.ay, l.ax, l.by, l.bx} : Approx{l.by, l.bx, l.ay, l.ax};
}

}  // namespace

std::size_t Buckets::part_at(std::uint32_t node, double x, double y) const {
  while (nodes_[node].kind != Node::Leaf) {
    const double c = nodes_[node].kind == Node::SplitX ? x : y;
    node = nodes_[node].low + (c < nodes_[node].at ? 0 : 1);
  }
  return nodes_[node].low;
}

Box Buckets::cell_box(std::size_t cell) const {
  const double x = extent_.x0 + static_cast<double>(cell % columns_) * column_width_;
  const double y = extent_.y0 + static_cast<double>(cell / columns_) * row_height_;
  return {x, y, x + column_width_, y + row_height_};
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
  per_width_ = 1 / column_width_;
  per_height_ = 1 / row_height_;
}

template <class Visit>
void Buckets::for_cells(const Approx& line, Visit visit) const {
  const auto [bottom, top] = std::minmax(line.ay, line.by);
  const std::size_t first = row(bottom - margin_), last = row(top + margin_);
  const Band band(line, margin_);
  for (std::size_t r = first; r <= last; ++r) {
    const double low = extent_.y0 + static_cast<double>(r) * row_height_;
    const auto [x0, x1] = first == last ? std::pair(line.ax - margin_, line.bx + margin_)
                                        : band.between(low, low + row_height_);
    const std::size_t end = column(x1);
    for (std::size_t c = column(x0); c <= end; ++c) visit(r * columns_ + c);
  }
}

Buckets::Buckets(std::span<const Approx> lines, double margin, Job& job) : margin_(margin) {
  choose_grid(lines);
  fill(lines, job);
  split_full_cells(lines, job);
}

void Buckets::fill(std::span<const Approx> lines, Job& job) {
  constexpr std::size_t kBlock = 1024;
  const std::size_t count = columns_ * rows_;
  std::vector<std::uint32_t>& begin = members_.begin;
  begin.assign(count, 0);
  job.for_each(lines.size(), [&](std::size_t s) {
    for_cells(lines[s], [&](std::size_t c) { job.increment(begin[c]); });
  });
  accumulate(begin);
  members_.items.resize(begin[count]);
  std::vector<std::uint32_t> end(begin.begin(), begin.end() - 1);
  job.for_each(lines.size(), [&](std::size_t s) {
    for_cells(lines[s], [&](std::size_t c) {
      members_.items[job.increment(end[c])] = static_cast<LineId>(s);
    });
  });
  if (!job.is_parallel()) return;
  job.for_blocks(count, kBlock, [&](std::size_t from, std::size_t to) {
    for (std::size_t c = from; c < to; ++c) {
      std::sort(members_.items.begin() + begin[c], members_.items.begin() + begin[c + 1]);
    }
  });
}

/// The lines of a node on both sides of a coordinate.
struct Split {
  bool useful = false, along_x = true;
  double at = 0;
  std::vector<LineId> low, high;
  std::size_t size() const { return low.size() + high.size(); }
};

namespace {

/// Splits along x at the centroid of the parts of the lines inside the box.
template <class Line>
Split split_along_x(const Box& box, const std::vector<LineId>& members, double margin, Line line) {
  std::vector<std::pair<double, double>> ranges;
  ranges.reserve(members.size());
  Split result;
  for (const LineId s : members) {
    const Approx l = line(s);
    ranges.push_back(Band(l, margin).between(box.y0, box.y1));
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

/// What a few pairs of lines say about all of them, as far as doubles can tell.
struct Sample {
  bool pencil = false;  ///< nearly all lines go through one point
  double crossing = 0;  ///< the share of pairs that cross inside the box
};

bool is_pencil(const PointD& p, double tolerance, const std::vector<LineId>& members,
               std::span<const Approx> lines) {
  constexpr std::size_t kProbes = 64;
  constexpr double kNearly = 0.9;
  std::size_t through = 0;
  for (std::size_t k = 0; k < kProbes; ++k) {
    const Approx& l = lines[members[k * members.size() / kProbes]];
    const double dx = l.bx - l.ax, dy = l.by - l.ay;
    const double across = dx * (p.y - l.ay) - dy * (p.x - l.ax);
    if (std::abs(across) <= tolerance * (std::abs(dx) + std::abs(dy))) ++through;
  }
  return static_cast<double>(through) >= kNearly * kProbes;
}

Sample sample(const Box& box, const std::vector<LineId>& members, std::span<const Approx> lines,
              double margin) {
  constexpr std::size_t kPairs = 32;
  constexpr double kSlack = 16;
  Sample result;
  PointD best{};
  double best_sine = 0;
  for (std::size_t k = 0; k < kPairs; ++k) {
    const Approx& l = lines[members[k * members.size() / (2 * kPairs)]];
    const Approx& m = lines[members[(k * 7 % kPairs + kPairs) * members.size() / (2 * kPairs)]];
    const double dx = l.bx - l.ax, dy = l.by - l.ay, ex = m.bx - m.ax, ey = m.by - m.ay;
    const double turn = dx * ey - dy * ex;
    const double sine = std::abs(turn) / std::sqrt((dx * dx + dy * dy) * (ex * ex + ey * ey));
    if (!(sine > 0)) continue;
    const double t = ((m.ax - l.ax) * ey - (m.ay - l.ay) * ex) / turn;
    const double u = ((m.ax - l.ax) * dy - (m.ay - l.ay) * dx) / turn;
    const PointD p{l.ax + t * dx, l.ay + t * dy};
    if (t >= 0 && t <= 1 && u >= 0 && u <= 1 && box.x0 <= p.x && p.x <= box.x1 && box.y0 <= p.y &&
        p.y <= box.y1) {
      result.crossing += 1.0 / kPairs;
    }
    if (sine > best_sine) {
      best_sine = sine;
      best = p;
    }
  }
  result.pencil = best_sine > 0 && is_pencil(best, kSlack * margin / best_sine, members, lines);
  return result;
}

Split split(const Box& box, const std::vector<LineId>& members, std::span<const Approx> lines,
            double margin) {
  if (members.size() <= kFull) return {};
  // A pencil is searched best as a whole (pencils.hpp).
  const Sample pairs = sample(box, members, lines, margin);
  if (pairs.pencil) return {};
  Split best = split_along_x(box, members, margin, [&](LineId s) { return lines[s]; });
  const Box turned{box.y0, box.x0, box.y1, box.x1};
  Split other =
      split_along_x(turned, members, margin, [&](LineId s) { return transposed(lines[s]); });
  if (other.size() < best.size()) {
    best = std::move(other);
    best.along_x = false;
  }
  const double low = best.along_x ? box.x0 : box.y0, high = best.along_x ? box.x1 : box.y1;
  best.useful =
      low < best.at && best.at < high &&
      static_cast<double>(best.size()) < (pairs.crossing > kDense ? kProgressIfDense : kProgress) *
                                             static_cast<double>(members.size());
  return best;
}

}  // namespace

/// Level by level, so that the nodes of a level are split in parallel and numbered in order.
void Buckets::split_full_cells(std::span<const Approx> lines, Job& job) {
  const std::size_t cells = members_.size();
  cell_node_.assign(cells, kNone);
  std::vector<Open> level, next;
  for (std::size_t c = 0; c < cells; ++c) {
    const std::span<const LineId> here = members_[c];
    if (here.size() <= kFull) continue;
    cell_node_[c] = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({});
    level.push_back({cell_node_[c], cell_box(c), {here.begin(), here.end()}});
  }
  for (int depth = 0; !level.empty(); ++depth) {
    std::vector<Split> splits(level.size());
    job.for_blocks(level.size(), 1, [&](std::size_t i, std::size_t) {
      if (depth < kDeepest) splits[i] = split(level[i].box, level[i].members, lines, margin_);
    });
    for (std::size_t i = 0; i < level.size(); ++i) settle(level[i], splits[i], next);
    level = std::exchange(next, {});
  }
}

void Buckets::settle(Open& open, Split& split, std::vector<Open>& next) {
  if (!split.useful) {
    nodes_[open.node] = {0, static_cast<std::uint32_t>(size()), Node::Leaf};
    part_boxes_.push_back(open.box);
    parts_.items.insert(parts_.items.end(), open.members.begin(), open.members.end());
    parts_.begin.push_back(static_cast<std::uint32_t>(parts_.items.size()));
    return;
  }
  const auto child = static_cast<std::uint32_t>(nodes_.size());
  nodes_[open.node] = {split.at, child, split.along_x ? Node::SplitX : Node::SplitY};
  nodes_.resize(nodes_.size() + 2);
  Box low = open.box, high = open.box;
  (split.along_x ? low.x1 : low.y1) = split.at;
  (split.along_x ? high.x0 : high.y0) = split.at;
  next.push_back({child, low, std::move(split.low)});
  next.push_back({child + 1, high, std::move(split.high)});
}

}  // namespace plumbline::bucket
