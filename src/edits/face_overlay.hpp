#pragma once

#include <array>
#include <map>
#include <vector>

#include "plumbline/complex.hpp"
#include "plumbline/edits.hpp"

namespace plumbline::edits {

/// Before and after a repair.
enum Side : std::size_t { Before, After };
inline constexpr std::array<Side, 2> kSides = {Before, After};
template <class T>
using Both = std::array<T, 2>;
using Complexes = Both<const ExactComplex*>;

/// Per side the bounded faces, ascending, whose boundary is not there on the other side with the
/// same cells.
Both<std::vector<FaceId>> changed_faces(const Complexes& complexes);

/// Both drawings of the borders of some faces in one arrangement, cut at ends of edits' lines.
struct FaceOverlay {
  ExactComplex complex;
  Both<std::vector<FaceId>> face;     ///< per side and face of the overlay the face around it
  Both<std::vector<bool>> is_border;  ///< per side and edge
};
FaceOverlay overlay(const Complexes& complexes, const Both<std::vector<FaceId>>& faces,
                    const std::vector<Edit>& edits);

}  // namespace plumbline::edits
