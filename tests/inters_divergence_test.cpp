// Where the published pipeline is wrong and the repaired one is not: each entry of
// docs/divergences.md with both results. Published results are those recorded of the original;
// repaired ones are the counts of an exact arrangement.

#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>

#include "plumbline/arrange.hpp"
#include "plumbline/engines/inters.hpp"
#include "plumbline/engines/inters_stages.hpp"
#include "plumbline/engines/lar_stages.hpp"
#include "plumbline/pipeline.hpp"
#include "support/recorded.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

inters::Trace run_published(const std::string& text) {
  return inters::run(inters::lines(segments(text)));
}

/// "V 6 E 6 F 1" with the faces of larFromLines, "none" where it has no result, then failures.
std::string published_summary(const std::string& text) {
  const inters::Trace trace = run_published(text);
  std::ostringstream summary;
  summary << "V " << trace.lar.vertices.size() << " E " << trace.lar.edges.size() << " F ";
  if (trace.lar_from_lines) {
    summary << trace.lar_from_lines->faces.size();
  } else {
    summary << "none";
  }
  if (trace.largest && trace.largest->aborted) summary << " aborted";
  for (const inters::Failure& failure : trace.failures) {
    const bool matters = failure.stage == "buckets" || failure.stage == "components" ||
                         failure.stage == "larFromLines";
    if (matters) summary << "; " << failure.stage << ": " << failure.error;
  }
  return summary.str();
}

/// The repaired result with the radius at the published one's place.
std::string repaired_summary(const std::string& text, double radius = 1e-9) {
  return summary(lar::arrange(segments(text), {radius}).complex);
}

/// Segments of the recorded cases.
std::string recorded_text(const std::string& name) {
  const rapidjson::Document cases = recorded("inters.json");
  for (const auto& recorded_case : cases.GetArray()) {
    if (recorded_case["case"].GetString() != name) continue;
    std::string text;
    for (const SegmentD& s : recorded_lines(recorded_case["lines"])) {
      for (const double c : {s.a.x, s.a.y, s.b.x, s.b.y}) text += shortest_text(c) + ' ';
    }
    return text;
  }
  throw std::runtime_error("no case " + name);
}

/// Sizes of the biconnected components.
std::string component_sizes(const inters::Trace& trace) {
  std::string text;
  for (const auto& component : trace.components) text += std::to_string(component.size()) + ' ';
  return text;
}

const inters::Vcode kVcode(inters::kDecimals);

}  // namespace

TEST_CASE("I: intersection") {
  using Row = std::tuple<std::string, std::string, std::string, std::string>;
  const auto [id, text, of_published, of_repaired] =
      GENERATE_COPY(table<std::string, std::string, std::string, std::string>(
          {Row{"I1 collinear overlaps are not split", "0 0 2 0  1 0 3 0", "V 4 E 2 F none",
               "V 4 E 3 F 1 C 1 antennas 3"},
           Row{"I2 a wall of two overlapping strokes makes no room",
               rectangle(0, 0, 3, 3) + "0 1 2 1  1 1 3 1", "V 8 E 8 F 1", "V 8 E 9 F 3 C 1"},
           Row{"I3 an integer T junction is missed", rectangle(0, 0, 7, 11) + "0 1 7 1",
               "V 6 E 6 F 1", "V 6 E 7 F 3 C 1"},
           Row{"I5 a slanted T junction is missed",
               "0.943 0.648 1.343 0.263  1.023 0.571 0.543 0.573", "V 4 E 2 F none",
               "V 4 E 3 F 1 C 1 antennas 3"},
           Row{"I6 a long crossing stays open", "0 0 20 0  6.667 -5 6.667 5", "V 6 E 4 F none",
               "V 5 E 4 F 1 C 1 antennas 4"},
           Row{"I7 a small drawing collapses", recorded_text("scale-orthogonal-8-x0.0001"),
               "V 1 E 0 F none; components: ValueError", "V 13 E 16 F 5 C 1 antennas 2"},
           Row{"I9 equal heights leave a half empty", "0 0.7 0.5 0.7  1 0.7 1.5 0.7  2 0.7 2.5 0.7",
               "V 0 E 0 F none; buckets: IndexError", "V 6 E 3 F 1 C 3 antennas 3"},
           Row{"I9 an empty drawing", "", "V 0 E 0 F none; buckets: IndexError",
               "V 0 E 0 F 1 C 0"}}));
  INFO(id);
  CHECK(published_summary(text) == of_published);
  CHECK(repaired_summary(text) == of_repaired);
}

