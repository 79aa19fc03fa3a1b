// Edits of a repair, and what was refused, as a layer of points.

#include "output/text/edits.hpp"
#include "output/features/points.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

using namespace features;

/// "0 0, 1 0; 1 0, 2 0".
FeatureValue lines_text(const std::vector<Line>& lines) {
  std::string words;
  for (const Line& line : lines) {
    words += (words.empty() ? "" : "; ") + to_text(Segment{line.a, line.b});
  }
  return text(std::move(words));
}

}  // namespace

FeatureLayer line_layer(const SegmentSet& lines) {
  FeatureLayer layer{
      "lines", FeatureGeometry::Line, {"line", "layer", "source", "id", "virtual"}, {}, true};
  for (std::size_t s = 0; s < lines.segments.size(); ++s) {
    const auto ends = lines.segments.numbers(s);
    const PointD a = nearest(NumberPoint{ends[0], ends[1]});
    const PointD b = nearest(NumberPoint{ends[2], ends[3]});
    if (a == b) continue;  // no line in doubles
    const Source source = lines.sources[lines.segment_source[s]];
    const bool is_virtual = source.layer == kVirtualLayer;
    layer.features.push_back(
        {{{a, b}},
         {static_cast<std::int64_t>(s + 1), text(source.layer), text(to_text(source, lines.files)),
          text(source.id), std::int64_t{is_virtual}},
         source.layer});
  }
  return layer;
}

FeatureLayer edit_layer(const Repair& repair, const SegmentSet& input) {
  FeatureLayer layer{"edits",
                     FeatureGeometry::Point,
                     {"number", "kind", "size", "refused", "rooms", "before", "after", "exact_x",
                      "exact_y", "sources"},
                     {},
                     true};
  const auto add = [&](const auto& of, FeatureValue refused, FeatureValue rooms,
                       FeatureValue before, FeatureValue after, FeatureValue sources,
                       std::string on) {
    layer.features.push_back(point_at(
        of.where,
        {number(layer.features.size() + 1), to_text(of.kind), nearest_sqrt(of.squared_size),
         std::move(refused), std::move(rooms), std::move(before), std::move(after),
         exact_text(of.where.x), exact_text(of.where.y), std::move(sources)},
        std::move(on)));
  };
  const std::vector<std::string> rooms = room_texts(repair, repair.faces.size());
  for (std::size_t e = 0; e < repair.edits.size(); ++e) {
    const Edit& edit = repair.edits[e];
    add(edit, {}, text(rooms[e]), lines_text(edit.before), lines_text(edit.after),
        sources_text(input, segments_of(edit)), to_text(edit.kind));
  }
  for (const Refusal& refusal : repair.refused) {
    add(refusal, text(refusal.reason), {}, {}, {}, sources_text(input, refusal.segments),
        "refused " + to_text(refusal.kind));
  }
  return layer;
}

}  // namespace plumbline
