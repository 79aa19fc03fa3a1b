// What a group of findings comes to: its place, its size, what became of faces.

#include "plumbline/check/groups.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "check/hanging_together.hpp"

namespace plumbline {
namespace {

bool is_of_line_work(const Finding& finding) {
  return finding.kind == CellKind::Vertex || finding.kind == CellKind::Edge;
}

/// **Rounded**.
double area_of(const FloatComplex& complex, std::size_t face) {
  double twice = 0;
  const auto add = [&](CycleId cycle) {
    const PointD o = complex.vertices[complex.origin(complex.cycles[cycle].front())];
    for (const HalfedgeId h : complex.cycles[cycle]) {
      const PointD p = complex.vertices[complex.origin(h)], q = complex.vertices[complex.target(h)];
      twice += (p.x - o.x) * (q.y - o.y) - (q.x - o.x) * (p.y - o.y);
    }
  };
  add(complex.face_outer[face]);
  for (const CycleId hole : complex.face_holes[face]) add(hole);
  return twice / 2;
}

/// All of them but the largest: what changed hands where faces are joined or parted.
double all_but_largest(const std::vector<double>& areas) {
  if (areas.empty()) return 0;
  const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
  return sum - *std::max_element(areas.begin(), areas.end());
}

/// Twice the area over the perimeter: no face that is wider than that everywhere collapses within
/// this distance.
double mean_width(const ExactComplex& complex, std::size_t face, double area) {
  double perimeter = 0;
  for (const HalfedgeId h : complex.cycles[complex.face_outer[face]]) {
    const PointD p = complex.vertices.nearest(complex.origin(h)),
                 q = complex.vertices.nearest(complex.target(h));
    perimeter += std::hypot(q.x - p.x, q.y - p.y);
  }
  return perimeter > 0 ? 2 * area / perimeter : 0;
}

/// What a finding says about faces; nothing where it is about something else.
std::optional<ChangedFaces> changed_faces(const Comparison& comparison, std::size_t i,
                                          const ExactComplex& exact_complex,
                                          const FloatComplex& answer) {
  const Finding& finding = comparison.findings[i];
  if (finding.kind != CellKind::Face || finding.disagreement == Disagreement::Invalid) return {};
  ChangedFaces result;
  result.finding = i + 1;
  result.area = finding.area ? nearest_double(*finding.area) : 0;
  for (const std::size_t f : finding.exact_cells) {
    if (f == kUnbounded) continue;
    result.areas.push_back(nearest_double(face_area(exact_complex, FaceId(f))));
  }
  const bool is_outside = finding.lies_in == std::size_t{kUnbounded};
  switch (finding.disagreement) {
    case Disagreement::Missing: {
      const double width = mean_width(exact_complex, finding.exact_cells.front(), result.area);
      const bool is_opened = is_outside && width > comparison.tolerance;
      result.change = is_opened ? FaceChange::Opened : FaceChange::Lost;
      break;
    }
    case Disagreement::Extra:
      result.change = is_outside ? FaceChange::Closed : FaceChange::Added;
      result.areas = {result.area};
      break;
    case Disagreement::Merged:
      result.change = FaceChange::Joined;
      result.area += all_but_largest(result.areas);
      break;
    case Disagreement::Split: {
      result.change = FaceChange::Parted;
      std::vector<double> parts;
      for (const std::size_t f : finding.float_cells) {
        if (f != kUnbounded) parts.push_back(area_of(answer, f));
      }
      result.area += all_but_largest(parts);
      break;
    }
    default:
      result.change = FaceChange::Reshaped;
      break;
  }
  return result;
}

/// The finding to look at first: what made the largest change of faces, as far back as reasons go
/// within the group; without faces the first finding that has no reason there.
std::size_t lead_of(const FindingGroup& group, const std::vector<Finding>& findings) {
  const auto reason = [&](std::size_t number) {
    for (const std::size_t earlier : findings[number - 1].because) {
      const bool is_here =
          std::binary_search(group.findings.begin(), group.findings.end(), earlier);
      if (is_here && earlier < number) return earlier;
    }
    return std::size_t{0};
  };
  std::size_t lead = group.faces.empty() ? group.findings.front() : group.faces.front().finding;
  while (const std::size_t earlier = reason(lead)) lead = earlier;
  return lead;
}

/// The box of the cells of vertices and edges, of faces alone that of the places.
class BoxOfCells {
 public:
  BoxOfCells(const ExactComplex& exact_complex, const FloatComplex& answer)
      : exact_(exact_complex), answer_(answer) {}

