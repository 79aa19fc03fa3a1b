// Edits of a repair, and what was refused, as a layer of points.

#include "output/text/edits.hpp"
#include "output/text/verdict.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

/// Nothing where there is no text.
FeatureValue text(std::string words) {
  return words.empty() ? FeatureValue() : FeatureValue(std::move(words));
}

FeatureValue elements_text(const SegmentSet& input, const std::vector<SegmentId>& segments) {
  std::string words;
  for (const SourceId source : sources_of(input, segments)) {
    words += (words.empty() ? "" : "; ") + to_text(input.sources[source], input.files);
  }
  return text(std::move(words));
}

/// "0 0, 1 0; 1 0, 2 0".
FeatureValue lines_text(const std::vector<Line>& lines) {
  std::string words;
  for (const Line& line : lines) {
    words += (words.empty() ? "" : "; ") + to_text(Segment{line.a, line.b});
  }
  return text(std::move(words));
}

}  // namespace

FeatureLayer line_layer(const Repair& repair) {
  FeatureLayer layer{
      "lines", FeatureGeometry::Line, {"line", "layer", "source", "id", "virtual"}, {}, true};
  const SegmentSet& output = repair.output;
  for (std::size_t s = 0; s < output.segments.size(); ++s) {
    const auto ends = output.segments.numbers(s);
    const PointD a = nearest(NumberPoint{ends[0], ends[1]});
    const PointD b = nearest(NumberPoint{ends[2], ends[3]});
    if (a == b) continue;  // no line in doubles
    const bool is_virtual = repair.origins[s].empty();
    const Source source = is_virtual ? Source{} : output.sources[output.segment_source[s]];
    std::string on = is_virtual ? kVirtualLayer : source.layer;
    layer.features.push_back({{{a, b}},
                              {static_cast<std::int64_t>(s + 1), text(on),
                               is_virtual ? FeatureValue() : text(to_text(source, output.files)),
                               text(source.id), static_cast<std::int64_t>(is_virtual)},
                              std::move(on)});
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
  const auto add = [&](EditKind kind, const Point& where, const Rational& squared_size,
                       FeatureValue refused, FeatureValue rooms, FeatureValue before,
                       FeatureValue after, FeatureValue sources, std::string on) {
    layer.features.push_back(
        {{{nearest(where)}},
         {static_cast<std::int64_t>(layer.features.size() + 1), to_text(kind),
          nearest_sqrt(squared_size), std::move(refused), std::move(rooms), std::move(before),
          std::move(after), exact_text(where.x), exact_text(where.y), std::move(sources)},
         std::move(on)});
  };
  const std::vector<std::string> rooms = room_texts(repair, repair.faces.size());
  for (std::size_t e = 0; e < repair.edits.size(); ++e) {
    const Edit& edit = repair.edits[e];
    add(edit.kind, edit.where, edit.squared_size, {}, text(rooms[e]), lines_text(edit.before),
        lines_text(edit.after), elements_text(input, segments_of(edit)), to_text(edit.kind));
  }
  for (const Refusal& refusal : repair.refused) {
    add(refusal.kind, refusal.where, refusal.squared_size, text(refusal.reason), {}, {}, {},
        elements_text(input, refusal.segments), "refused " + to_text(refusal.kind));
  }
  return layer;
}

}  // namespace plumbline
