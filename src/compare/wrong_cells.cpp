#include "compare/wrong_cells.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "geometry/point_d.hpp"

namespace plumbline::compare_steps {
namespace {

/// In tolerances.
constexpr double kReach = 4;

std::size_t cell_count(const ExactComplex& complex, CellKind kind) {
  switch (kind) {
    case CellKind::Vertex:
      return complex.vertices.size();
    case CellKind::Edge:
      return complex.edge_count();
    case CellKind::Face:
      return complex.face_count();
    case CellKind::Hole:
      return complex.cycles.size();
    case CellKind::Complex:
      break;
  }
  return 0;
}

/// Whether they are the same, if the cells of one are all cells of the other.
bool is_alike(const Finding& finding, const Finding& other) {
  return finding.disagreement == other.disagreement &&
         finding.exact_cells.size() == other.exact_cells.size() &&
         finding.float_cells.size() == other.float_cells.size();
}

}  // namespace

bool takes_correspondence(const Finding& finding) {
  return finding.kind == CellKind::Hole ||
         (finding.kind == CellKind::Face && finding.exact_cells.empty());
}

WrongCells::WrongCells(const Comparison& comparison, const ExactComplex& exact_complex)
    : comparison_(comparison) {
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    by_cell_[kind].resize(cell_count(exact_complex, static_cast<CellKind>(kind)));
  }
  for (std::size_t i = 0; i < comparison.findings.size(); ++i) {
    const Finding& finding = comparison.findings[i];
    if (finding.disagreement == Disagreement::Invalid) continue;
    const auto kind = static_cast<std::size_t>(finding.kind);
    for (const std::size_t cell : finding.exact_cells) {
      if (by_cell_[kind][cell] == 0) by_cell_[kind][cell] = i + 1;
      in_findings_[kind].emplace_back(cell, i);
    }
    if (finding.exact_cells.empty()) {
      for (const SegmentId s : finding.segments) by_segment_[kind].emplace_back(s, i);
    }
  }
  for (auto& list : in_findings_) std::sort(list.begin(), list.end());
  for (auto& list : by_segment_) std::sort(list.begin(), list.end());
}

std::optional<std::size_t> WrongCells::same(const Finding& finding) const {
  const auto kind = static_cast<std::size_t>(finding.kind);
  for (const std::size_t cell : finding.exact_cells) {
    if (by_cell_[kind][cell] != 0) return by_cell_[kind][cell] - 1;
  }
  if (!finding.exact_cells.empty()) return std::nullopt;
  const auto& list = by_segment_[kind];
  for (const SegmentId s : finding.segments) {
    for (auto it = std::lower_bound(list.begin(), list.end(), std::pair(s, std::size_t{0}));
         it != list.end() && it->first == s; ++it) {
      if (is_near(finding, comparison_.findings[it->second])) return it->second;
    }
  }
  return finding.segments.empty() ? same_place(finding) : std::nullopt;
}

/// Of a face that only the float side has, and of which no segments are known: another one in the
/// same exact face, with its place there.
std::optional<std::size_t> WrongCells::same_place(const Finding& finding) const {
  if (finding.kind != CellKind::Face || !finding.lies_in) return std::nullopt;
  for (std::size_t i = 0; i < comparison_.findings.size(); ++i) {
    const Finding& other = comparison_.findings[i];
    const bool is_alike = other.kind == CellKind::Face && other.exact_cells.empty() &&
                          other.lies_in == finding.lies_in;
    if (is_alike &&
        distance(nearest(finding.where), nearest(other.where)) <= kReach * comparison_.tolerance) {
      return i;
    }
  }
  return std::nullopt;
}

/// Vertices that only the float side has may lie on the same segment and be two: not if they are
/// within what stages move them.
bool WrongCells::is_near(const Finding& finding, const Finding& other) const {
  if (finding.kind != CellKind::Vertex || comparison_.tolerance == 0) return true;
  return distance(nearest(finding.where), nearest(other.where)) <= kReach * comparison_.tolerance;
}

std::size_t WrongCells::extent(const Finding& finding) const {
  if (finding.exact_cells.empty()) return has(finding) ? whole(finding) : 0;
  const auto kind = static_cast<std::size_t>(finding.kind);
  const auto& list = in_findings_[kind];
  std::unordered_map<std::size_t, std::size_t> shared;  // by finding
  std::size_t most = 0;
  for (const std::size_t cell : finding.exact_cells) {
    for (auto it = std::lower_bound(list.begin(), list.end(), std::pair(cell, std::size_t{0}));
         it != list.end() && it->first == cell; ++it) {
      const std::size_t count = ++shared[it->second];
      most = std::max(most, count);
      if (count == finding.exact_cells.size() &&
          is_alike(finding, comparison_.findings[it->second])) {
        return whole(finding);
      }
    }
  }
  return most;
}

bool WrongCells::has(const Finding& finding) const { return same(finding).has_value(); }

}  // namespace plumbline::compare_steps