TEST_CASE("I4: a corner is missed, harmlessly, where the parameter overshoots by an ulp") {
  const inters::Trace trace = run_published("0 0 7 0  7 0 7 11");
  for (const inters::Fragment& fragment : trace.fragments) CHECK(fragment.parameters.empty());
  CHECK(trace.lar.vertices.size() == 3);
  CHECK(repaired_summary("0 0 7 0  7 0 7 11") == "V 3 E 2 F 1 C 1 antennas 2");
}

TEST_CASE("I8: far from the origin 12 digits are not enough") {
  const rapidjson::Document cases = recorded("inters_digests.json");
  for (const auto& recorded_case : cases.GetArray()) {
    if (recorded_case["case"].GetString() != std::string("scale-translated-1e9")) continue;
    const auto lines = recorded_lines(recorded_case["lines"]);
    const inters::Trace trace = inters::run(lines);
    CHECK(trace.lar.vertices.size() == 66);
    CHECK(trace.lar.edges.size() == 52);
    CHECK(!trace.lar_from_lines);
    SegmentSet set;
    for (const SegmentD& s : lines) set.add(s.a, s.b, set.add_source({}));
    CHECK(summary(lar::arrange(set, {1e-5}).complex).starts_with("V 56 E 52 F 5 "));
  }
}

TEST_CASE("I10: a segment without length stays as an edge of one vertex, or is dropped") {
  const std::vector<SegmentD> lines{{{0.5, 0.5}, {0.5, 0.5}}, {{0, 0}, {1, 1}}};
  const inters::Trace trace = inters::run(lines);
  CHECK(trace.lar.vertices.size() == 3);
  CHECK(trace.lar.edges.size() == 2);
  CHECK(trace.lar.edges[0][0] == trace.lar.edges[0][1]);
  SegmentSet set;
  for (const SegmentD& s : lines) set.add(s.a, s.b, set.add_source({}));
  CHECK(summary(lar::arrange(set).complex) == "V 2 E 1 F 1 C 1 antennas 1");
}

TEST_CASE("Q: quantisation and merging") {
  using Row = std::tuple<std::string, std::string, std::string, std::string>;
  const auto [id, name, of_published, of_repaired] =
      GENERATE_COPY(table<std::string, std::string, std::string, std::string>(
          {Row{"Q1 a chain of near vertices merges whole", "degenerate-chain-radius",
               "V 6 E 5 F none", "V 28 E 38 F 12 C 1 antennas 4"},
           Row{"Q4 the face walk never ends", "divergence-merge-nontermination",
               "V 5 E 7 F none; larFromLines: NoTermination", "V 18 E 18 F 2 C 1 antennas 13"},
           Row{"Q5 Euler's relation is violated", "divergence-merge-euler0", "V 13 E 14 F 1",
               "V 15 E 14 F 2 C 2 antennas 11"},
           Row{"Q6 the face walk aborts", "divergence-merge-partial", "V 17 E 20 F 3 aborted",
               "V 24 E 27 F 5 C 1 antennas 15"},
           Row{"Q7 thin parts vanish", "degenerate-thin-rectangle", "V 2 E 1 F none",
               "V 4 E 4 F 2 C 1"}}));
  INFO(id);
  CHECK(published_summary(recorded_text(name)) == of_published);
  CHECK(repaired_summary(recorded_text(name)) == of_repaired);
}

TEST_CASE("Q5: the largest component's faces do not add up") {
  const inters::Model faces =
      run_published(recorded_text("divergence-merge-euler0")).largest->model;
  CHECK(faces.vertices.size() + faces.faces.size() - faces.edges.size() == 0);
}

