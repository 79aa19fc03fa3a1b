#include "output/json/input.hpp"

namespace plumbline::json {

Part losses(const std::vector<Rejected>& rejected, const std::vector<Remark>& remarks,
            const std::vector<Replacement>& ledger) {
  const auto refused = [](const Rejected& item) {
    return object(source_members(item.source), member("reason", item.reason),
                  member("text", item.text), member("harmless", item.harmless));
  };
  const auto remark = [](const Remark& item) {
    return object(source_members(item.source), member("what", item.what),
                  member("text", item.text));
  };
  const auto replacement = [](const Replacement& item) {
    return object(source_members(item.source), member("what", item.what),
                  member("bound", item.bound));
  };
  return part_of(members(member("rejected", list(rejected, refused)),
                         member("remarks", list(remarks, remark)),
                         member("ledger", list(ledger, replacement))));
}

Part crs_member(const std::string& crs) {
  return part_of(when(!crs.empty(), [crs] { return member("crs", crs); }));
}

Part input_members(const SegmentSet& input) {
  const auto source = [](const Source& s) { return object(source_members(s)); };
  const auto segment = [&input](std::size_t s) {
    const auto ends = input.segments.numbers(s);
    return object(member("source", input.segment_source[s]), member("from", ends.first<2>()),
                  member("to", ends.last<2>()));
  };
  return part_of(members(crs_member(input.crs), member("files", input.files),
                         member("sources", list(input.sources, source)),
                         member("segments", list(input.segments.size(), segment)),
                         losses(input.rejected, input.remarks, input.ledger)));
}

}  // namespace plumbline::json
