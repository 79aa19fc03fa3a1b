#include "mutations/mutations.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "plumbline/check/groups.hpp"
#include "plumbline/polygons.hpp"

namespace plumbline::mutations {
namespace {

struct Box {
  Point low, high;
  bool contains(const Point& p) const {
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y;
  }
};

Box box_of(const std::vector<Point>& points) {
  Box box{points.at(0), points.at(0)};
  for (const Point& p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

constexpr std::size_t kMostListed = 12;

std::string listed(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& f : std::span(findings).first(std::min(findings.size(), kMostListed))) {
    text += "  " + to_text(Name{f.kind, f.disagreement, f.invariant}) + " at " + to_text(f.where) +
            ": " + f.message + '\n';
  }
  return text;
}

/// What is left of a complex where its faces are written as polygons.
ExactComplex of_polygons(const ExactComplex& complex) {
  Drawing drawing{ExactComplex{}};
  for (const FacePolygon& polygon : polygons(complex)) {
    const auto add = [&](std::span<const VertexId> ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        drawing.add(complex.vertices[ring[i]], complex.vertices[ring[(i + 1) % ring.size()]]);
      }
    };
    add(polygon.outer);
    for (std::size_t h = 0; h < polygon.holes.size(); ++h) add(polygon.holes[h]);
  }
  return drawing.arranged();
}

}  // namespace

Name broken(Invariant invariant) { return {CellKind::Complex, Disagreement::Invalid, invariant}; }

std::string to_text(const Name& name) {
  if (name.disagreement == Disagreement::Invalid) {
    return "invalid " + (name.invariant ? to_text(*name.invariant) : "");
  }
  return to_text(name.kind) + ' ' + to_text(name.disagreement);
}

bool bears(const Finding& finding, const Name& name) {
  const bool is_kind = name.disagreement == Disagreement::Invalid || finding.kind == name.kind;
  return is_kind && finding.disagreement == name.disagreement &&
         finding.invariant == name.invariant;
}

std::string miss(const ExactComplex& right, const Broken& broken) {
  const Comparison result = compare(right, broken.complex, broken.tolerance);
  const Box box = box_of(broken.places);
  std::string wrong;
  for (const Name& name : broken.names) {
    const auto is_named = [&](const Finding& f) { return bears(f, name); };
    const auto is_there = [&](const Finding& f) { return is_named(f) && box.contains(f.where); };
    const auto& findings = result.findings;
    if (std::any_of(findings.begin(), findings.end(), is_there)) continue;
    wrong += to_text(name) + (std::any_of(findings.begin(), findings.end(), is_named)
                                  ? " is not in its place\n"
                                  : " is not found\n");
  }
  const auto groups = group_findings(result, {}, right, nearest(broken.complex));
  if (groups.size() > broken.groups) {
    wrong += "found in " + std::to_string(groups.size()) + " groups:";
    for (const FindingGroup& group : groups) {
      wrong += " [";
      for (const std::size_t number : group.findings) wrong += " " + std::to_string(number);
      wrong += " ]";
    }
    wrong += '\n';
  }
  return wrong.empty() ? wrong : wrong + listed(result.findings);
}

std::string false_alarm(const ExactComplex& right) {
  const Comparison itself = compare(right, right, 0);
  if (!itself.agree()) return "itself:\n" + listed(itself.findings);
  const Comparison lines = compare(right, right, 0, Compared::Graph);
  if (!lines.agree()) return "its lines alone:\n" + listed(lines.findings);
  const Comparison polygons = compare(right, of_polygons(right), 0, Compared::Faces);
  if (!polygons.agree()) return "its polygons alone:\n" + listed(polygons.findings);
  const FloatComplex rounded = nearest(right);
  if (!validate(exact(rounded)).empty()) return {};  // not a right result
  double largest = 0;
  for (const PointD& p : rounded.vertices) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  const Comparison doubles = compare(right, rounded, 0x1p-52 * largest);
  return doubles.agree() ? std::string() : "its nearest doubles:\n" + listed(doubles.findings);
}

std::vector<Mutation> all() {
  std::vector<Mutation> result;
  for (const auto* list : {&of_drawings(), &of_places(), &of_incidences(), &of_cells()}) {
    result.insert(result.end(), list->begin(), list->end());
  }
  return result;
}

}  // namespace plumbline::mutations
