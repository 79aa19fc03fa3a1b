// Repairs of which a part is not what the rest says: each is refused, for its reason.

#include "support/forgeries.hpp"

using namespace plumbline;

namespace {

void replace_segment(Repair& repair, std::size_t i, const std::string& text) {
  std::vector<Segment> all = to_vector(repair.output.segments);
  all[i] = segments(text).segments[0];
  repair.output.segments = SegmentList(all);
}

void set_origins(Repair& repair, std::size_t i, const std::vector<std::size_t>& ids) {
  Lists<SegmentId> result;
  for (std::size_t k = 0; k < repair.origins.size(); ++k) {
    const auto known = repair.origins[k];
    std::vector<SegmentId> list(known.begin(), known.end());
    if (k == i) list = line("0 0 1 1", ids).segments;
    result.push_back(list);
  }
  repair.origins = result;
}

std::vector<Forgery> forged_segments() {
  return {
      {"an end moved", corner(), [](Repair& r) { replace_segment(r, 0, "10 8 0 8.001"); },
       "that no edit put there"},
      {"a segment is missing", corner(),
       [](Repair& r) {
         r.output.segments.truncate(3);
         r.output.segment_source.pop_back();
         Lists<SegmentId> rest;
         for (std::size_t i = 0; i < 3; ++i) rest.push_back(r.origins[i]);
         r.origins = rest;
       },
       "that the output has not"},
      {"a segment that nobody drew", corner(),
       [](Repair& r) {
         r.output.segments.push_back(Segment{point("0 4"), point("10 4")});
         r.output.segment_source.push_back(r.output.segment_source[0]);
         r.origins.push_back(std::vector<SegmentId>{SegmentId(2)});
       },
       "that no edit put there"},
      {"a segment twice", corner(),
       [](Repair& r) {
         r.output.segments.push_back(r.output.segments[0]);
         r.output.segment_source.push_back(r.output.segment_source[0]);
         r.origins.push_back(std::vector<SegmentId>{SegmentId(2)});
       },
       "that no edit put there"},
      {"origins exchanged", corner(),
       [](Repair& r) {
         set_origins(r, 0, {3});
         set_origins(r, 1, {2});
         std::swap(r.output.segment_source[0], r.output.segment_source[1]);
       },
       "that no edit put there"},
      {"no origins", corner(), [](Repair& r) { set_origins(r, 0, {}); }, "a source that none"},
      {"origins beyond the input", corner(), [](Repair& r) { set_origins(r, 0, {9}); },
       "not ascending ids"},
      {"origins twice", pieces(),
       [](Repair& r) {
         set_origins(r, 0, {3, 3});
       },
       "not ascending ids"},
      {"an origin more", corner(),
       [](Repair& r) {
         set_origins(r, 0, {2, 3});
       },
       "that no edit put there"},
  };
}

std::vector<Forgery> forged_parts() {
  return {
      {"too few origins", corner(), [](Repair& r) { r.origins = {}; }, "0 lists of origins"},
      {"the source of another segment", corner(),
       [](Repair& r) { r.output.segment_source[0] = r.output.segment_source[1]; },
       "a source that none of its origins has"},
      {"another file", corner(), [](Repair& r) { r.output.files[0] = "other"; }, "files of"},
      {"another label", corner(),
       [](Repair& r) {
         r.output.labels.push_back({SourceId(std::size_t{0}), "hall", {}, 0});
       },
       "labels of"},
      {"another layer", corner(),
       [](Repair& r) {
         r.output.layers.push_back({"wall", {}});
       },
       "layers of"},
      {"another unit", corner(),
       [](Repair& r) {
         r.output.unit = LengthUnit{"mm", {}};
       },
       "units of"},
      {"other sources", corner(), [](Repair& r) { r.output.sources = {}; }, "sources of"},
  };
}

std::vector<Forgery> forged_logs() {
  return {
      {"an edit left out", corner(), [](Repair& r) { r.edits.pop_back(); },
       "that no edit put there"},
      {"an edit that was not made", dangles(),
       [](Repair& r) {
         r.edits.push_back(
             {EditKind::Trim, point("5 0"), decimal("0.36"), {line("5 0 5 0.6", {4, 6})}, {}});
         r.tolerances.trim = 1;
       },
       "that no edit put there"},
      {"an anchored segment", corner(), [](Repair& r) { r.anchored = {SegmentId(std::size_t{0})}; },
       "an anchored segment"},
      {"a refusal of nobody's segments", corner(),
       [](Repair& r) {
         r.refused.push_back({EditKind::Grow, {}, 1, "", {SegmentId(std::size_t{9})}});
       },
       "refused grow"},
      {"a face left out", door(), [](Repair& r) { r.faces.pop_back(); }, "does not say so"},
      {"a face too many", dangles(), [](Repair& r) { r.faces = door().repair.faces; },
       "what is not so"},
      {"another area", door(), [](Repair& r) { r.faces[0].area_after = 35; }, "does not say so"},
      {"another fate", corner(), [](Repair& r) { r.faces[0].fate = FaceFate::Changed; },
       "does not say so"},
      {"another edit's face", corner(), [](Repair& r) { r.faces[0].edits = {1}; },
       "does not say so"},
  };
}

}  // namespace

TEST_CASE("an output that its log does not make is refused") {
  for (const auto& forgeries : {forged_segments(), forged_parts(), forged_logs()}) {
    for (const Forgery& forgery : forgeries) check_refused(forgery);
  }
}
