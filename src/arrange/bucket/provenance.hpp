#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "arrange/bucket/types.hpp"

namespace plumbline::bucket {

/// The input item that covers a carrier from its break `from` to its break `to`; break 0 is the
/// carrier's first end.
struct Part {
  std::uint32_t item, from, to;
  std::uint32_t reach = 0;  ///< the greatest `to` up to here, once placed
};

/// Lines that stand for several input items each.
struct Carriers {
  std::vector<LineId> line;
  Grouped<Part> parts;     ///< per carrier, by `from`
  Grouped<LineId> breaks;  ///< per carrier, in order: points at the ends of parts, its own ends not
};

/// What each line stands for.
struct Provenance {
  std::vector<std::uint32_t> item;  ///< per line: the input item; or carrier c as `item_count` + c
  std::uint32_t item_count = 0;
  Carriers carriers;

  /// Turns breaks into positions along the chains of vertices of the carriers.
  void place(const Grouped<std::uint32_t>& chains);

  /// Calls visit(item) for the items that cover the edge at a position of a line. Requires: `place`
  /// was called. Cost: the parts that begin after one that goes on to here.
  template <class Visit>
  void for_items(LineId line, std::size_t position, Visit visit) const {
    if (item[line] < item_count) {
      visit(item[line]);
      return;
    }
    const auto parts = carriers.parts[item[line] - item_count];
    auto part = std::partition_point(parts.begin(), parts.end(),
                                     [&](const Part& p) { return p.from <= position; });
    while (part != parts.begin() && (part - 1)->reach > position) {
      --part;
      if (part->to > position) visit(part->item);
    }
  }
};

}  // namespace plumbline::bucket
