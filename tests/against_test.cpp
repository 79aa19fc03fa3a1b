// Recorded results of the original LAR module, held against the exact arrangements: each finds the
// divergences that the catalogue (docs/divergences.md) has for it, and nothing else.

#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "plumbline/arrange.hpp"
#include "plumbline/check.hpp"
#include "plumbline/engines/files.hpp"
#include "support/recorded.hpp"
#include "support/segments.hpp"

#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

using namespace plumbline;

namespace {

enum class Numbers { Decimals, Doubles };

SegmentSet drawing(const rapidjson::Value& lines, Numbers numbers) {
  SegmentSet set;
  const SourceId source = set.add_source({});
  const auto number = [&](double x) {
    return numbers == Numbers::Doubles ? Number(rational_from(x)) : parse_number(shortest_text(x));
  };
  const auto point = [&](const PointD& p) { return NumberPoint{number(p.x), number(p.y)}; };
  for (const auto& [a, b] : recorded_lines(lines)) set.add(point(a), point(b), source);
  return set;
}

/// V, EV and, under the name given, the faces of a recorded result as a LAR model.
std::string model_text(const rapidjson::Value& result, const char* faces) {
  rapidjson::StringBuffer text;
  rapidjson::Writer writer(text);
  writer.StartObject();
  for (const char* key : {"V", "EV", faces}) {
    if (!result.HasMember(key)) continue;
    writer.Key(key[0] == 'F' ? "FV" : key);
    result[key].Accept(writer);
  }
  writer.EndObject();
  return text.GetString();
}

/// How many findings of each kind: "edge merged"; of broken invariants only which they are, in
/// parentheses.
using Findings = std::map<std::string, int>;

Findings findings(const std::string& name, const char* stage, Numbers numbers) {
  static const rapidjson::Document cases = recorded("inters.json");
  for (const auto& recorded_case : cases.GetArray()) {
    if (recorded_case["case"].GetString() != name) continue;
    const auto& result = recorded_case["outputs"][stage];
    const char* const faces = result.HasMember("FV_interior") ? "FV_interior" : "FV";
    const SegmentSet input = drawing(recorded_case["lines"], numbers);
    CheckOptions options;
    options.tolerance = 0.001;
    const Check check =
        plumbline::check(input, arrange(input),
                         files::answer(files::read_lar(model_text(result, faces), name)), options);
    Findings list;
    for (const Finding& f : check.comparison.findings) {
      if (f.invariant) {
        list["(" + to_text(*f.invariant) + ")"] = 1;
      } else {
        ++list[to_text(f.kind) + " " + to_text(f.disagreement)];
      }
    }
    return list;
  }
  throw std::runtime_error("no case " + name);
}

/// The same whether numbers are read as decimals or as doubles.
Findings findings(const std::string& name, const char* stage) {
  const Findings list = findings(name, stage, Numbers::Decimals);
  CHECK(findings(name, stage, Numbers::Doubles) == list);
  return list;
}

}  // namespace

TEST_CASE("against: I1, I2: collinear overlaps are never split") {
  CHECK(findings("degenerate-collinear-overlap", "lar") ==
        Findings{{"(vertex on edge)", 1}, {"edge merged", 1}, {"edge split", 1}});
  CHECK(findings("degenerate-collinear-overlap-in-box", "larFromLines") ==
        Findings{{"vertex missing", 2}, {"edge missing", 3}, {"face merged", 1}});
  CHECK(findings("svg-inters-house", "lar") ==
        Findings{{"(vertex on edge)", 1}, {"edge split", 1}});
}

TEST_CASE("against: I3, I4: a T junction is missed where a parameter overshoots 1") {
  CHECK(findings("divergence-room-7x11-wall", "lar") ==
        Findings{{"(vertex on edge)", 1}, {"edge merged", 1}});
  CHECK(
      findings("divergence-room-7x11-wall", "larFromLines") ==
      Findings{{"vertex missing", 1}, {"edge merged", 1}, {"edge missing", 1}, {"face merged", 1}});
  CHECK(findings("divergence-corner-7-11", "lar").empty());
}

TEST_CASE("against: I5: a slanted T junction is missed in decimals, and is none in doubles") {
  CHECK(findings("divergence-slanted-t-missed", "lar", Numbers::Decimals) ==
        Findings{{"edge merged", 1}});
  CHECK(findings("divergence-slanted-t-missed", "lar", Numbers::Doubles).empty());
}

