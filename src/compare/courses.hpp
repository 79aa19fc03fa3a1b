#pragma once

#include "compare/contacts.hpp"

namespace plumbline::compare_steps {

/// What a piece of an edge runs through on the other side: the inside of a face, or along a
/// halfedge.
struct Course {
  FaceId face;
  HalfedgeId along;  ///< in the direction of the edge; invalid: inside the face
};
/// A piece of an edge between successive contacts.
struct Piece {
  const Point *from = nullptr, *to = nullptr;  ///< in the direction of the edge
  Course course;
};

/// Says where the pieces of edges run.
class Courses {
 public:
  /// Keeps references.
  Courses(const Sides& sides, const CommonPoints& points, const Contacts& contacts);

  /// The pieces of an edge, in its direction. An edge that has no contact is one piece, which runs
  /// through no face yet: see `is_free`.
  std::vector<Piece> pieces(Side side, EdgeId e) const;
  bool is_free(Side side, EdgeId e) const { return contacts_.of_edge[side][e].empty(); }
  /// Whether an end of an edge is a contact.
  bool is_contact(Side side, EdgeId e, VertexId end) const;

 private:
  enum class Way { Forward, Backward };  ///< from an edge's tail to its head; back

  Course from(Side there, const Contact& contact, std::size_t towards, Way way) const;
  Course from_vertex(Side there, VertexId w, std::size_t towards, Way way) const;
  Course along(Side there, HalfedgeId h) const;
  std::vector<HalfedgeId> around(Side side, VertexId v) const;

  const Sides& sides_;
  const CommonPoints& points_;
  const Contacts& contacts_;
  Both<std::vector<std::vector<HalfedgeId>>> around_;  ///< per vertex that is a contact
};

}  // namespace plumbline::compare_steps
