#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "campaign/relations.hpp"
#include "checker/verify.hpp"
#include "foreign/claims.hpp"
#include "foreign/table.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/output.hpp"

namespace plumbline::foreign {

namespace {

/// How much an area can change when each corner of a boundary moves by as much as the claim says:
/// along every edge a strip, and something at every corner.
double rounding_bound(const ClippedArea& found, const AreaClaim& claim) {
  const double length = std::max(found.perimeter, claim.perimeter);
  return claim.rounding * (length + claim.rounding * static_cast<double>(found.edges));
}

void examine_complex(Row& row, const SegmentSet& input) {
  const ExactComplex complex = arrange(input);
  row.vertices += complex.vertices.size();
  row.edges += complex.edge_count();
  row.faces += complex.face_count();
  row.components += complex.component_count();
  row.engines_differ += complex == arrange(input, ExactEngine::Cgal) ? 0 : 1;
  const bool keeps_invariants =
      validate(complex).empty() && validate_coverage(complex, input).empty();
  row.invariants_broken += keeps_invariants ? 0 : 1;
  const auto verdict = plumbline_checker::verify(to_lines(input), certificate(complex, input));
  row.refused += verdict.outcome == plumbline_checker::Outcome::Proved ? 0 : 1;
  for (const campaign::Relation relation : campaign::kRelations) {
    row.relations_broken += campaign::holds(relation, input, complex, row.cases) ? 0 : 1;
  }
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

void examine_area(Row& row, const Case& one, const AreaClaim& claim) {
  ++row.claims;
  const ClippedArea found = clipped_area(one.input, claim);
  const double area = nearest_double(found.area), said = nearest_double(claim.area);
  const double difference = nearest_double(abs(found.area - claim.area));
  const auto text = [&] {
    return fmt::format("{}: said to have area {}, has {}", one.name, said, area);
  };
  if (difference > rounding_bound(found, claim)) {
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
      for (const AreaClaim& claim : one.areas) examine_area(row, one, claim);
      for (const std::string& operation : one.unexamined) ++row.unexamined[operation];
    }
  } catch (const Error& error) {
    row.error = error.what();
    // The path is that of whoever runs this.
    if (const std::size_t at = row.error.find(file.string()); at != std::string::npos) {
      row.error.replace(at, file.string().size(), file.filename().string());
    }
  }
  return row;
}

}  // namespace plumbline::foreign