  void set(FindingGroup& group, const std::vector<Finding>& findings) const {
    std::vector<PointD> points;
    for (const std::size_t number : group.findings) add(points, findings[number - 1]);
    if (points.empty()) points.push_back(nearest(findings[group.lead - 1].where));
    group.low = group.high = points.front();
    for (const PointD& p : points) {
      group.low = {std::min(group.low.x, p.x), std::min(group.low.y, p.y)};
      group.high = {std::max(group.high.x, p.x), std::max(group.high.y, p.y)};
    }
  }

 private:
  void add(std::vector<PointD>& points, const Finding& finding) const {
    if (!is_of_line_work(finding)) return;
    const auto add_cell = [&](const Incidences& complex, std::size_t cell, const auto& place) {
      if (finding.kind == CellKind::Vertex) {
        points.push_back(place(cell));
      } else {
        points.push_back(place(complex.edges.at(cell).tail));
        points.push_back(place(complex.edges.at(cell).head));
      }
    };
    for (const std::size_t cell : finding.exact_cells) {
      add_cell(exact_, cell, [&](std::size_t v) { return exact_.vertices.nearest(v); });
    }
    for (const std::size_t cell : finding.float_cells) {
      add_cell(answer_, cell, [&](std::size_t v) { return answer_.vertices.at(v); });
    }
  }

  const ExactComplex& exact_;
  const FloatComplex& answer_;
};

}  // namespace

std::string to_text(FaceChange change) {
  switch (change) {
    case FaceChange::Lost:
      return "lost";
    case FaceChange::Opened:
      return "opened";
    case FaceChange::Joined:
      return "joined";
    case FaceChange::Parted:
      return "parted";
    case FaceChange::Closed:
      return "closed";
    case FaceChange::Added:
      return "added";
    case FaceChange::Reshaped:
      return "reshaped";
  }
  return "";
}

std::vector<FindingGroup> group_findings(const Comparison& comparison,
                                         const std::vector<Cause>& causes,
                                         const ExactComplex& exact_complex,
                                         const FloatComplex& answer) {
  const std::vector<Finding>& findings = comparison.findings;
  const BoxOfCells box(exact_complex, answer);
  std::vector<std::pair<bool, FindingGroup>> groups;  // whether it makes the complex invalid
  for (const auto& members :
       check_steps::hanging_together(comparison, causes, exact_complex, answer)) {
    FindingGroup group;
    bool is_invalid = false;
    for (const std::size_t i : members) {
      group.findings.push_back(i + 1);
      is_invalid = is_invalid || findings[i].disagreement == Disagreement::Invalid;
      auto change = changed_faces(comparison, i, exact_complex, answer);
      if (!change) continue;
      group.area += change->area;
      group.faces.push_back(std::move(*change));
    }
    std::stable_sort(group.faces.begin(), group.faces.end(),
                     [](const auto& a, const auto& b) { return a.area > b.area; });
    group.lead = lead_of(group, findings);
    group.is_own = group.lead <= causes.size() && causes[group.lead - 1].stage == kDrawing;
    box.set(group, findings);
    groups.emplace_back(is_invalid, std::move(group));
  }
  std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) {
    if (a.second.is_own != b.second.is_own) return b.second.is_own;
    if (a.first != b.first) return a.first;
    if (a.second.area != b.second.area) return a.second.area > b.second.area;
    return a.second.findings.size() > b.second.findings.size();
  });
  std::vector<FindingGroup> result;
  for (auto& entry : groups) result.push_back(std::move(entry.second));
  return result;
}

}  // namespace plumbline
