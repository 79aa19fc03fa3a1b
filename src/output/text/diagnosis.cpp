// The diagnosis for a terminal.

#include <fmt/format.h>

#include <algorithm>

#include "output/text/terminal.hpp"
#include "output/text/verdict.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

void append_defect_counts(std::string& text, const Diagnosis& diagnosis) {
  for (std::size_t kind = 0; kind < kDefectKinds; ++kind) {
    text += fmt::format("  {:<16}{:>8}\n", to_text(static_cast<DefectKind>(kind)),
                        diagnosis.found[kind]);
  }
}

void append_defect(std::string& text, const SegmentSet& input, const Defect& defect,
                   std::size_t defect_number, double within) {
  text += fmt::format("{:>6}. at {}: {}\n", defect_number, place_text(defect.where, within),
                      line_text(defect.message));
  text += input_lines(input, defect.segments, "        ");
}

void append_defects(std::string& text, const SegmentSet& input, const Diagnosis& diagnosis,
                    std::size_t limit) {
  const std::vector<Defect>& all = diagnosis.defects;
  for (std::size_t i = 0; i < all.size();) {
    const DefectKind kind = all[i].kind;
    const std::size_t found = diagnosis.count(kind);
    text += fmt::format("\n{}: {}\n", to_text(kind), found);
    std::size_t shown = 0;
    for (; i < all.size() && all[i].kind == kind; ++i) {
      if (shown < limit) {
        append_defect(text, input, all[i], i + 1, nearest_double(diagnosis.within));
        ++shown;
      }
    }
    if (shown < found) text += fmt::format("      ... and {} more\n", found - shown);
  }
}

void append_tolerances(std::string& text, const Diagnosis& diagnosis) {
  if (diagnosis.tolerances.empty()) return;
  text += fmt::format("\na tolerance of  mends of {} defects that one can mend\n",
                      diagnosis.tolerances.back().mended);
  for (const ToleranceEffect& effect : diagnosis.tolerances) {
    text += fmt::format("  {:<12}{:>8}{}\n", short_number(effect.tolerance), effect.mended,
                        effect.spares_detail ? "" : "  and destroys edges that are no defects");
  }
  if (diagnosis.squared_detail) {
    text += fmt::format("the shortest edge that is part of no defect is {} long\n",
                        short_number(nearest_sqrt(*diagnosis.squared_detail)));
  }
}

}  // namespace

std::string to_text(const Diagnosis& diagnosis, const SegmentSet& input, std::size_t limit) {
  std::size_t total = 0;
  for (const std::size_t found : diagnosis.found) total += found;
  std::string text = fmt::format("{} defects; near means within {}; {} loose ends\n", total,
                                 short_number(nearest_double(diagnosis.within)), diagnosis.tips);
  append_defect_counts(text, diagnosis);
  if (diagnosis.cut_short > 0) {
    text += fmt::format(
        "the distance is too large for this drawing: around {} vertices so much is near "
        "that defects can be missing\n",
        diagnosis.cut_short);
  }
  append_defects(text, input, diagnosis, limit);
  append_tolerances(text, diagnosis);
  return text;
}

}  // namespace plumbline