TEST_CASE("Q2: rounding decides at the radius itself, in both variants, by the same rule") {
  // .001 apart; the doubles of .3 and .301 are further apart than that of .001, those of .0 are
  // not.
  const std::string exact = recorded_text("degenerate-radius-exact");
  const std::string shifted = recorded_text("degenerate-radius-exact-shifted");
  CHECK(published_summary(exact).starts_with("V 6 "));
  CHECK(published_summary(shifted).starts_with("V 8 "));
  for (const std::string& text : {exact, shifted}) {
    CHECK(repaired_summary(text, 0.00101).starts_with("V 6 "));
    CHECK(repaired_summary(text, 0.00099).starts_with("V 8 "));
  }
}

TEST_CASE("Q3: a corner drifts off the grid by the rounded parameter and the mean") {
  const inters::Trace trace = run_published(rectangle(0, 0, 7, 11) + "0 1 7 1");
  const auto& vertices = trace.lar.vertices;
  CHECK(std::count(vertices.begin(), vertices.end(), PointD{0, 1}) == 0);
  CHECK(std::count(vertices.begin(), vertices.end(), PointD{0, 0.99995}) == 1);
  const FloatComplex repaired =
      lar::arrange(segments(rectangle(0, 0, 7, 11) + "0 1 7 1"), {1e-3}).complex;
  CHECK(std::count(repaired.vertices.begin(), repaired.vertices.end(), PointD{0, 1}) == 1);
}

TEST_CASE("Q8: of 5000 random segments the face walk reports a part only") {
  const std::vector<SegmentD> lines = random_lines(5000, 0.1, 1);
  const inters::Trace trace = inters::run(lines);
  const auto decimal = [](double value) { return parse_decimal(kVcode.text(value)); };
  SegmentSet set;  // the decimals: their doubles miss some T junctions
  const SourceId source = set.add_source({});
  for (const auto& [a, b] : lines) {
    set.add({{decimal(a.x), decimal(a.y)}, {decimal(b.x), decimal(b.y)}}, source);
  }
  const ExactComplex exact_complex = arrange(set);
  CHECK(2 * trace.largest->model.faces.size() < exact_complex.face_count());
  const FloatComplex repaired = lar::arrange(set, {1e-12}).complex;
  CHECK(repaired.vertices.size() == exact_complex.vertices.size());
  CHECK(repaired.edge_count() == exact_complex.edge_count());
  CHECK(repaired.face_count() == exact_complex.face_count());
}

TEST_CASE("Q9: after merging, faces depend on the order of sets; 162 of 188 in Python 2.7's") {
  const rapidjson::Document cases = recorded("inters_digests.json");
  for (const auto& recorded_case : cases.GetArray()) {
    if (recorded_case["case"].GetString() != std::string("svgpy-inters-building")) continue;
    const auto lines = recorded_lines(recorded_case["lines"]);
    CHECK(inters::run(lines).lar_from_lines->faces.size() == 162);
    SegmentSet set;
    for (const SegmentD& s : lines) set.add(s.a, s.b, set.add_source({}));
    CHECK(lar::arrange(set, {1e-9}).complex.face_count() == 1 + 188);
  }
}

TEST_CASE("F: faces and components") {
  const std::string orthogonal =
      "0 0 6 0  0 4 10 4  0 0 0 4  3 0 3 4  6 0 6 8  3 2 6 2  10 0 10 8  0 8 10 8";
  using Row = std::tuple<std::string, std::string, std::string, std::string>;
  const auto [id, text, of_published, of_repaired] =
      GENERATE_COPY(table<std::string, std::string, std::string, std::string>(
          {Row{"F1 one component is kept", orthogonal, "V 13 E 16 F 3",
               "V 13 E 16 F 5 C 1 antennas 2"},
           Row{"F2 the one with most edges, not the largest",
               recorded_text("divergence-most-edges-not-largest"), "V 9 E 9 F 1",
               "V 9 E 9 F 3 C 2"},
           Row{"F3 holes are lost", recorded_text("divergence-hole-dropped"), "V 10 E 11 F 2",
               "V 10 E 11 F 4 C 2 holes 1 depth 2"},
           Row{"F8 no cycle is no result", "0 0 2 2  0 2 2 0", "V 5 E 4 F none",
               "V 5 E 4 F 1 C 1 antennas 4"}}));
  INFO(id);
  CHECK(published_summary(text) == of_published);
  CHECK(repaired_summary(text) == of_repaired);
}

