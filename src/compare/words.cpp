// The names of what findings say.

#include "plumbline/compare.hpp"

namespace plumbline {

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

std::string to_text(Compared compared) {
  switch (compared) {
    case Compared::All:
      return "all";
    case Compared::Graph:
      return "graph";
    case Compared::Faces:
      return "faces";
    case Compared::SomeFaces:
      return "some faces";
    case Compared::Nothing:
      return "nothing";
  }
  return "";
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
