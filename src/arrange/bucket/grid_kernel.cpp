#include "arrange/bucket/grid_kernel.hpp"

namespace plumbline::bucket {
namespace {

std::vector<GridKernel::Line> narrow(const GridInput& input) {
  std::vector<GridKernel::Line> lines(input.lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t k = 0; k < lines[i].size(); ++k) {
      lines[i][k] = static_cast<std::int32_t>(input.lines[i][k]);
    }
  }
  return lines;
}

}  // namespace

GridKernel::GridKernel(const GridInput& input) : ExactLines(narrow(input), input.frame) {}

}  // namespace plumbline::bucket