TEST_CASE("F4: a face walk that stops at its first vertex never ends at a cut vertex") {
  const auto v = [](std::size_t i) { return VertexId(i); };
  const inters::Model dangling{{{0, 0}, {1, 0}, {0, 1}, {2, 0}},
                               {{v(0), v(1)}, {v(1), v(2)}, {v(0), v(2)}, {v(1), v(3)}},
                               {}};
  CHECK_THROWS_AS(inters::faces_from_components(dangling), inters::StageFailure);
  CHECK_THROWS_WITH(inters::faces_from_components(dangling),
                    Catch::Contains("the published facesFromComps runs for ever"));
  CHECK(repaired_summary("0 0 1 0  1 0 0 1  0 1 0 0  1 0 2 0") == "V 4 E 4 F 2 C 1 antennas 1");

  const std::string triangles = recorded_text("divergence-two-triangles-vertex-nonterm");
  const inters::Trace trace = run_published(triangles);
  CHECK(!trace.all_components);
  CHECK(repaired_summary(triangles) == "V 5 E 6 F 3 C 1");
}

TEST_CASE("F5: the exterior is taken for the faces of largest area") {
  const inters::Trace square = run_published(rectangle(0, 0, 1, 1));
  REQUIRE(square.all_components);
  CHECK(square.all_components->interior.empty());
  CHECK(repaired_summary(rectangle(0, 0, 1, 1)) == "V 4 E 4 F 2 C 1");

  const std::string siblings = recorded_text("degenerate-nested-siblings");
  CHECK(run_published(siblings).all_components->interior.size() == 8);
  CHECK(repaired_summary(siblings) == "V 20 E 20 F 6 C 5 holes 4 depth 3");
}

TEST_CASE("F6: areas are absolute and have seven digits; repaired ones are signed doubles") {
  const std::vector<PointD> vertices{{0, 0}, {1.1, 0}, {1.1, 1.1}, {0, 1.1}};
  Lists<VertexId> faces;
  faces.push_back(std::vector<VertexId>{VertexId(3), VertexId(2), VertexId(1), VertexId(0)});
  const std::vector<double> areas = inters::surface_integration({vertices, {}, faces});
  CHECK(areas[0] == Approx(1.21).epsilon(1e-6));
  CHECK(areas[0] != Approx(1.21).epsilon(1e-9));
  lar::Graph graph;
  graph.vertices = vertices;
  for (std::size_t i = 0; i < 4; ++i) graph.edges.push_back({VertexId(i), VertexId((i + 1) % 4)});
  Lists<HalfedgeId> cycles;
  std::vector<HalfedgeId> clockwise;
  for (std::size_t i = 4; i-- > 0;) clockwise.push_back(halfedge(EdgeId(i), true));
  cycles.push_back(clockwise);
  CHECK(lar::cycle_areas(graph, cycles)[0] == Approx(-1.21).epsilon(1e-14));
}

TEST_CASE("F7: long paths need no recursion, in either variant") {
  std::vector<SegmentD> lines;
  SegmentSet set;
  const int n = 20'000;
  for (int i = 0; i < n; ++i) {
    const double x = i, next = i + 1;
    lines.push_back({{x, i % 2 * 1.0}, {next, (i + 1) % 2 * 1.0}});
    set.add(lines.back().a, lines.back().b, set.add_source({}));
  }
  const inters::Trace trace = inters::run(lines);
  CHECK(trace.components.empty());
  CHECK(trace.bridges.size() == n);
  CHECK(lar::arrange(set, {1e-6}).trace.bridges.size() == n);
}

TEST_CASE("P1, P2: half crossings never count") {
  const std::vector<PointD> diamond{{2, 0}, {0, 2}, {-2, 0}, {0, -2}};
  inters::Polyline closed = diamond;
  closed.push_back(diamond.front());
  CHECK(inters::classify(std::vector<inters::Polyline>{closed}, {0, 0}) ==
        inters::Classification::Out);
  CHECK(lar::classify_points(diamond, {{{0, 0}}})[0] == lar::Position::In);
  // P2: an edge whose second end is straight to the right is no boundary for a query on its first.
  CHECK(inters::classify(std::vector<inters::Polyline>{{{0, 0}, {1, 0}}}, {0, 0}) ==
        inters::Classification::Out);
  CHECK(lar::classify_points({{{0, 0}, {1, 0}, {1, 1}}}, {{{0, 0}}})[0] == lar::Position::On);
}

