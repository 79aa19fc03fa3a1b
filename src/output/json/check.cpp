// The comparison as JSON; documented in docs/json.md.

#include "output/json/check.hpp"

#include "output/json/input.hpp"
#include "output/text/groups.hpp"
#include "output/text/verdict.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace json {
namespace {

auto engine(const Answer& answer) {
  return object(member("name", answer.engine), member("version", answer.version),
                member("title", answer.title),
                member("parameters", object(each(answer.parameters, [](const auto& parameter) {
                         return member(parameter.first, parameter.second);
                       }))));
}

auto counts(const Counts& counts) {
  return object(each(count_rows(), [&counts](const CountRow& row) {
    return member(row.name, counts.*row.member);
  }));
}

auto summary(const Check& check) {
  const Comparison& c = check.comparison;
  return members(
      member("verdict", c.agree() ? "agree" : "disagree"),
      member("lost", count_lost(check.input.rejected)),
      member("drift",
             object(member("places", check.drift.places), member("largest", check.drift.largest),
                    member("bound", check.drift.bound), member("complete", check.drift.is_complete),
                    member("findings", check.own_findings()))),
      member("engine", engine(check.answer)), member("float_valid", c.float_valid),
      member("exact", check.input.ledger.empty()), member("radius", check.answer.radius),
      member("radius_from", given(!check.answer.radius_from.empty(),
                                  [&check] { return check.answer.radius_from; })),
      member("crowded_vertices", check.crowded_vertices), member("tolerance", c.tolerance),
      member("largest_displacement", c.largest_displacement),
      member("counts", object(member("exact", counts(c.exact_counts)),
                              member("doubles", counts(check.conversion.float_counts)),
                              member("float", counts(c.float_counts)))),
      member("compared", to_text(c.compared)),
      member("left_out",
             object(member("edges", c.edges_left_out), member("vertices", c.vertices_left_out))),
      member("matched",
             object(member("vertices", c.matched_vertices), member("edges", c.matched_edges),
                    member("faces", c.matched_faces))));
}

auto cause(const Cause& c) {
  const auto other = [](const Cause& also) {
    return object(member("stage", also.stage), member("round", also.round),
                  member("rule", also.rule), member("explanation", also.explanation),
                  member("advice", also.advice), member("distance", also.distance));
  };
  return object(member("stage", c.stage), member("round", c.round), member("rule", c.rule),
                member("explanation", c.explanation), member("advice", c.advice),
                member("confirmed", c.confirmed), member("remade", c.remade),
                member("distance", c.distance), member("radius_without", c.radius_without),
                member("with", list(c.with, other)));
}

auto finding(const SegmentSet& input, const Finding& f, const Cause* known, std::size_t number) {
  return object(
      member("number", number), member("kind", to_text(f.kind)),
      member("disagreement", to_text(f.disagreement)),
      member("invariant", given(f.invariant, [](Invariant broken) { return to_text(broken); })),
      member("message", f.message),
      member("where", given(f.kind != CellKind::Complex, [&f] { return place(f.where); })),
      member("because", f.because), member("exact_cells", f.exact_cells),
      member("float_cells", f.float_cells), member("distance", f.distance),
      member("squared_distance", given(f.squared_distance, with_nearest)),
      member("area", given(f.area, with_nearest)), member("cause", given(known, cause)),
      member("segments", f.segments), member("sources", sources_of(input, f.segments)));
}

auto findings(const SegmentSet& input, const std::vector<Finding>& found,
              const std::vector<Cause>& causes) {
  return list(found.size(), [&](std::size_t i) {
    return finding(input, found[i], i < causes.size() ? &causes[i] : nullptr, i + 1);
  });
}

auto changed_faces(const ChangedFaces& f) {
  return object(member("change", to_text(f.change)), member("finding", f.finding),
                member("areas", f.areas), member("area", f.area));
}

auto groups(const Check& check) {
  return list(check.groups.size(), [&check](std::size_t i) {
    const FindingGroup& group = check.groups[i];
    const Finding& lead = check.comparison.findings[group.lead - 1];
    return object(member("number", i + 1), member("message", to_text(group, check)),
                  member("where", given(lead.kind != CellKind::Complex,
                                        [&lead] { return place(lead.where); })),
                  member("low", group.low), member("high", group.high), member("area", group.area),
                  member("own", group.is_own), member("faces", list(group.faces, changed_faces)),
                  member("lead", group.lead), member("findings", group.findings),
                  member("sources", sources_of(check.input, lead.segments)));
  });
}

auto ladder(const ToleranceLadder& ladder) {
  const auto step = [](const LadderStep& s) {
    return object(member("squared_radius", s.squared_radius),
                  member("radius", nearest_sqrt(s.squared_radius)), member("vertices", s.vertices),
                  member("edges", s.edges), member("faces", s.faces), member("vertex", s.vertex),
                  member("other_vertex", s.other_vertex), member("edge", s.edge));
  };
  return object(member("vertices", ladder.vertices), member("edges", ladder.edges),
                member("faces", ladder.faces), member("complete", ladder.is_complete),
                member("steps", list(ladder.steps, step)));
}

auto radii(const std::optional<RightRadii>& radii) {
  const auto trial = [](const TriedRadius& t) {
    return object(member("radius", t.radius), member("right", t.is_right),
                  member("findings", t.findings));
  };
  const bool has_right = radii && !radii->empty();
  return members(
      member("right_radii", given(has_right,
                                  [&radii] {
                                    return std::array{radii->least, radii->largest};
                                  })),
      member("advised_radius", given(has_right, [&radii] { return radii->advised; })),
      member("tried_radii", list(radii ? radii->tried : std::vector<TriedRadius>(), trial)));
}

auto distance_members(const Rational& squared) {
  return members(member("squared_distance", squared), member("distance", nearest_sqrt(squared)));
}

auto feature_size(const FeatureSize& size) {
  return object(member("vertex_vertex", object(distance_members(size.squared_vertex_vertex),
                                               member("vertices", std::array{size.v, size.w}))),
                member("vertex_edge", given(size.edge.valid(), [&size] {
                         return object(distance_members(size.squared_vertex_edge),
                                       member("vertex", size.vertex), member("edge", size.edge));
                       })));
}

}  // namespace

Part check_members(const Check& check) {
  const Comparison& c = check.comparison;
  return part_of(members(
      member("format", "plumbline check 3"), summary(check), member("groups", groups(check)),
      member("findings", findings(check.input, c.findings, check.causes)),
      member("conversion",
             findings(check.input, check.conversion.findings, check.conversion_causes)),
      member("feature_size", given(check.feature_size, feature_size)),
      member("ladder", given(check.ladder, ladder)), radii(check.right_radii)));
}

}  // namespace json

std::string to_json(const Check& check) {
  return json::document(json::object(json::check_members(check), json::input_members(check.input)));
}

}  // namespace plumbline
