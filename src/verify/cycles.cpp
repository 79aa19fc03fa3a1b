// Step 4: the cycles are those that the sweep's rotations around the vertices make, in their order.

#include <string>

#include "refusal.hpp"
#include "steps.hpp"

namespace plumbline_verify {
namespace {

std::string halfedge(Index h) { return (h % 2 == 0 ? "+" : "-") + std::to_string(h / 2); }

}  // namespace

std::vector<Index> check_cycles(const Certificate& certificate, const std::vector<Index>& next) {
  const Lists& cycles = certificate.cycles;
  std::vector<Index> cycle_of(next.size(), kNone);
  const auto refuse = [&](Index cycle, Index at, const std::string& problem) {
    const Edge& edge = certificate.edges[at / 2];
    throw Refusal{"cycle " + std::to_string(cycle) + " " + problem, certificate.cycle_line + cycle,
                  text_of(certificate.vertices[at % 2 == 0 ? edge.head : edge.tail])};
  };
  Index least = 0;  // halfedge that is in no cycle yet
  for (Index c = 0; c < cycles.size(); ++c) {
    while (least < next.size() && cycle_of[least] != kNone) ++least;
    const Index* h = cycles.begin(c);
    if (*h != least) {
      refuse(c, *h,
             "starts with " + halfedge(*h) +
                 (least < next.size()
                      ? ", not with the least halfedge that is left, " + halfedge(least)
                      : ", but no halfedge is left"));
    }
    for (; h != cycles.end(c); ++h) {
      if (cycle_of[*h] != kNone) refuse(c, *h, "passes " + halfedge(*h) + " again");
      cycle_of[*h] = c;
      const bool is_last = h + 1 == cycles.end(c);
      const Index after = is_last ? least : h[1];
      if (next[*h] == after) continue;
      refuse(c, *h,
             (is_last ? "ends with " + halfedge(*h) + ", but after that"
                      : "has " + halfedge(after) + " after " + halfedge(*h) + ", where") +
                 " comes " + halfedge(next[*h]));
    }
  }
  while (least < next.size() && cycle_of[least] != kNone) ++least;
  if (least < next.size()) {
    throw Refusal{"halfedge " + halfedge(least) + " is in no cycle",
                  certificate.cycle_line + cycles.size(),
                  text_of(certificate.vertices[certificate.edges[least / 2].tail])};
  }
  return cycle_of;
}

}  // namespace plumbline_verify
