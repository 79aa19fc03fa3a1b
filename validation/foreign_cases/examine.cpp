#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "campaigns/relations.hpp"
#include "foreign_cases/claims.hpp"
#include "foreign_cases/table.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/certificate.hpp"
#include "plumbline/write.hpp"
#include "verify/verify.hpp"

namespace foreign {

using namespace plumbline;

namespace {

/// How much an area can change when all corners of its boundary are rounded to integers, each moved
/// by half a diagonal at most: along every edge a strip, and something at every corner.
double rounding_bound(const ClippedArea& found) {
  const double moved = std::sqrt(0.5);
  return moved * (found.perimeter + moved * static_cast<double>(found.edges));
}

void examine_complex(Row& row, const SegmentSet& input) {
  const ExactComplex complex = arrange(input);
  row.vertices += complex.vertices.size();
  row.edges += complex.edge_count();
  row.faces += complex.face_count();
  row.components += complex.component_count();
  row.engines_differ += complex == arrange(input, Engine::Cgal) ? 0 : 1;
  const bool keeps_invariants =
      validate(complex).empty() && validate_coverage(complex, input).empty();
  row.invariants_broken += keeps_invariants ? 0 : 1;
  const auto verdict = plumbline_verify::verify(to_lines(input), certificate(complex, input));
  row.refused += verdict.outcome == plumbline_verify::Outcome::Proved ? 0 : 1;
  for (const campaign::Relation relation : campaign::kRelations)
    row.relations_broken += campaign::holds(relation, input, complex, row.cases) ? 0 : 1;
}

/// A geometry that cannot be read, such as one with NaN, has neither property.
bool is_so(const Claim& claim) {
  try {
    const Geometry parsed = geometry(claim.wkt);
    return claim.kind == Claim::Kind::Valid ? is_valid(parsed) : is_simple(parsed);
  } catch (const Error&) {
    return false;
  }
}

void examine_claim(Row& row, const Case& one, const Claim& claim) {
  ++row.claims;
  if (is_so(claim) == claim.holds) return;
  row.contradicted.push_back(fmt::format("{}: said to be {}{}", one.name, claim.holds ? "" : "not ",
                                         claim.kind == Claim::Kind::Valid ? "valid" : "simple"));
}

void examine_area(Row& row, const Case& one) {
  ++row.claims;
  const ClippedArea found = clipped_area(one.input, *one.area);
  const double area = nearest_double(found.area), said = nearest_double(one.area->area);
  const double difference = std::abs(area - said);
  const auto text = [&] {
    return fmt::format("{}: said to have area {}, has {}", one.name, said, area);
  };
  if (difference > rounding_bound(found)) {
    row.contradicted.push_back(text());
  } else if (constexpr double kWorthNaming = 0.01; difference > kWorthNaming * area) {
    row.differ_by_rounding.push_back(text());
  }
}

}  // namespace

Row examined(const std::filesystem::path& file, const std::string& name) {
  Row row;
  row.file = name;
  try {
    for (const Case& one : read_file(file)) {
      ++row.cases;
      row.segments += one.input.segments.size();
      row.points += one.input.points.size();
      row.rejected += one.input.rejected.size();
      for (const Rejected& rejected : one.input.rejected) ++row.rejected_by_reason[rejected.reason];
      examine_complex(row, one.input);
      for (const Claim& claim : one.claims) examine_claim(row, one, claim);
      if (one.area) examine_area(row, one);
    }
  } catch (const Error& error) {
    row.error = error.what();
    // The path is that of whoever runs this.
    if (const std::size_t at = row.error.find(file.string()); at != std::string::npos)
      row.error.replace(at, file.string().size(), file.filename().string());
  }
  return row;
}

}  // namespace foreign
