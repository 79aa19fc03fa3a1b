#pragma once

// The steps of the check, in order. Each requires those before it to have passed; each throws a
// Refusal where the certificate is wrong.

#include <vector>

#include "certificate.hpp"
#include "input.hpp"

namespace plumbline_checker {

/// Every segment is the chain of the edges that name it, and all vertices of these lie on it.
void check_covering(const Input& input, const Certificate& certificate);

/// Every vertex is there for the first reason that applies; every point of the input is a vertex.
void check_reasons(const Input& input, const Certificate& certificate);

/// What the sweep knows once it has proved that no two edges meet except at common vertices.
struct Sweep {
  std::vector<Index> next;     ///< of each halfedge, with the same face on its left
  std::vector<Index> topmost;  ///< of each vertex the steepest edge to the right, or kNone
  std::vector<Index> below;    ///< of each vertex without edges to the left the edge next below
};
Sweep check_planarity(const Input& input, const Certificate& certificate);

struct Cycles {
  Lists halfedges;              ///< of each cycle
  std::vector<Index> cycle_of;  ///< of each halfedge
};
/// The cycles are the orbits of `next`.
Cycles check_cycles(const Certificate& certificate, const std::vector<Index>& next);

struct Face {
  Index outer = kNone, depth = 0, parent = kNone;
  std::vector<Index> holes, isolated;
};
/// Components, faces, their nesting, and Euler's relation.
std::vector<Face> check_faces(const Certificate& certificate, const Sweep& sweep,
                              const Cycles& cycles);

/// The point inside each face is the one that the format names.
void check_inside(const Input& input, const Certificate& certificate, const Cycles& cycles,
                  const std::vector<Face>& faces);

/// The signature is that of the content.
void check_signature(const Certificate& certificate, const Lists& cycles,
                     const std::vector<Face>& faces);

}  // namespace plumbline_checker