TEST_CASE("P3: the polygon is quantised and the query is not") {
  const std::vector<PointD> triangle{
      {0.123456, 0.123456}, {0.923456, 0.223456}, {0.523456, 0.923456}};
  const std::vector<inters::VertexPair> edges{
      {VertexId(0), VertexId(1)}, {VertexId(1), VertexId(2)}, {VertexId(0), VertexId(2)}};
  const auto polylines = inters::boundary_polylines(triangle, edges, kVcode);
  CHECK(inters::classify(polylines, triangle[0]) == inters::Classification::Out);
  CHECK(lar::classify_points(triangle, {{triangle[0]}})[0] == lar::Position::On);
}

TEST_CASE("P4, P5: one vertex stands for a whole cycle") {
  const std::string level = recorded_text("divergence-lattice-level-vertices");
  CHECK(*run_published(level).cells == inters::CycleCells{{0}, {1}});
  CHECK(repaired_summary(level) == "V 10 E 10 F 3 C 2 holes 1 depth 2");

  const std::string touching = recorded_text("degenerate-squares-touch-vertex-inside");
  CHECK(*run_published(touching).lattice == inters::LatticeArray{{-1, 1}, {-1, -1}});
  CHECK(*run_published(touching).cells == inters::CycleCells{{0}, {1}});
  CHECK(repaired_summary(touching) == "V 6 E 7 F 3 C 1");
}

TEST_CASE("P6: components that are no simple cycles have no boundary") {
  const inters::Trace trace = run_published(rectangle(0, 0, 1, 1) + "0 0 1 1  1 0 0 1");
  REQUIRE(trace.boundary_cycles.size() == 1);
  CHECK(trace.boundary_cycles[0].failure->error == "ValueError");
  CHECK(!trace.lattice);
  CHECK(component_sizes(trace) == "8 ");
  CHECK(repaired_summary(rectangle(0, 0, 1, 1) + "0 0 1 1  1 0 0 1") == "V 5 E 8 F 5 C 1");
}

TEST_CASE("P7: nested rings are solid and void by turns") {
  const std::string rings = recorded_text("degenerate-nested-squares-5");
  CHECK(run_published(rings).cells->size() == 3);
  CHECK(repaired_summary(rings) == "V 20 E 20 F 6 C 5 holes 4 depth 5");
}

TEST_CASE("P8: edge 0 of a boundary cycle has no sign") {
  const inters::Trace trace = run_published(rectangle(0, 0, 1, 1));
  const std::vector<inters::SignedCycle>& cycles = *trace.boundary_cycles.at(0).value;
  REQUIRE(cycles.size() == 1);
  CHECK(cycles[0][0] == 0);
  const lar::Result repaired = lar::arrange(segments(rectangle(0, 0, 1, 1)));
  for (std::size_t c = 0; c < repaired.complex.cycles.size(); ++c) {
    CHECK(repaired.complex.cycles[c].size() == 4);  // halfedges: every edge has a direction
  }
}

TEST_CASE("P9: cycles that share a vertex have no boundary, or are two faces") {
  const std::vector<PointD> vertices{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {2, 2}, {1, 2}};
  const auto edge = [](std::size_t i, std::size_t j) {
    return inters::VertexPair{VertexId(i), VertexId(j)};
  };
  const std::vector<inters::VertexPair> edges{edge(0, 1), edge(1, 2), edge(2, 3), edge(0, 3),
                                              edge(2, 4), edge(4, 5), edge(5, 6), edge(2, 6)};
  CHECK_THROWS_AS(inters::boundary_polylines(vertices, edges, kVcode), inters::StageFailure);
  CHECK(repaired_summary(rectangle(0, 0, 1, 1) + rectangle(1, 1, 2, 2)) == "V 7 E 8 F 3 C 1");
}
