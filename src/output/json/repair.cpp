// The log of a repair as JSON; documented in docs/json.md.

#include <algorithm>
#include <utility>

#include "output/json/input.hpp"
#include "output/text/edits.hpp"
#include "output/text/verdict.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace json {
namespace {

auto elements(const SegmentSet& input, const std::vector<SegmentId>& segments) {
  return list(sources_of(input, segments),
              [&input](SourceId s) { return object(source_members(input.sources[s])); });
}

auto line(const Line& l) {
  return object(member("from", l.a), member("to", l.b), member("segments", l.segments));
}

auto edit(const Repair& repair, const SegmentSet& input, std::size_t e) {
  const Edit& edit = repair.edits[e];
  return object(member("number", e + 1), member("kind", to_text(edit.kind)),
                member("where", place(edit.where)), member("size", nearest_sqrt(edit.squared_size)),
                member("squared_size", with_nearest(edit.squared_size)),
                member("before", list(edit.before, line)), member("after", list(edit.after, line)),
                member("elements", elements(input, segments_of(edit))));
}

auto refusal(const SegmentSet& input, const Refusal& r) {
  return object(member("kind", to_text(r.kind)), member("where", place(r.where)),
                member("size", nearest_sqrt(r.squared_size)),
                member("squared_size", with_nearest(r.squared_size)), member("reason", r.reason),
                member("segments", r.segments), member("elements", elements(input, r.segments)));
}

auto face(const FaceOutcome& f) {
  return object(member("fate", to_text(f.fate)), member("before", f.before),
                member("after", f.after), member("area_before", with_nearest(f.area_before)),
                member("area_after", with_nearest(f.area_after)), member("where", place(f.where)),
                member("edits", list(f.edits, [](std::size_t e) { return e + 1; })));
}

auto segment(const Segment& s) { return object(member("from", s.a), member("to", s.b)); }

auto change(const SegmentSet& input, const NetChange& c) {
  const auto sourced = [&input](const SourcedSegment& s) {
    Source source = s.source;
    source.file =
        static_cast<std::uint32_t>(std::ranges::find(input.files, s.file) - input.files.begin());
    return object(member("from", s.segment.a), member("to", s.segment.b),
                  member("element", object(source_members(std::move(source)))));
  };
  return object(member("before", list(c.before, sourced)), member("after", list(c.after, segment)));
}

auto tolerances(const Tolerances& t) {
  const auto range = [](const Range& doors) { return std::tie(doors.least, doors.most); };
  return object(member("weld", t.weld), member("grow", t.grow), member("trim", t.trim),
                member("sliver", t.sliver), member("snap", t.snap), member("simplify", t.simplify),
                member("doors", given(t.doors, range)));
}

}  // namespace
}  // namespace json

std::string to_json(const Repair& repair, const SegmentSet& input) {
  using namespace json;
  const auto edit_at = [&](std::size_t e) { return edit(repair, input, e); };
  const auto refused = [&](const Refusal& r) { return refusal(input, r); };
  const std::vector<NetChange> changes = net_changes(input, repair);
  return document(object(
      member("format", "plumbline repair 1"), member("exact", input.ledger.empty()),
      member("input_signature", rounded_signature(input)),
      member("output_signature", rounded_signature(repair.output)),
      member("tolerances", tolerances(repair.tolerances)), member("reasons", repair.reasons),
      member("edits", list(repair.edits.size(), edit_at)),
      member("refused", list(repair.refused, refused)), member("faces", list(repair.faces, face)),
      member("changes", list(changes, [&](const NetChange& c) { return change(input, c); })),
      member("anchored", repair.anchored), crs_member(input.crs), member("files", input.files),
      losses(input.rejected, input.remarks, input.ledger)));
}

}  // namespace plumbline
