// Numbers and names for the report.

#include <algorithm>
#include <array>

#include "plumbline/crosscheck.hpp"

namespace plumbline {

Counts counts(const Incidences& complex, std::size_t vertex_count) {
  Counts result;
  result.vertices = vertex_count;
  result.edges = complex.edge_count();
  result.faces = complex.face_count();
  for (std::size_t f = 1; f < complex.face_count(); ++f)
    result.holes += complex.face_holes[f].size();
  result.isolated_vertices = complex.face_isolated_vertices.flat().size();
  result.components = complex.component_count();
  for (std::size_t e = 0; e < complex.edge_count(); ++e)
    if (complex.is_antenna(EdgeId(e))) ++result.antennas;
  for (const std::uint32_t depth : complex.face_depth)
    result.depth = std::max<std::size_t>(result.depth, depth);
  return result;
}

std::string to_text(CellKind kind) {
  switch (kind) {
    case CellKind::Vertex:
      return "vertex";
    case CellKind::Edge:
      return "edge";
    case CellKind::Face:
      return "face";
    case CellKind::Hole:
      return "hole";
    case CellKind::Complex:
      break;
  }
  return "complex";
}

std::string to_text(Stage stage) {
  static constexpr std::array kNames = {
      "parse",     "transform",  "quantise", "bucket",           "intersect",
      "order",     "prune",      "simplify", "component filter", "edge order",
      "face walk", "outer face", "nesting",  "foreign"};
  return kNames.at(static_cast<std::size_t>(stage));
}

std::string to_text(Disagreement disagreement) {
  switch (disagreement) {
    case Disagreement::Invalid:
      return "invalid";
    case Disagreement::Missing:
      return "missing";
    case Disagreement::Extra:
      return "extra";
    case Disagreement::Merged:
      return "merged";
    case Disagreement::Split:
      return "split";
    case Disagreement::Reshaped:
      return "reshaped";
    case Disagreement::Moved:
      return "moved";
    case Disagreement::WrongParent:
      break;
  }
  return "wrong parent";
}

}  // namespace plumbline
