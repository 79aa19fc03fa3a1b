// The names of defects and a sentence on each.

#include <fmt/format.h>

#include "diagnose/steps.hpp"

namespace plumbline {

std::string to_text(DefectKind kind) {
  switch (kind) {
    case DefectKind::Duplicate:
      return "duplicate";
    case DefectKind::Overlap:
      return "overlap";
    case DefectKind::Gap:
      return "gap";
    case DefectKind::Undershoot:
      return "undershoot";
    case DefectKind::Overshoot:
      return "overshoot";
    case DefectKind::NearMiss:
      return "near-miss";
    case DefectKind::Dangle:
      return "dangle";
    case DefectKind::Bridge:
      return "bridge";
    case DefectKind::Sliver:
      return "sliver";
    case DefectKind::ShortEdge:
      return "short edge";
    case DefectKind::NearlyParallel:
      return "nearly parallel";
    case DefectKind::InvalidRing:
      return "invalid ring";
  }
  return "unknown";
}

namespace diagnose_steps {
namespace {

std::string number(double value) { return fmt::format("{:.6g}", value); }

std::string in_edges(const Defect& defect) {
  return defect.edges.size() == 1 ? "" : fmt::format(", in {} edges", defect.edges.size());
}

/// How far apart the ends of a line of several edges are.
std::string apart(const Subject& subject, const Defect& dangle) {
  if (dangle.edges.size() == 1) return "";
  const auto& vertices = subject.graph.complex().vertices;
  const Rational squared =
      squared_distance(vertices[dangle.vertices[0]], vertices[dangle.vertices[1]]);
  return fmt::format(", {} apart", number(nearest_sqrt(squared)));
}

std::string loose_line(const Subject& subject, const Defect& dangle, const std::string& size) {
  if (dangle.vertices.size() == 2) {
    return fmt::format("a line of length {}{} has two loose ends{}", size, in_edges(dangle),
                       apart(subject, dangle));
  }
  const Chain line = subject.graph.chain(dangle.vertices[0], dangle.edges[0]);
  return goes_beyond(subject, line)
             ? fmt::format("a line goes {}{} beyond the last one that it crosses", size,
                           in_edges(dangle))
             : fmt::format("a line of length {}{} has a loose end", size, in_edges(dangle));
}

}  // namespace

namespace {

std::string sentence(const Subject& subject, const Defect& defect) {
  const std::string size = number(defect.size);
  switch (defect.kind) {
    case DefectKind::Duplicate:
      return fmt::format("{} equal segments of length {}", defect.segments.size(), size);
    case DefectKind::Overlap:
      return fmt::format("two collinear segments share {}", size);
    case DefectKind::Gap:
      return defect.vertices.size() > 2
                 ? fmt::format("{} lines end up to {} short of where they meet",
                               defect.vertices.size(), size)
                 : fmt::format("two lines end {} apart", size);
    case DefectKind::Undershoot:
      return fmt::format("a line ends {} short of another one", size);
    case DefectKind::Overshoot:
      return defect.vertices.size() == 2
                 ? fmt::format("a line goes {} beyond where one that is cut short would meet it",
                               size)
                 : fmt::format("a line goes {} beyond the one that it crosses", size);
    case DefectKind::NearMiss:
      return defect.vertices.size() == 2
                 ? fmt::format("two vertices are {} apart", size)
                 : fmt::format("a vertex is {} away from a line that it is not on", size);
    case DefectKind::Dangle:
      return loose_line(subject, defect, size);
    case DefectKind::Bridge:
      return fmt::format("a line of length {}{} is the only connection of two closed parts", size,
                         in_edges(defect));
    case DefectKind::Sliver:
      return fmt::format("a face {} wide on average, of area {}", size,
                         number(nearest_double(*defect.area)));
    case DefectKind::ShortEdge:
      return fmt::format("an edge of length {}", size);
    case DefectKind::NearlyParallel:
      return fmt::format("two lines meet at an angle of sine {}", size);
    case DefectKind::InvalidRing:
      return fmt::format("{} ({})", describe(*defect.ring, subject.input),
                         jts_name(defect.ring->fault));
  }
  return "";
}

}  // namespace

std::string describe(const Subject& subject, const Defect& defect) {
  const std::string text = sentence(subject, defect);
  if (!defect.open_area) return text;
  return fmt::format("{}, on the boundary of a face of area {} that gaps leave open", text,
                     number(*defect.open_area));
}

}  // namespace diagnose_steps
}  // namespace plumbline
