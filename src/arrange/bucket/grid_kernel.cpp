#include "arrange/bucket/grid_kernel.hpp"

#include <algorithm>

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

/// Whether WidePoints hold all crossings of lines on this grid. With coordinates of b bits,
/// fractions have 2 b + 3 bits (see Arithmetic); x is a coordinate in the drawing, of c + 1 bits,
/// times one of them, and a difference of b + 1 bits times another; w is a fraction and the scale.
bool are_crossings_wide(const GridInput& input) {
  const auto bits = [](const mpz_class& z) {
    return static_cast<int>(mpz_sizeinbase(z.get_mpz_t(), 2));
  };
  const Frame& frame = input.frame;
  const int b = bits(to_mpz(input.largest));
  const int c = std::max({b, bits(frame.x), bits(frame.y)});
  const bool are_small =
      frame.scale.fits_slong_p() && frame.x.fits_slong_p() && frame.y.fits_slong_p();
  return are_small && std::max(c + 1, bits(frame.scale)) + 2 * b + 4 <= WidePoint::kBits;
}

}  // namespace

GridKernel::GridKernel(const GridInput& input) : ExactLines(narrow(input), input.frame) {
  if (!are_crossings_wide(input)) return;
  wide_scale_ = input.frame.scale.get_si();
  wide_x_ = input.frame.x.get_si();
  wide_y_ = input.frame.y.get_si();
}

}  // namespace plumbline::bucket
