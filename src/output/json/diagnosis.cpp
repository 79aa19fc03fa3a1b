// The diagnosis as JSON; documented in docs/json.md.

#include "output/json/input.hpp"
#include "output/text/verdict.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace json {
namespace {

auto ring(const RingProblem& problem) {
  return object(member("fault", to_text(problem.fault)), member("jts", jts_name(problem.fault)),
                member("until", given(problem.until, place)), member("ring", problem.ring),
                member("other", problem.other));
}

auto opening(const SegmentSet& input, const Opening& o) {
  return object(member("where", place(o.where)), member("width", o.width),
                member("squared_width", with_nearest(o.squared_width)),
                member("vertices", o.vertices), member("segments", o.segments),
                member("sources", sources_of(input, o.segments)));
}

auto defect(const SegmentSet& input, const Defect& d, std::size_t number) {
  return object(member("number", number), member("kind", to_text(d.kind)),
                member("message", d.message), member("where", place(d.where)),
                member("size", d.size), member("squared_size", given(d.squared_size, with_nearest)),
                member("area", given(d.area, with_nearest)), member("open_area", d.open_area),
                member("ring", given(d.ring, ring)),
                member("proposed_tolerance", d.proposed_tolerance), member("vertices", d.vertices),
                member("edges", d.edges), member("face", d.face), member("segments", d.segments),
                member("sources", sources_of(input, d.segments)));
}

auto tolerance(const ToleranceEffect& effect) {
  return object(member("tolerance", effect.tolerance), member("mended", effect.mended),
                member("spares_detail", effect.spares_detail));
}

auto diagnosis_members(const Diagnosis& diagnosis, const SegmentSet& input) {
  const auto count = [&diagnosis](std::size_t kind) {
    return member(to_text(static_cast<DefectKind>(kind)), diagnosis.found[kind]);
  };
  return members(member("within", with_nearest(diagnosis.within)),
                 member("counts", object(each(Numbers(0, kDefectKinds), count))),
                 member("shared_sides", diagnosis.shared_sides),
                 member("loose_ends", diagnosis.tips), member("cut_short", diagnosis.cut_short),
                 member("squared_detail", given(diagnosis.squared_detail, with_nearest)),
                 member("tolerances", list(diagnosis.tolerances, tolerance)),
                 member("openings", list(diagnosis.openings,
                                         [&](const Opening& o) { return opening(input, o); })),
                 member("defects", list(diagnosis.defects.size(), [&](std::size_t i) {
                          return defect(input, diagnosis.defects[i], i + 1);
                        })));
}

}  // namespace
}  // namespace json

std::string to_json(const Diagnosis& diagnosis, const SegmentSet& input) {
  using namespace json;
  return document(object(member("format", "plumbline diagnosis 1"),
                         member("exact", input.ledger.empty()), diagnosis_members(diagnosis, input),
                         input_members(input)));
}

}  // namespace plumbline
