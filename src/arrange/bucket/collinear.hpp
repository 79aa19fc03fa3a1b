#pragma once

// Step 1: segments that overlap on one line become one line ("carrier") with the ends of its parts
// as points on it, so that no two lines share more than a point. Equal segments are a special case.

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "arrange/bucket/job.hpp"
#include "arrange/bucket/provenance.hpp"

namespace plumbline::bucket {

/// Lines by number before they are sorted: those kept, with the carriers and breaks among them.
struct Merged {
  std::vector<LineId> kept;
  Carriers carriers;
};

template <class Kernel>
class CollinearMerge {
 public:
  CollinearMerge(Kernel& kernel, Job& job)
      : kernel_(kernel), job_(job), dropped_(kernel.size(), 0) {}

  Merged merge() {
    const std::vector<Suspect> suspects = find_suspects();
    for (std::size_t i = 0; i < suspects.size();) {
      std::vector<LineId> group;
      const std::uint64_t key = suspects[i].first;
      for (; i < suspects.size() && suspects[i].first == key; ++i) {
        group.push_back(suspects[i].second);
      }
      while (group.size() > 1) group = merge_with_first(group);
    }
    make_break_points();
    Merged merged;
    for (LineId s = 0; s < kernel_.size(); ++s) {
      if (s >= dropped_.size() || dropped_[s] == 0) merged.kept.push_back(s);
    }
    merged.carriers = std::move(carriers_);
    return merged;
  }

 private:
  using Suspect = std::pair<std::uint64_t, LineId>;

  /// Lines whose key is not the only one in its slot of a table, sorted by key.
  std::vector<Suspect> find_suspects() {
    constexpr std::size_t kBlock = 1024;
    const std::size_t n = kernel_.size();
    std::vector<std::uint64_t> keys(n);
    std::uint32_t bits = 4;
    while ((std::size_t{1} << bits) < 8 * n) ++bits;
    std::vector<std::uint8_t> count(std::size_t{1} << bits, 0);
    job_.for_blocks(n, kBlock, [&](std::size_t begin, std::size_t end) {
      kernel_.keys(begin, end, keys.data() + begin);
      for (std::size_t s = begin; s < end; ++s) {
        // None, one, many.
        std::atomic_ref slot(count[keys[s] >> (64 - bits)]);
        const std::uint8_t seen = slot.load(std::memory_order_relaxed);
        if (seen == 2) continue;
        // Of all that see none, only the first leaves it at one.
        if (seen == 1 || slot.exchange(1, std::memory_order_relaxed) != 0) {
          slot.store(2, std::memory_order_relaxed);
        }
      }
    });
    std::vector<Suspect> suspects;
    for (std::size_t s = 0; s < n; ++s) {
      if (count[keys[s] >> (64 - bits)] > 1) suspects.emplace_back(keys[s], static_cast<LineId>(s));
    }
    job_.sort(suspects, std::less<>());
    return suspects;
  }

  /// Merges those that lie on the supporting line of the first; returns the others.
  std::vector<LineId> merge_with_first(const std::vector<LineId>& group) {
    const LineId f = group.front();
    const bool point = kernel_.is_point(f);
    std::vector<LineId> same, others;
    for (const LineId s : group) {
      const bool on =
          kernel_.is_point(s) == point &&
          (point ? kernel_.compare(first_end(s), first_end(f)) == 0
                 : kernel_.side(f, first_end(s)) == 0 && kernel_.side(f, last_end(s)) == 0);
      (on ? same : others).push_back(s);
    }
    if (point) {
      for (const LineId s : same) dropped_[s] = s == f ? 0 : 1;
    } else {
      merge_overlapping(same);
    }
    return others;
  }

  void merge_overlapping(std::vector<LineId>& lines) {
    std::sort(lines.begin(), lines.end(), [&](LineId s, LineId o) {
      const int c = kernel_.compare(first_end(s), first_end(o));
      return c != 0 ? c < 0 : s < o;
    });
    for (std::size_t i = 0; i < lines.size();) {
      EndId reach = last_end(lines[i]);
      std::size_t j = i + 1;
      for (; j < lines.size() && kernel_.compare(first_end(lines[j]), reach) < 0; ++j) {
        if (kernel_.compare(last_end(lines[j]), reach) > 0) reach = last_end(lines[j]);
      }
      if (j - i > 1) add_carrier({lines.data() + i, j - i}, reach);
      i = j;
    }
  }

  void add_carrier(std::span<const LineId> lines, EndId reach) {
    const EndId start = first_end(lines.front());
    const auto less = [&](EndId p, EndId q) { return kernel_.compare(p, q) < 0; };
    std::vector<EndId> breaks;
    for (const LineId s : lines) {
      if (less(start, first_end(s))) breaks.push_back(first_end(s));
      if (less(last_end(s), reach)) breaks.push_back(last_end(s));
    }
    std::sort(breaks.begin(), breaks.end(), less);
    breaks.erase(std::unique(breaks.begin(), breaks.end(),
                             [&](EndId p, EndId q) { return kernel_.compare(p, q) == 0; }),
                 breaks.end());
    const auto last = static_cast<std::uint32_t>(breaks.size() + 1);
    LineId whole = kNone;
    for (const LineId s : lines) {
      Part part{s, 0, last};
      if (less(start, first_end(s))) part.from = number_of(first_end(s), breaks);
      if (less(last_end(s), reach)) part.to = number_of(last_end(s), breaks);
      carriers_.parts.items.push_back(part);
      if (part.from == 0 && part.to == last && whole == kNone) whole = s;
      dropped_[s] = 1;
    }
    if (whole == kNone) {
      whole = kernel_.join(start, reach);
    } else {
      dropped_[whole] = 0;
    }
    carriers_.parts.begin.push_back(static_cast<std::uint32_t>(carriers_.parts.items.size()));
    carriers_.line.push_back(whole);
    carriers_.breaks.items.insert(carriers_.breaks.items.end(), breaks.begin(), breaks.end());
    carriers_.breaks.begin.push_back(static_cast<std::uint32_t>(carriers_.breaks.items.size()));
  }

  std::uint32_t number_of(EndId end, const std::vector<EndId>& breaks) const {
    const auto at = std::lower_bound(breaks.begin(), breaks.end(), end,
                                     [&](EndId p, EndId q) { return kernel_.compare(p, q) < 0; });
    return static_cast<std::uint32_t>(at - breaks.begin() + 1);
  }

  /// Replaces the ends in `breaks` by points, one for all ends at the same place.
  void make_break_points() {
    std::vector<std::uint32_t> order(carriers_.breaks.items.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
    auto& ends = carriers_.breaks.items;
    job_.sort(order, [&](std::uint32_t i, std::uint32_t j) {
      const int c = kernel_.compare(ends[i], ends[j]);
      return c != 0 ? c < 0 : i < j;
    });
    EndId before = kNone;
    LineId point = kNone;
    for (const std::uint32_t i : order) {
      const EndId end = ends[i];
      if (before == kNone || kernel_.compare(before, end) != 0) point = kernel_.join(end, end);
      before = end;
      ends[i] = point;
    }
  }

  Kernel& kernel_;
  Job& job_;
  std::vector<std::uint8_t> dropped_;
  Carriers carriers_;
};

}  // namespace plumbline::bucket
