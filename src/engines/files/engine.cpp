// A result from a file as an engine's answer.

#include "plumbline/engines/files.hpp"

#include "plumbline/error.hpp"

namespace plumbline::files {
namespace {

constexpr const char* kName = "files";
constexpr const char* kFile = "file";

}  // namespace

Answer answer(Result result) {
  Answer answer;
  answer.engine = kName;
  answer.title = result.file;
  answer.short_title = "the result";
  answer.parameters = {{kFile, result.file}};
  answer.complex = nearest(result.complex);
  answer.exact_complex = std::move(result.complex);
  answer.compared = result.has_faces ? Compared::All : Compared::Graph;
  answer.dropped = std::move(result.rejected);
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
