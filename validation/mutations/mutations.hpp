#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mutations/parts.hpp"
#include "plumbline/compare.hpp"

/// Ways to break a right result, each with what the comparison must call it.
namespace plumbline::mutations {

/// The name that a finding must bear.
struct Name {
  CellKind kind;
  Disagreement disagreement;
  std::optional<Invariant> invariant = {};

  friend bool operator==(const Name&, const Name&) = default;
};
/// Of Invalid, the kind does not matter: an invariant has one name.
Name broken(Invariant invariant);
std::string to_text(const Name& name);
bool bears(const Finding& finding, const Name& name);

/// A broken result: the comparison with the right one must give a finding of each name in the box
/// around the places.
struct Broken {
  ExactComplex complex;
  double tolerance = 0;
  std::vector<Name> names;
  std::vector<Point> places;
  /// At most so many groups of findings: one, or two where something is gone in one place and there
  /// is something in another that nothing connects with it; more where the break is in many places.
  std::size_t groups = 1;
};

struct Mutation {
  const char* name;
  /// Nothing where the result has no cell that can be broken in this way.
  std::optional<Broken> (*apply)(Right& right);
};

/// Results that are valid complexes, of other drawings.
const std::vector<Mutation>& of_drawings();
/// Vertices in other places, the incidences being as they were.
const std::vector<Mutation>& of_places();
/// Cycles, faces and holes that are wrong, the vertices being where they were.
const std::vector<Mutation>& of_incidences();
/// Vertices and edges too many or too few, the others being where they were.
const std::vector<Mutation>& of_cells();
/// All of them.
std::vector<Mutation> all();

/// What is wrong with the comparison of this mutation, empty if nothing: an expected finding that
/// is not there, or not in its place.
std::string miss(const ExactComplex& right, const Broken& broken);
/// What is wrong with the comparison of a right result, its nearest doubles, its lines alone, its
/// polygons alone and itself: any finding.
std::string false_alarm(const ExactComplex& right);

}  // namespace plumbline::mutations
