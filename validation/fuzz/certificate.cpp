// Certificates: an input and the certificate after it, which starts where its title does. Whatever
// they say, they are refused or proved; and what is proved is planar, which is found out here by
// comparing everything with everything. The certificate is also taken with the signature of what it
// says, so that the signature does not hide what comes before it.

#include <gmpxx.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <vector>

#include "certificates/text.hpp"
#include "checker/verify.hpp"

using plumbline_checker::Outcome;
using plumbline_checker::Verdict;

namespace {

struct Point {
  mpq_class x, y;
};
struct Graph {
  std::vector<Point> vertices;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
};

[[noreturn]] void fail(const char* why) {
  std::fprintf(stderr, "broken promise: %s\n", why);
  std::abort();
}

/// Vertices and edges of a certificate that was proved.
Graph graph_of(const std::string& text, const plumbline_checker::Counts& counts) {
  const std::vector<std::string> lines = plumbline::certificates::lines_of(text);
  Graph graph;
  for (std::size_t v = 0; v < counts.vertices; ++v) {
    std::istringstream fields(lines.at(3 + v));
    Point& p = graph.vertices.emplace_back();
    if (!(fields >> p.x >> p.y)) fail("a vertex without coordinates was proved");
  }
  for (std::size_t e = 0; e < counts.edges; ++e) {
    std::istringstream fields(lines.at(4 + counts.vertices + e));
    auto& [tail, head] = graph.edges.emplace_back();
    if (!(fields >> tail >> head)) fail("an edge without ends was proved");
  }
  return graph;
}

/// The side of the line through an edge that a point is on.
int side(const Graph& graph, std::size_t edge, const Point& p) {
  const Point& a = graph.vertices.at(graph.edges[edge].first);
  const Point& b = graph.vertices.at(graph.edges[edge].second);
  return sgn(mpq_class((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)));
}

bool is_strictly_within(const Graph& graph, std::size_t edge, const Point& p) {
  const Point& a = graph.vertices.at(graph.edges[edge].first);
  const Point& b = graph.vertices.at(graph.edges[edge].second);
  const auto before = [](const Point& s, const Point& t) {
    return s.x < t.x || (s.x == t.x && s.y < t.y);
  };
  return side(graph, edge, p) == 0 && before(a, p) && before(p, b);
}

void check_planarity(const Graph& graph) {
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    for (const Point& p : graph.vertices) {
      if (is_strictly_within(graph, e, p)) fail("a vertex on an edge was proved");
    }
    const auto are_apart = [&](std::size_t line, std::size_t other) {
      return side(graph, line, graph.vertices.at(graph.edges[other].first)) *
                 side(graph, line, graph.vertices.at(graph.edges[other].second)) <
             0;
    };
    for (std::size_t f = 0; f < e; ++f) {
      if (graph.edges[f] == graph.edges[e]) fail("two equal edges were proved");
      if (are_apart(e, f) && are_apart(f, e)) fail("two edges that cross were proved");
    }
  }
}

void check(std::string_view input, const std::string& certificate) {
  const Verdict verdict = plumbline_checker::verify(input, certificate);
  if (plumbline_checker::report(verdict).empty()) fail("an empty report");
  if (verdict.outcome != Outcome::Proved) {
    if (verdict.reason.empty()) fail("a refusal without a reason");
    return;
  }
  constexpr std::size_t kMostEdges = 100;  // so that all pairs take no time
  if (verdict.counts.edges <= kMostEdges) check_planarity(graph_of(certificate, verdict.counts));
  const std::string spaced = std::string(input) + "\r\n \n";
  if (plumbline_checker::verify(spaced, certificate).outcome != Outcome::Proved) {
    fail("blank rows make a difference");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t start = std::min(text.find("plumbline certificate"), size);
  const std::string certificate(text.substr(start));
  check(text.substr(0, start), certificate);
  check(text.substr(0, start), plumbline::certificates::with_signature(certificate));
  return 0;
}
