#pragma once

#include <random>
#include <string>
#include <vector>

/// Ways to damage the text of a certificate.
namespace plumbline::certificates {

class Fields;
using Random = std::mt19937;

/// A number below `bound`, the same with every library. Requires: bound > 0.
std::size_t below(Random& random, std::size_t bound);

struct Kind {
  std::string name;
  /// Changes the fields of the lines; it may leave them as they are where there is nothing to
  /// change.
  void (*apply)(Fields& fields, Random& random);
};
/// What is done to a certificate's fields, lines and geometry; some kinds keep more of the rules
/// than others, so that every check of the checker's has something to find.
const std::vector<Kind>& kinds();

/// The text after one damage of the kind.
std::string damaged(const std::string& text, const Kind& kind, Random& random);

}  // namespace plumbline::certificates
