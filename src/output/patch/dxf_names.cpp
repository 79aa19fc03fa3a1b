#include "output/patch/dxf_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "plumbline/edits.hpp"

namespace plumbline::patch {
namespace {

constexpr int kName = 2, kHandle = 5, kOwner = 330, kSubclass = 100, kStyleHandle = 105;

bool is_same_name(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [lower](char x, char y) { return lower(x) == lower(y); });
}

void note_handles(const DxfText& file, DxfNames& names) {
  bool is_seed = false;
  std::uint64_t greatest = 0;
  for (const DxfGroup& group : file.groups) {
    if (group.code == kSubclass) names.is_modern = true;
    if (group.code == kHandle || group.code == kStyleHandle) {
      std::uint64_t value = 0;
      const char* end = group.value.data() + group.value.size();
      const auto [last, error] = std::from_chars(group.value.data(), end, value, 16);
      if (error == std::errc() && last == end) {
        // The seed itself is free, other handles are not.
        greatest = std::max(greatest, is_seed ? value - (value > 0 ? 1 : 0) : value);
      }
      if (is_seed) names.seed = group;
    }
    is_seed = group.code == 9 && group.value == "$HANDSEED";
  }
  names.next_handle = greatest + 1;
}

void note_table(const DxfText& file, const DxfRecord& record, std::string_view& table,
                DxfNames& names) {
  const std::string_view name = file.value(record, kName);
  if (record.type == "TABLE") {
    table = name;
    if (table == "LAYER") names.layers = record;
  } else if (record.type == "ENDTAB") {
    if (table == "LAYER") names.layers_end = record;
    table = {};
  } else if (record.type == "LAYER") {
    if (!names.layer) names.layer = record;
    names.has_virtual_layer |= is_same_name(name, kVirtualLayer);
  } else if (record.type == "LTYPE" && (is_same_name(name, "dashed") || names.dashed.empty()) &&
             (is_same_name(name, "dashed") || is_same_name(name, "continuous"))) {
    names.dashed = name;
  } else if (record.type == "BLOCK_RECORD" && is_same_name(name, "*model_space")) {
    names.model_space = file.value(record, kHandle);
  }
}

}  // namespace

std::string hex(std::uint64_t value) { return fmt::format("{:X}", value); }

DxfNames dxf_names(const DxfText& file) {
  constexpr int kPaper = 67;
  DxfNames names;
  note_handles(file, names);
  std::string_view table;
  for (const DxfRecord& record : file.records) {
    if (record.section == "TABLES") note_table(file, record, table, names);
    if (record.section != "ENTITIES" || !names.model_space.empty()) continue;
    if (file.value(record, kPaper) != "1") names.model_space = file.value(record, kOwner);
  }
  if (names.dashed.empty()) names.dashed = "CONTINUOUS";
  return names;
}

}  // namespace plumbline::patch