TEST_CASE("against: I6, I7: rounded parameters move crossings, a small drawing collapses") {
  CHECK(findings("divergence-long-cross-params", "lar") ==
        Findings{
            {"(vertex on edge)", 1}, {"vertex extra", 1}, {"edge missing", 2}, {"edge extra", 2}});
  CHECK(findings("scale-orthogonal-8-x0.0001", "lar") ==
        Findings{{"vertex merged", 1}, {"edge merged", 1}});
}

TEST_CASE("against: I10: a segment without length stays as an edge of one vertex") {
  CHECK(findings("degenerate-point-segment", "lar") ==
        Findings{{"(index)", 1}, {"vertex extra", 1}, {"edge extra", 1}});
}

TEST_CASE("against: Q2: at the radius, rounding decides what merges") {
  CHECK(findings("degenerate-radius-exact", "lar") ==
        Findings{{"vertex merged", 2}, {"edge merged", 3}});
  CHECK(findings("degenerate-radius-exact-shifted", "lar").empty());
}

TEST_CASE("against: Q5, Q7: merging makes edges cross, and thin parts vanish") {
  CHECK(findings("divergence-merge-euler0", "lar") ==
        Findings{{"(crossing)", 1}, {"vertex merged", 1}});
  const Findings walked = findings("divergence-merge-euler0", "larFromLines");
  CHECK(walked.contains("(crossing)"));
  CHECK(walked.contains("(euler)"));
  CHECK(findings("degenerate-thin-rectangle", "lar") ==
        Findings{{"vertex merged", 2}, {"edge merged", 3}});
}

TEST_CASE("against: F1, F2, F3: one component is kept, that of most edges; holes are lost") {
  CHECK(findings("seed-orthogonal-8", "lar").empty());
  CHECK(findings("seed-orthogonal-8", "larFromLines") ==
        Findings{{"vertex missing", 5}, {"edge missing", 6}, {"face missing", 1}});
  CHECK(findings("divergence-most-edges-not-largest", "larFromLines") ==
        Findings{{"vertex missing", 4}, {"edge missing", 4}, {"face missing", 1}});
  CHECK(findings("divergence-hole-dropped", "larFromLines") ==
        Findings{
            {"vertex missing", 4}, {"edge missing", 4}, {"face missing", 1}, {"hole missing", 1}});
}

TEST_CASE("against: F5: the face of largest area is taken for the exterior, other exteriors stay") {
  CHECK(findings("degenerate-single-square", "allComponents") ==
        Findings{{"(halfedge in cycle)", 1}, {"(euler)", 1}, {"(area)", 1}, {"face missing", 1}});
  Findings siblings = findings("degenerate-nested-siblings", "allComponents");
  std::erase_if(siblings, [](const auto& item) { return item.first.starts_with('('); });
  CHECK(siblings == Findings{{"face extra", 4}, {"face missing", 1}, {"hole missing", 1}});
}

TEST_CASE("against: what the original has right agrees") {
  for (const char* name : {"degenerate-grid-5x5", "degenerate-complete-graph-6",
                           "degenerate-square-diagonals", "seed-test12-complex"}) {
    INFO(name);
    CHECK(findings(name, "lar").empty());
    CHECK(findings(name, "larFromLines").empty());
    CHECK(findings(name, "allComponents").empty());
  }
}

TEST_CASE("what rounding alone makes is laid to parsing, the rest to the maker of the result") {
  // (4.3, 0.1) lies on the wall in decimals, 1e-16 above it over doubles; a far wall is left out.
  const SegmentSet input = segments("4 0 4.9 0.3  4.3 0.1 4.5 2  20 0 21 0");
  const files::Result result = files::read_lar(
      R"({"V": [[4, 0], [4.9, 0.3], [4.3, 0.1], [4.5, 2]], "EV": [[0, 1], [2, 3]]})", "result");
  const Check check = plumbline::check(input, arrange(input), files::answer(result));
  std::set<std::pair<std::string, std::string>> causes;
  for (const Cause& cause : check.causes) causes.emplace(cause.stage, cause.rule);
  CHECK(check.causes.size() == check.comparison.findings.size());
  CHECK(causes == std::set<std::pair<std::string, std::string>>{{"parse", "decimal-to-double"},
                                                                {"files", "edge-missing"},
                                                                {"files", "vertex-missing"}});
}
