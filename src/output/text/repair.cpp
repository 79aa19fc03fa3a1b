// A repair for a terminal: what was done, where, how far, and to which rooms.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "output/text/edits.hpp"
#include "output/text/terminal.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kShownEdits = 16;   // on a screen
constexpr std::size_t kShownRefused = 4;  // with a line for a reason each
constexpr std::size_t kShownReasons = 6;
constexpr std::size_t kFacesOfRow = 2, kFacesOfList = 20;

/// What edits of a kind do, in words: one thing, what is done to it, how far.
struct KindWords {
  const char* thing;
  const char* things;
  const char* done;  ///< {} is "up to 0.02", or what the only one has
};
constexpr std::array<KindWords, kEditKinds> kWords{{
    {"overlap", "overlaps", "merged"},
    {"needless vertex", "needless vertices", "dissolved"},
    {"end", "ends", "grown by {}"},
    {"gap", "gaps", "of {} bridged"},
    {"gap", "gaps", "of {} joined"},
    {"door", "doors", "of {} closed"},
    {"dangle", "dangles", "of {} trimmed"},
    {"sliver", "slivers", "of {} removed"},
    {"line", "lines", "welded by {}"},
    {"vertex", "vertices", "snapped by {}"},
    {"vertex", "vertices", "left out, moving lines by {}"},
}};

std::string size_text(const Rational& squared) { return short_number(nearest_sqrt(squared)); }

/// "3 ends grown by up to 0.02"; "" where there are none.
std::string kind_text(const Repair& repair, std::size_t kind) {
  std::size_t count = 0;
  Rational largest;
  for (const Edit& edit : repair.edits) {
    if (static_cast<std::size_t>(edit.kind) != kind) continue;
    ++count;
    largest = std::max(largest, edit.squared_size);
  }
  if (count == 0) return {};
  const KindWords& words = kWords.at(kind);
  return fmt::format("{} {} ", count, count == 1 ? words.thing : words.things) +
         fmt::format(fmt::runtime(words.done), (count == 1 ? "" : "up to ") + size_text(largest));
}

/// "1 room closed, 2 split": those before that are split, each once.
std::string faces_text(const Repair& repair) {
  std::array<std::size_t, 5> counts{};
  std::set<FaceId> split;
  for (const FaceOutcome& outcome : repair.faces) {
    if (outcome.fate == FaceFate::Split && !split.insert(outcome.before).second) continue;
    ++counts.at(static_cast<std::size_t>(outcome.fate));
  }
  std::string text;
  for (std::size_t fate = 0; fate < counts.size(); ++fate) {
    if (counts[fate] == 0) continue;
    const std::string number =
        text.empty() ? counted(counts[fate], "room") : std::to_string(counts[fate]);
    text += (text.empty() ? "" : ", ") + number + ' ' + to_text(static_cast<FaceFate>(fate));
  }
  return text.empty() ? "no room changed" : text;
}

/// A row of one of the tables.
struct Row {
  std::string number, kind, size, where, what, element;
};

/// Whole, or so that it fits on a line.
std::string row_text(const Row& row, bool is_whole) {
  constexpr std::size_t kWhat = 27, kElement = 25;
  return fmt::format("{:>4}  {:<8}  {:>9}  {:<18}  {:<27}  {}\n", row.number, row.kind, row.size,
                     row.where, is_whole ? row.what : cut(row.what, kWhat),
                     is_whole ? row.element : cut(row.element, kElement));
}

void append_edits(std::string& text, const Repair& repair, const SegmentSet& input,
                  std::optional<std::size_t> listed) {
  const std::size_t shown = std::min(listed.value_or(kShownEdits), repair.edits.size());
  if (shown == 0) return;
  const std::vector<std::string> rooms = room_texts(repair, listed ? kFacesOfList : kFacesOfRow);
  text += row_text({"edit", "what", "how far", "where", "rooms", "element"}, true);
  const std::vector<std::size_t> order = most_effective_first(repair);
  for (std::size_t i = 0; i < shown; ++i) {
    const std::size_t e = order[i];
    const Edit& edit = repair.edits[e];
    text += row_text({std::to_string(e + 1), to_text(edit.kind), size_text(edit.squared_size),
                      place_text_of(edit.where, edit.squared_size), rooms[e],
                      element_text(input, segments_of(edit))},
                     listed.has_value());
  }
  if (shown < repair.edits.size()) {
    text += fmt::format("      ... and {} more (--list N, --log, --findings)\n",
                        repair.edits.size() - shown);
  }
}

/// Each reason once, above those that it is said of.
void append_refused(std::string& text, const Repair& repair, const SegmentSet& input,
                    std::optional<std::size_t> listed) {
  const std::size_t shown =
      std::min(std::max(listed.value_or(0), kShownRefused), repair.refused.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const Refusal& refusal = repair.refused[i];
    if (i == 0 || refusal.reason != repair.refused[i - 1].reason) {
      text += "refused: " + line_text(refusal.reason) + '\n';
    }
    text += row_text({"", to_text(refusal.kind), size_text(refusal.squared_size),
                      place_text_of(refusal.where, refusal.squared_size), "",
                      element_text(input, refusal.segments)},
                     listed.has_value());
  }
  if (shown < repair.refused.size()) {
    text += fmt::format("      ... and {} more\n", repair.refused.size() - shown);
  }
}

}  // namespace

std::string repair_line(const Repair& repair) {
  std::string text =
      repair.edits.empty() ? "no edits" : counted(repair.edits.size(), "edit") + ": ";
  bool is_first = true;
  for (std::size_t kind = 0; kind < kEditKinds; ++kind) {
    const std::string words = kind_text(repair, kind);
    if (words.empty()) continue;
    text += (is_first ? "" : ", ") + words;
    is_first = false;
  }
  if (!repair.edits.empty()) text += "; " + faces_text(repair);
  if (!repair.refused.empty()) text += fmt::format("; {} refused", repair.refused.size());
  return text;
}

std::string to_text(const Repair& repair, const SegmentSet& input,
                    std::optional<std::size_t> listed) {
  std::string text = repair_line(repair) + "\ntolerances: " + to_text(repair.tolerances) + '\n';
  const std::size_t reasons = std::min(repair.reasons.size(), kShownReasons);
  for (std::size_t i = 0; i < reasons; ++i) text += "  " + line_text(repair.reasons[i]) + '\n';
  if (!repair.anchored.empty()) {
    text += counted(repair.anchored.size(), "segment") + " anchored\n";
  }
  append_edits(text, repair, input, listed);
  append_refused(text, repair, input, listed);
  return text;
}

}  // namespace plumbline
