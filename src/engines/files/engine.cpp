// A result from a file as an engine's answer.

#include "plumbline/engines/files.hpp"

#include <algorithm>

#include "plumbline/error.hpp"

namespace plumbline::files {
namespace {

constexpr const char* kName = "files";
constexpr const char* kFile = "file";

/// One finding for what each ring lacks that goes past the vertex.
Explained unsplit(const PointD& place, const FloatComplex& complex) {
  Explained result;
  Finding& finding = result.finding;
  finding.kind = CellKind::Vertex;
  finding.disagreement = Disagreement::Invalid;
  finding.invariant = Invariant::VertexOnEdge;
  finding.message =
      "a ring of the result goes past a vertex on it that a neighbour has (vertex on edge)";
  finding.where = exact(place);
  const auto at = std::lower_bound(complex.vertices.begin(), complex.vertices.end(), place);
  finding.float_cells = {static_cast<std::size_t>(at - complex.vertices.begin())};
  result.cause.stage = kName;
  result.cause.rule = "vertex-on-edge";
  result.cause.explanation = "its maker did not put the vertex into every ring that it is on";
  result.cause.advice = "put it into the ring: with it, the result is compared";
  return result;
}

}  // namespace

Answer answer(Result result) {
  Answer answer;
  answer.engine = kName;
  answer.title = result.file;
  answer.short_title = "the result";
  answer.parameters = {{kFile, result.file}};
  answer.complex = nearest(result.complex);
  answer.exact_complex = std::move(result.complex);
  answer.compared = !result.has_faces  ? Compared::Graph
                    : result.has_edges ? Compared::All
                                       : Compared::Faces;
  answer.dropped = std::move(result.rejected);
  for (const PointD& place : result.passed) {
    answer.failures.push_back(unsplit(place, answer.complex));
  }
  answer.remarks = std::move(result.remarks);
  return answer;
}

Engine engine() {
  const auto run = [](const SegmentSet& /*input*/, const Parameters& parameters,
                      std::size_t /*threads*/) {
    const auto file = parameters.find(kFile);
    if (file == parameters.end()) {
      throw Error(ErrorCode::BadInput, "the engine files needs its parameter file");
    }
    return answer(read(std::get<std::string>(file->second)));
  };
  return {kName,
          "1",
          "the result",
          {{kFile, Parameter::Type::Text, "the result of another program, as --against takes it"}},
          run};
}

}  // namespace plumbline::files
