// The check from above, and what it says.

#include "verify.hpp"

#include <numeric>
#include <utility>

#include "refusal.hpp"
#include "steps.hpp"

namespace plumbline_checker {
namespace {

constexpr std::size_t kMaxBytes = 0xFFFFFFFF;

Counts check(std::string_view input_text, std::string_view certificate_text) {
  if (input_text.size() > kMaxBytes) throw BadInput{"it has 4 GiB or more", 0};
  const Input input = read_input(input_text);
  if (certificate_text.size() > kMaxBytes) throw Refusal{"it has 4 GiB or more", 0, ""};
  const Certificate certificate = read_certificate(certificate_text, input);
  check_covering(input, certificate);
  check_reasons(input, certificate);
  const Sweep sweep = check_planarity(input, certificate);
  const Cycles cycles = check_cycles(certificate, sweep.next);
  const std::vector<Face> faces = check_faces(certificate, sweep, cycles);
  check_inside(input, certificate, cycles, faces);
  check_signature(certificate, cycles.halfedges, faces);
  const auto isolated = [](std::size_t count, const Face& face) {
    return count + face.isolated.size();
  };
  return {
      .segments = input.segments.size(),
      .points = input.points.size(),
      .without_length = input.without_length,
      .vertices = certificate.vertices.size(),
      .edges = certificate.edges.size(),
      .cycles = certificate.cycles.size(),
      .faces = certificate.faces.size(),
      .components = certificate.components.size(),
      .isolated_vertices = std::accumulate(faces.begin(), faces.end(), std::size_t{0}, isolated),
      .pieces = certificate.pieces.size()};
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string proved(const Counts& n) {
  std::string text =
      "Proved: the certificate holds the planar arrangement of the " +
      counted(n.segments, "segment", "segments") + " and " +
      counted(n.points, "isolated point", "isolated points") + " of the input. Its " +
      counted(n.edges, "edge covers", "edges cover") + " the segments exactly and nothing else (" +
      counted(n.pieces, "piece", "pieces") + " of segments, each at its place); each of its " +
      counted(n.vertices, "vertex is", "vertices is") +
      " an end, a crossing or a point of the input, and no two edges meet except at common "
      "vertices. "
      "Its " +
      counted(n.cycles, "cycle is", "cycles are") + " all there " + (n.cycles == 1 ? "is" : "are") +
      " and bound its " + counted(n.faces, "face", "faces") +
      ", the unbounded one included; every one of its " +
      counted(n.components, "component", "components") + ", of which " +
      counted(n.isolated_vertices, "is an isolated vertex", "are isolated vertices") +
      ", lies in the face that it is said to lie in, and the point inside each face is the one "
      "that the "
      "format names. Euler's relation holds, V - E + F = " +
      std::to_string(n.vertices) + " - " + std::to_string(n.edges) + " + " +
      std::to_string(n.faces) + " = 1 + " + std::to_string(n.components) +
      ", everything is in canonical order, and the signature is that of the content.";
  if (n.without_length > 0) {
    text += " The input has " + counted(n.without_length, "row", "rows") +
            " of a segment without length, which " + (n.without_length == 1 ? "is" : "are") +
            " no segment.";
  }
  return text + "\n";
}

}  // namespace

Verdict verify(std::string_view input, std::string_view certificate) {
  Verdict verdict;
  try {
    verdict.counts = check(input, certificate);
  } catch (Refusal& refusal) {
    verdict.outcome = Outcome::Refused;
    verdict.reason = std::move(refusal.reason);
    verdict.line = refusal.line;
    verdict.place = std::move(refusal.place);
  } catch (BadInput& bad) {
    verdict.outcome = Outcome::BadInput;
    verdict.reason = std::move(bad.reason);
    verdict.line = bad.line;
  }
  return verdict;
}

std::string report(const Verdict& verdict) {
  if (verdict.outcome == Outcome::Proved) return proved(verdict.counts);
  std::string text =
      verdict.outcome == Outcome::Refused ? "refused: " : "the input cannot be read: ";
  if (verdict.line > 0) text += "line " + std::to_string(verdict.line) + ": ";
  text += verdict.reason;
  if (!verdict.place.empty()) text += " at " + verdict.place;
  return text + "\n";
}

}  // namespace plumbline_checker
