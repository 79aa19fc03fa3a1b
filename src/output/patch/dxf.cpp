// DXF with lines in place of what changed; everything else stays as it is, byte by byte.

#include <algorithm>
#include <array>

#include "output/features/dxf_text.hpp"
#include "output/patch/changed.hpp"
#include "output/patch/dxf_names.hpp"
#include "output/patch/dxf_text.hpp"
#include "plumbline/edits.hpp"
#include "plumbline/patch.hpp"

namespace plumbline {
namespace patch {
namespace {

constexpr int kHandleCode = 5, kLayerCode = 8, kOwnerCode = 330, kMarker = 100;
constexpr const char* kEntities = "ENTITIES";

/// A number that is no integer.
std::string real(const Number& number) {
  const std::string text = coordinate(number);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

/// What a LINE takes over from an entity.
struct Style {
  std::string groups;  ///< layer, colour and the like
  std::string owner;   ///< handle
  std::string handle;  ///< for one line; "": a new one
};

class DxfPatch {
 public:
  DxfPatch(const DxfText& file, const SegmentSet& output)
      : file_(file), names_(dxf_names(file)), output_(output) {}

  std::optional<Patch> patch(const Changes& changes) {
    const auto end = std::ranges::find_if(file_.records, [](const DxfRecord& record) {
      return record.type == "ENDSEC" && record.section == kEntities;
    });
    if (end == file_.records.end()) return std::nullopt;
    Patch result;
    std::string behind;
    for (const Changed& element : changes.elements) {
      if (!take_out(element, behind)) return std::nullopt;
      result.replaced.push_back(element.source);
    }
    if (!changes.added.empty()) add_layer();
    for (const SegmentId s : changes.added) behind += line(s, on_own_layer(s));
    insert(file_.begin(*end), std::move(behind));
    if (names_.seed && has_new_handle_) {
      replacements_.push_back(
          {names_.seed->begin, names_.seed->end, group(kHandleCode, hex(names_.next_handle))});
    }
    result.text = replaced(file_.text, std::move(replacements_));
    return result;
  }

 private:
  std::string group(int code, std::string_view value) const {
    std::string text = std::to_string(code);
    text.insert(0, text.size() < 3 ? 3 - text.size() : 0, ' ');
    return (((text += file_.line_end) += value) += file_.line_end);
  }
  std::string raw(const DxfGroup& of) const {
    return std::string(file_.text.substr(of.begin, of.end - of.begin));
  }
  void insert(std::size_t at, std::string text) {
    if (!text.empty()) replacements_.push_back({at, at, std::move(text)});
  }
  std::string new_handle() {
    has_new_handle_ = true;
    return hex(names_.next_handle++);
  }

  /// Its record, and those that belong to it.
  std::optional<std::pair<std::size_t, std::size_t>> records_of(const Source& source) const {
    const auto first = std::ranges::lower_bound(file_.records, source.line, {}, &DxfRecord::line);
    if (first == file_.records.end() || first->line != source.line ||
        first->type != source.element) {
      return std::nullopt;
    }
    auto last = first;
    if (first->type == "POLYLINE") {
      while (std::next(last) != file_.records.end() &&
             (std::next(last)->type == "VERTEX" || std::next(last)->type == "SEQEND")) {
        ++last;
        if (last->type == "SEQEND") break;
      }
    }
    return std::pair(first - file_.records.begin(), last - file_.records.begin());
  }

  /// Puts its lines in the element's place or, of what a block has, into `behind`.
  bool take_out(const Changed& element, std::string& behind) {
    const auto records = records_of(element.source);
    if (!records) return false;
    const DxfRecord& record = file_.records[records->first];
    const bool is_in_block = record.section != kEntities;
    std::string lines;
    Style style = is_in_block ? Style{} : style_of(record);
    for (const SegmentId s : element.lines) {
      lines += line(s, is_in_block ? on_own_layer(s) : style);
      style.handle.clear();
    }
    if (is_in_block) {
      behind += lines;
      lines.clear();
    }
    replacements_.push_back(
        {file_.begin(record), file_.end(file_.records[records->second]), std::move(lines)});
    return true;
  }

  Style style_of(const DxfRecord& record) const {
    // Layer, line type and its scale, visibility, colours, line weight, transparency, paper space.
    constexpr std::array kCodes{8, 6, 48, 60, 62, 67, 370, 420, 430, 440};
    Style style;
    for (const DxfGroup& of : file_.own_groups(record)) {
      if (std::ranges::find(kCodes, of.code) != kCodes.end()) style.groups += raw(of);
      if (of.code == kHandleCode && style.handle.empty()) style.handle = of.value;
      if (of.code == kOwnerCode && style.owner.empty()) style.owner = of.value;
    }
    return style;
  }

  Style on_own_layer(SegmentId s) const {
    const std::string layer = output_.sources[output_.segment_source[s]].layer;
    return {group(kLayerCode, features::dxf_text(layer.empty() ? "0" : layer)), names_.model_space,
            ""};
  }

  std::string line(SegmentId s, const Style& style) {
    const auto ends = output_.segments.numbers(s);
    std::string text = group(0, "LINE");
    if (!style.handle.empty() || names_.is_modern) {
      text += group(kHandleCode, style.handle.empty() ? new_handle() : style.handle);
    }
    if (names_.is_modern) {
      if (!style.owner.empty()) text += group(kOwnerCode, style.owner);
      text += group(kMarker, "AcDbEntity");
    }
    text += style.groups;
    if (names_.is_modern) text += group(kMarker, "AcDbLine");
    for (const int end : {0, 1}) {
      const std::size_t first = end == 0 ? 0 : 2;
      text += group(10 + end, real(ends[first]));
      text += group(20 + end, real(ends[first + 1]));
      text += group(30 + end, "0.0");
    }
    return text;
  }

  void add_layer() {
    if (names_.has_virtual_layer || !names_.layers_end) return;
    constexpr int kMagenta = 6;
    std::string text = group(0, "LAYER");
    if (names_.is_modern) {
      text += group(kHandleCode, new_handle());
      const std::string_view table = file_.value(*names_.layers, kHandleCode);
      if (!table.empty()) text += group(kOwnerCode, table);
      text += group(kMarker, "AcDbSymbolTableRecord") + group(kMarker, "AcDbLayerTableRecord");
    }
    text += group(2, kVirtualLayer) + group(70, "0") + group(62, std::to_string(kMagenta)) +
            group(6, names_.dashed);
    if (names_.layer) {
      constexpr std::array kCodes{370, 390, 347, 348};  // line weight, plot style, materials
      for (const DxfGroup& of : file_.own_groups(*names_.layer)) {
        if (std::ranges::find(kCodes, of.code) != kCodes.end()) text += raw(of);
      }
    }
    insert(file_.begin(*names_.layers_end), std::move(text));
  }

  const DxfText& file_;
  DxfNames names_;
  const SegmentSet& output_;
  std::vector<Replacement> replacements_;
  bool has_new_handle_ = false;
};

}  // namespace
}  // namespace patch

std::optional<Patch> patched_dxf(std::string_view text, const SegmentSet& input,
                                 const SegmentSet& output, const std::vector<bool>& also) {
  const patch::Changes changes = patch::changes_of(input, output, also);
  if (changes.empty()) return Patch{std::string(text), {}};
  const std::optional<patch::DxfText> file = patch::dxf_text_of(text);
  return file ? patch::DxfPatch(*file, output).patch(changes) : std::nullopt;
}

}  // namespace plumbline
