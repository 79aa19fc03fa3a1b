// Both exact engines on one drawing, compared member by member. Usage: plumbline_agreement FILE.
// Prints a row of a Markdown table without the file's name. Exit codes: 0 equal, 1 different, 2 not
// readable.

#include <fmt/format.h>

#include <iostream>

#include "plumbline/plumbline.hpp"

using namespace plumbline;

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: plumbline_agreement FILE\n";
    return 2;
  }
  const SegmentSet input = evaluate(read(argv[1]));
  const ExactComplex one = arrange(input, ExactEngine::Bucket, {1, {}});
  const bool threads_agree = arrange(input, ExactEngine::Bucket, {3, {}}) == one;
  const bool engines_agree = arrange(input, ExactEngine::Cgal) == one;
  const auto text = [](bool agree) { return agree ? "equal" : "**DIFFERENT**"; };
  fmt::print("{} | {} | {} | {} | {} | {} | {}\n", input.segments.size(), input.rejected.size(),
             one.vertices.size(), one.edge_count(), one.face_count(), text(engines_agree),
             text(threads_agree));
  return engines_agree && threads_agree ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
