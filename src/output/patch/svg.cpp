// SVG with paths of lines at the end in place of what changed; everything else stays as it is, byte
// by byte.

#include <algorithm>
#include <map>

#include "output/patch/changed.hpp"
#include "output/patch/xml_text.hpp"
#include "output/svg/kit.hpp"
#include "plumbline/edits.hpp"
#include "plumbline/patch.hpp"

namespace plumbline {
namespace patch {
namespace {

/// Text within quotes.
std::string attribute_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') {
      result += "&quot;";
    } else if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else {
      result += c;
    }
  }
  return result + '"';
}

/// What a path takes over from its element. It is not filled: its lines are in no order that would
/// have an inside, and stand in front of everything else.
std::string attributes_of(const XmlElement& element, bool with_id) {
  constexpr std::string_view kUnfilled = "fill:none";
  std::string text, style;
  bool has_style = false;
  for (const auto& [name, value] : element.attributes) {
    if (name == "style" || name == "class") has_style = true;
    if (name == "style") style = std::string(value.substr(1, value.size() - 2)) + ';';
    if (name == "class" || name.starts_with("stroke") || (name == "id" && with_id)) {
      ((text += ' ') += name) += '=' + std::string(value);
    }
  }
  if (!has_style) return text;
  const char quote = style.find('"') == std::string::npos ? '"' : '\'';
  return ((text += " style=") += quote) + style + std::string(kUnfilled) + quote;
}

class SvgPatch {
 public:
  SvgPatch(std::string_view text, const SegmentSet& output)
      : text_(text), output_(output), lines_(line_begins(text)) {}

  std::optional<Patch> patch(const Changes& changes) {
    const std::size_t root_end = text_.rfind("</");
    if (root_end == std::string_view::npos) return std::nullopt;
    const std::string_view root = text_.substr(root_end + 2, text_.find('>', root_end) - root_end);
    const std::size_t colon = root.find(':');
    if (colon != std::string_view::npos) prefix_ = root.substr(0, colon + 1);
    Patch result;
    for (const Changed& element : changes.elements) {
      if (!take_out(element)) return std::nullopt;
      result.replaced.push_back(element.source);
    }
    for (const SegmentId s : changes.added) {
      paths_[layer_of(s)] += path("", data({s}), "");
    }
    if (!paths_.empty()) replacements_.push_back({root_end, root_end, groups()});
    result.text = replaced(text_, std::move(replacements_));
    return result;
  }

 private:
  std::string layer_of(SegmentId s) const {
    return output_.sources[output_.segment_source[s]].layer;
  }

  std::string path(const std::string& attributes, const std::string& d,
                   std::string_view content) const {
    std::string text = "<" + prefix_ + "path" + attributes + " d=\"" + d + '"';
    if (content.empty()) return text + "/>\n";
    return (((text += '>') += content) += "</" + prefix_ + "path>\n");
  }

  /// "M0 0L1 0L1 1M5 5L6 6".
  std::string data(const std::vector<SegmentId>& lines) const {
    std::string d;
    std::optional<Point> end;
    for (const SegmentId s : lines) {
      const auto numbers = output_.segments.numbers(s);
      const Segment segment = output_.segments[s];
      if (!end || segment.a != *end) {
        d += 'M' + coordinate(numbers[0]) + ' ' + coordinate(numbers[1]);
      }
      d += 'L' + coordinate(numbers[2]) + ' ' + coordinate(numbers[3]);
      end = segment.b;
    }
    return d;
  }

  /// Its lines go to the group of their layer; each time that it is drawn has its own.
  bool take_out(const Changed& element) {
    const auto [line, column] = std::tie(element.source.line, element.source.column);
    if (line == 0 || line > lines_.size() || column == 0) return false;
    const auto found = element_at(text_, lines_[line - 1] + column - 1);
    if (!found || found->name != element.source.element) return false;
    replacements_.push_back({found->begin, found->end, ""});
    const std::string attributes = attributes_of(*found, element.drawn == 1);
    std::map<std::string, std::vector<SegmentId>> by_layer;
    for (const SegmentId s : element.lines) by_layer[layer_of(s)].push_back(s);
    for (const auto& [layer, lines] : by_layer) {
      paths_[layer] +=
          path(attributes, data(lines), element.drawn == 1 ? found->content : std::string_view());
    }
    return true;
  }

  std::string groups() const {
    constexpr double kPen = 0.001, kDash = 6;  // of the drawing's longer side; of the pen
    const svg::Box box = svg::bounds(extent(output_));
    const double pen = kPen * std::max(box.width(), box.height());
    const std::string g = "<" + prefix_ + "g";
    std::string text = g +
                       " data-plumbline=\"repair\" fill=\"none\" stroke=\"#000\" stroke-width=\"" +
                       shortest_text(pen) + "\">\n";
    for (const auto& [layer, paths] : paths_) {
      if (layer.empty()) {
        text += paths;
        continue;
      }
      text += g +
              " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
              "inkscape:groupmode=\"layer\" inkscape:label=" +
              attribute_text(layer);
      if (layer == kVirtualLayer) {
        text += " stroke-dasharray=\"" + shortest_text(kDash * pen) + '"';
      }
      text += ">\n" + paths + "</" + prefix_ + "g>\n";
    }
    return text + "</" + prefix_ + "g>\n";
  }

  std::string_view text_;
  const SegmentSet& output_;
  std::vector<std::size_t> lines_;  ///< where they begin
  std::string prefix_;              ///< "svg:", where elements have it
  std::vector<Replacement> replacements_;
  std::map<std::string, std::string> paths_;  ///< by layer
};

}  // namespace
}  // namespace patch

std::optional<Patch> patched_svg(std::string_view text, const SegmentSet& input,
                                 const SegmentSet& output, const std::vector<bool>& also) {
  const patch::Changes changes = patch::changes_of(input, output, also);
  if (changes.empty()) return Patch{std::string(text), {}};
  return patch::SvgPatch(text, output).patch(changes);
}

}  // namespace plumbline
