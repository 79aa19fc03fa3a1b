// Coverages for a terminal.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "output/text/terminal.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output/polygons.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kFaultsListed = 5;
constexpr std::array kKinds{CoverageFaultKind::Overlap, CoverageFaultKind::Gap,
                            CoverageFaultKind::UnmatchedVertex};

std::string plural(CoverageFaultKind kind, std::size_t count) {
  if (kind == CoverageFaultKind::UnmatchedVertex && count != 1) {
    return fmt::format("{} unmatched vertices", count);
  }
  return counted(count, to_text(kind));
}

/// "parcels.geojson:3:1 Polygon #12".
std::string name_of(const Coverage& coverage, RegionId r, const SegmentSet& input) {
  return line_text(source_text(coverage.polygons[r], input));
}

std::string names_of(const Coverage& coverage, const std::vector<RegionId>& polygons,
                     const SegmentSet& input) {
  constexpr std::size_t kNames = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(polygons.size(), kNames); ++i) {
    text += (i > 0 ? ", " : "") + name_of(coverage, polygons[i], input);
  }
  if (polygons.size() > kNames) text += fmt::format(" and {} more", polygons.size() - kNames);
  return text;
}

/// "area 2, width 1, at (2.5, 1)".
std::string size_of(const CoverageFault& fault) {
  constexpr double kLeast = 1e-9;  // of a width that is rounded to 0
  return fmt::format("area {}, width {}, at {}", short_number(nearest_double(fault.area)),
                     short_number(fault.width),
                     place_text(fault.at, std::max(fault.width, kLeast)));
}

std::string line_of(const Coverage& coverage, const CoverageFault& fault, const SegmentSet& input) {
  if (fault.kind != CoverageFaultKind::UnmatchedVertex) {
    return fmt::format("  {}: {}\n", size_of(fault), names_of(coverage, fault.polygons, input));
  }
  constexpr double kFine = 1e-9;
  const std::vector<RegionId> with(fault.polygons.begin() + 1, fault.polygons.end());
  return fmt::format("  at {}: a corner of {}, none of {}\n", place_text(fault.at, kFine),
                     names_of(coverage, with, input),
                     name_of(coverage, fault.polygons.front(), input));
}

/// Those of one kind, the largest first.
std::vector<const CoverageFault*> of_kind(const std::vector<CoverageFault>& faults,
                                          CoverageFaultKind kind) {
  std::vector<const CoverageFault*> result;
  for (const CoverageFault& fault : faults) {
    if (fault.kind == kind) result.push_back(&fault);
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const auto* a, const auto* b) { return a->area > b->area; });
  return result;
}

std::string kind_text(const Coverage& coverage, const std::vector<const CoverageFault*>& faults,
                      const SegmentSet& input, std::size_t listed) {
  if (faults.empty()) return "";
  const CoverageFaultKind kind = faults.front()->kind;
  std::string text = plural(kind, faults.size());
  if (kind != CoverageFaultKind::UnmatchedVertex) {
    Rational area = 0;
    double width = 0;
    for (const CoverageFault* fault : faults) {
      area += fault->area;
      width = std::max(width, fault->width);
    }
    text += fmt::format(", area {} in all, at most {} wide", short_number(nearest_double(area)),
                        short_number(width));
  }
  text += '\n';
  for (std::size_t i = 0; i < std::min(faults.size(), listed); ++i) {
    text += line_of(coverage, *faults[i], input);
  }
  if (faults.size() > listed) {
    text += fmt::format("  ... {} more (--list N)\n", faults.size() - listed);
  }
  return text;
}

}  // namespace

std::string to_text(const Coverage& coverage, const std::vector<CoverageFault>& faults,
                    const CleanOptions& options, const SegmentSet& input,
                    std::optional<std::size_t> listed) {
  std::vector<CoverageFault> found;
  std::array<std::size_t, kKinds.size()> beyond{};
  for (const CoverageFault& fault : faults) {
    if (is_within(fault, options)) {
      found.push_back(fault);
    } else {
      ++beyond.at(static_cast<std::size_t>(fault.kind));
    }
  }
  const std::string polygons = counted(coverage.polygons.size(), "polygon");
  std::string text, details;
  for (const CoverageFaultKind kind : kKinds) {
    const auto of = of_kind(found, kind);
    if (!of.empty()) text += (text.empty() ? "" : ", ") + plural(kind, of.size());
    details += kind_text(coverage, of, input, listed.value_or(kFaultsListed));
  }
  text = text.empty()
             ? fmt::format("valid: {} without overlaps, gaps and unmatched vertices\n", polygons)
             : fmt::format("invalid: {} in {}\n", text, polygons);
  for (const CoverageFaultKind kind : kKinds) {
    const std::size_t count = beyond.at(static_cast<std::size_t>(kind));
    if (count > 0) text += fmt::format("beyond the limits: {}\n", plural(kind, count));
  }
  return text + details;
}

std::string to_text(const CleanCoverage& clean, const std::vector<CoverageFault>& faults,
                    const SegmentSet& input, std::optional<std::size_t> listed) {
  std::array<std::size_t, kKinds.size()> given{}, all{};
  for (const Reassigned& change : clean.changes) {
    ++given.at(static_cast<std::size_t>(change.fault.kind));
  }
  for (const CoverageFault& fault : faults) ++all.at(static_cast<std::size_t>(fault.kind));
  std::string text;
  const auto add_line = [&](const std::string& what, const std::array<std::size_t, 3>& counts) {
    std::string line;
    for (const CoverageFaultKind kind : kKinds) {
      const std::size_t count = counts.at(static_cast<std::size_t>(kind));
      if (count > 0) line += (line.empty() ? "" : ", ") + plural(kind, count);
    }
    if (!line.empty()) text += what + line + '\n';
  };
  add_line("given to one polygon each: ", {given[0], given[1], 0});
  add_line("matched: ", {0, 0, all[2]});
  add_line("left, beyond the limits: ", {all[0] - given[0], all[1] - given[1], 0});
  if (text.empty()) text = "clean: nothing is changed\n";
  std::vector<const Reassigned*> order;
  for (const Reassigned& change : clean.changes) order.push_back(&change);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto* a, const auto* b) { return a->fault.area > b->fault.area; });
  constexpr std::size_t kChanges = 12;
  const std::size_t shown = std::min(order.size(), listed.value_or(kChanges));
  for (std::size_t i = 0; i < shown; ++i) {
    const CoverageFault& fault = order[i]->fault;
    std::vector<RegionId> others = fault.polygons;
    std::erase(others, order[i]->to);
    text += fmt::format("  {} to {}: {}", to_text(fault.kind),
                        name_of(clean.coverage, order[i]->to, input), size_of(fault));
    if (!others.empty()) text += ", not to " + names_of(clean.coverage, others, input);
    text += '\n';
  }
  if (order.size() > shown) text += fmt::format("  ... {} more (--list N)\n", order.size() - shown);
  if (!clean.vanished.empty()) {
    text += fmt::format("nothing is left of {}: {} (--policy smallest keeps what lies in others)\n",
                        counted(clean.vanished.size(), "polygon"),
                        names_of(clean.coverage, clean.vanished, input));
  }
  return text;
}

}  // namespace plumbline
