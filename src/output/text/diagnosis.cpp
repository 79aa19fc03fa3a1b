// The diagnosis for a terminal: a screen, then lists as they are asked for.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "output/text/terminal.hpp"
#include "output/text/verdict.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kWorst = 6;          // defects on the first screen
constexpr std::size_t kWorstOfKind = 3;    // of them
constexpr std::size_t kShownOpenings = 3;  // places of them
constexpr std::size_t kShownTolerances = 3;

/// "  12 gaps, 1 sliver, ...": what there is, in lines that a terminal does not break.
std::string counts_lines(const Diagnosis& diagnosis) {
  constexpr std::size_t kWidth = 100;
  std::string text, line;
  for (std::size_t kind = 0; kind < kDefectKinds; ++kind) {
    if (diagnosis.found[kind] == 0) continue;
    std::string name = to_text(static_cast<DefectKind>(kind));
    if (diagnosis.found[kind] > 1) name += name.ends_with("s") ? "es" : "s";
    if (name == "nearly parallels") name = "nearly parallel pairs";
    const std::string item = fmt::format("{} {}", diagnosis.found[kind], name);
    if (!line.empty() && line.size() + item.size() > kWidth) {
      text += line + ",\n";
      line.clear();
    }
    line += (line.empty() ? "  " : ", ") + item;
  }
  return line.empty() ? text : text + line + '\n';
}

std::string defect_line(const Diagnosis& diagnosis, std::size_t i) {
  const Defect& defect = diagnosis.defects[i];
  return fmt::format("{:>6}. at {}: {}\n", i + 1,
                     place_text(defect.where, nearest_double(diagnosis.within)),
                     line_text(defect.message));
}

/// Two sources, and how many more there are; of files their names alone.
std::string source_line(const SegmentSet& input, const Defect& defect) {
  constexpr std::size_t kShown = 2;
  const std::vector<SourceId> sources = sources_of(input, defect.segments);
  if (sources.empty()) return {};
  std::vector<std::string> names;
  for (const std::string& file : input.files) names.push_back(file.substr(file.rfind('/') + 1));
  std::string text;
  for (std::size_t i = 0; i < std::min(sources.size(), kShown); ++i) {
    text += (i == 0 ? "        " : "; ") + line_text(to_text(input.sources[sources[i]], names));
  }
  if (sources.size() > kShown) text += fmt::format("; and {} more", sources.size() - kShown);
  return text + '\n';
}

/// Those that matter most, some of each kind.
void append_worst(std::string& text, const SegmentSet& input, const Diagnosis& diagnosis) {
  if (diagnosis.defects.empty()) return;
  text += "what matters most\n";
  std::array<std::size_t, kDefectKinds> shown_of_kind{};
  std::size_t shown = 0;
  for (const std::size_t i : by_effect(diagnosis)) {
    std::size_t& of_kind = shown_of_kind[static_cast<std::size_t>(diagnosis.defects[i].kind)];
    if (of_kind == kWorstOfKind) continue;
    ++of_kind;
    text += defect_line(diagnosis, i) + source_line(input, diagnosis.defects[i]);
    if (++shown == kWorst) return;
  }
}

void append_openings(std::string& text, const Diagnosis& diagnosis) {
  if (diagnosis.openings.empty()) return;
  text += fmt::format(
      "{} as wide as a door, which {} no defect:", counted(diagnosis.openings.size(), "opening"),
      diagnosis.openings.size() == 1 ? "is" : "are");
  const std::size_t shown = std::min(diagnosis.openings.size(), kShownOpenings);
  for (std::size_t i = 0; i < shown; ++i) {
    const Opening& opening = diagnosis.openings[i];
    text += fmt::format("{} {} at {}", i == 0 ? "" : ",", short_number(opening.width),
                        place_text(opening.where, nearest_double(diagnosis.within)));
  }
  text += shown < diagnosis.openings.size() ? ", ...\n" : "\n";
}

/// The last of those that spare all detail, and the least that do not.
void append_tolerances(std::string& text, const Diagnosis& diagnosis) {
  const std::vector<ToleranceEffect>& all = diagnosis.tolerances;
  if (all.empty()) return;
  text += fmt::format("  joining within  mends, of {} that joining can mend\n",
                      counted(all.back().mended, "defect"));
  const auto spares = [](const ToleranceEffect& effect) { return effect.spares_detail; };
  const auto end_of_sparing = std::partition_point(all.begin(), all.end(), spares) - all.begin();
  const std::size_t end = std::min(
      all.size(), std::max(kShownTolerances, static_cast<std::size_t>(end_of_sparing) + 1));
  for (std::size_t i = end - std::min(end, kShownTolerances); i < end; ++i) {
    text += fmt::format("  {:<14}{:>7}{}\n", short_number(all[i].tolerance), all[i].mended,
                        all[i].spares_detail ? "" : "  and destroys edges that are no defects");
  }
  if (diagnosis.squared_detail) {
    text += fmt::format("the shortest edge that is part of no defect is {} long\n",
                        short_number(nearest_sqrt(*diagnosis.squared_detail)));
  }
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
      if (shown == limit) continue;
      text += defect_line(diagnosis, i) + input_lines(input, all[i].segments, "        ");
      ++shown;
    }
    if (shown < found) text += fmt::format("      ... and {} more\n", found - shown);
  }
}

}  // namespace

std::string to_text(const Diagnosis& diagnosis, const SegmentSet& input, std::size_t limit) {
  std::size_t total = 0;
  for (const std::size_t found : diagnosis.found) total += found;
  std::string text = fmt::format("{}; near means within {}; {}\n", counted(total, "defect"),
                                 short_number(nearest_double(diagnosis.within)),
                                 counted(diagnosis.tips, "loose end"));
  text += counts_lines(diagnosis);
  if (diagnosis.cut_short > 0) {
    text += fmt::format(
        "the distance is too large for this drawing: around {} vertices so much is near "
        "that defects can be missing\n",
        diagnosis.cut_short);
  }
  append_worst(text, input, diagnosis);
  append_openings(text, diagnosis);
  append_tolerances(text, diagnosis);
  if (limit > 0) append_defects(text, input, diagnosis, limit);
  return text;
}

}  // namespace plumbline
