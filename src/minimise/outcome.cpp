// One word for what is wrong with an answer.

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "plumbline/minimise.hpp"

namespace plumbline {
namespace {

struct Kind {
  CellKind cell;
  Disagreement disagreement;
  const char* name;
};
/// Gravest first: faces, nesting, then what bounds them.
constexpr std::array kTopology{
    Kind{CellKind::Face, Disagreement::Missing, "face lost"},
    Kind{CellKind::Face, Disagreement::Extra, "face invented"},
    Kind{CellKind::Face, Disagreement::Merged, "faces merged"},
    Kind{CellKind::Face, Disagreement::Split, "face split"},
    Kind{CellKind::Face, Disagreement::WrongParent, "wrong parent"},
    Kind{CellKind::Hole, Disagreement::WrongParent, "wrong parent"},
    Kind{CellKind::Hole, Disagreement::Missing, "hole lost"},
    Kind{CellKind::Hole, Disagreement::Extra, "hole invented"},
    Kind{CellKind::Edge, Disagreement::Missing, "edge missing"},
    Kind{CellKind::Edge, Disagreement::Extra, "edge extra"},
    Kind{CellKind::Vertex, Disagreement::Missing, "vertex missing"},
    Kind{CellKind::Vertex, Disagreement::Extra, "vertex extra"},
    Kind{CellKind::Vertex, Disagreement::Merged, "vertices merged"},
    Kind{CellKind::Vertex, Disagreement::Split, "vertex split"},
    Kind{CellKind::Edge, Disagreement::Merged, "edges merged"},
    Kind{CellKind::Edge, Disagreement::Split, "edge split"},
};

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Up to the first ": " that is not within the first word, numbers as #: what two failures of one
/// kind have in common.
std::string head(std::string_view message) {
  std::string text;
  message = message.substr(0, message.find(": "));
  for (std::size_t i = 0; i < message.size(); ++i) {
    const bool is_in_word = i > 0 && std::isalnum(static_cast<unsigned char>(message[i - 1])) != 0;
    const std::size_t sign = message[i] == '-' || message[i] == '+' ? 1 : 0;
    if (is_in_word || i + sign >= message.size() || !is_digit(message[i + sign])) {
      text += message[i];
      continue;
    }
    text += '#';
    i += sign;
    const auto goes_on = [&](std::size_t k) {
      const bool is_exponent_sign = (message[k] == '-' || message[k] == '+') &&
                                    (message[k - 1] == 'e' || message[k - 1] == 'E');
      const bool is_exponent = (message[k] == 'e' || message[k] == 'E') && k + 1 < message.size() &&
                               (is_digit(message[k + 1]) || message[k + 1] == '-');
      const bool is_point = message[k] == '.' && k + 1 < message.size() && is_digit(message[k + 1]);
      return is_digit(message[k]) || is_exponent || is_exponent_sign || is_point;
    };
    while (i + 1 < message.size() && goes_on(i + 1)) ++i;
  }
  return text;
}

bool is_engines_own(const Check& check, std::size_t finding) {
  if (finding >= check.causes.size()) return true;
  const std::string& stage = check.causes[finding].stage;
  return stage != kDrawing && stage != kParse && stage != kTransform;
}

/// Class, rank in it, and name of what one finding says.
struct Named {
  OutcomeClass outcome_class = OutcomeClass::Moved;
  std::size_t rank = 0;
  std::string kind;
};

Named named(const Finding& finding, const Cause* failure) {
  if (failure != nullptr && finding.kind == CellKind::Complex) {
    const bool is_loud = finding.disagreement == Disagreement::Missing;
    if (is_loud) return {OutcomeClass::Loud, 0, failure->rule + ": " + head(finding.message)};
    return {OutcomeClass::Invalid, static_cast<std::size_t>(Invariant::Coverage) + 1,
            failure->rule};
  }
  if (finding.disagreement == Disagreement::Invalid) {
    const auto invariant = finding.invariant.value_or(Invariant::Index);
    return {OutcomeClass::Invalid, static_cast<std::size_t>(invariant), to_text(invariant)};
  }
  const auto found = std::ranges::find_if(kTopology, [&](const Kind& kind) {
    return kind.cell == finding.kind && kind.disagreement == finding.disagreement;
  });
  if (found != kTopology.end()) {
    return {OutcomeClass::Topology, static_cast<std::size_t>(found - kTopology.begin()),
            found->name};
  }
  const bool is_moved =
      finding.disagreement == Disagreement::Moved || finding.disagreement == Disagreement::Reshaped;
  return {is_moved ? OutcomeClass::Moved : OutcomeClass::Topology,
          kTopology.size() + static_cast<std::size_t>(finding.kind),
          to_text(finding.kind) + ' ' + to_text(finding.disagreement)};
}

}  // namespace

std::string to_text(OutcomeClass outcome_class) {
  switch (outcome_class) {
    case OutcomeClass::Loud:
      return "loud";
    case OutcomeClass::Invalid:
      return "invalid";
    case OutcomeClass::Topology:
      return "topology";
    case OutcomeClass::Moved:
      return "moved";
    case OutcomeClass::Right:
      break;
  }
  return "right";
}

Outcome outcome(const Check& check) {
  const std::vector<Finding>& findings = check.comparison.findings;
  const std::size_t compared = findings.size() - check.answer.failures.size();
  Outcome result;
  std::size_t rank = 0;
  for (std::size_t f = 0; f < findings.size(); ++f) {
    if (!is_engines_own(check, f)) continue;
    Named name = named(findings[f], f < compared ? nullptr : &check.causes[f]);
    if (result.finding != 0 &&
        std::pair(name.outcome_class, name.rank) >= std::pair(result.outcome_class, rank)) {
      continue;
    }
    result = {name.outcome_class, std::move(name.kind), f + 1};
    rank = name.rank;
  }
  return result;
}

}  // namespace plumbline
