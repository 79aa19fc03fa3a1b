// Damages the certificates of random inputs and holds them against the checker, which must refuse
// all that do not have the bytes of the right one, but for points inside faces that lie there as
// well. Prints a Markdown table. Exit code 1 if one is accepted, or a right one refused. Usage:
// plumbline_certificates COUNT [FIRST-SEED]

#include "plumbline/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

#include "certificates/damage.hpp"
#include "certificates/text.hpp"
#include "checker/verify.hpp"
#include "inputs/families.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/read.hpp"
#include "plumbline/structure.hpp"

using namespace plumbline;
using certificates::below;
using certificates::Random;
using plumbline_checker::Outcome;

namespace {

constexpr std::size_t kDamagesPerInput = 20;
constexpr std::size_t kMostShown = 10;

struct Right {
  SegmentSet segments;
  ExactComplex complex;
  std::string input, certificate;
};

Right right_of(SegmentSet segments) {
  ExactComplex complex = arrange(segments);
  std::string text = certificate(complex, segments);
  std::string input = to_lines(segments);
  return {std::move(segments), std::move(complex), std::move(input), std::move(text)};
}

/// A segment less, one more or another end, arranged: right, but of another input.
std::string of_another_input(const Right& right, Random& random) {
  SegmentSet other = right.segments;
  if (other.segments.size() == 0) return right.certificate;
  std::istringstream rows(right.input);
  std::vector<std::string> kept;
  for (std::string row; std::getline(rows, row);) kept.push_back(row);
  std::string& row = kept[below(random, kept.size())];
  const std::string& another = kept[below(random, kept.size())];
  const std::size_t comma = row.rfind(',') + 1;
  switch (below(random, 3)) {
    case 0:
      row.clear();
      break;
    case 1:
      row.replace(comma, row.npos, another.substr(another.rfind(',') + 1));
      break;
    default:
      row += "\n" + row.substr(0, row.find(',')) + another.substr(another.find(','));
  }
  return right_of(evaluate(read_lines(certificates::joined(kept), "other"))).certificate;
}

/// Twice the side of the line from a to b that p is on, so many times as the ray from p upwards
/// crosses it.
bool crosses_upwards(const Point& a, const Point& b, const Point& p) {
  if ((a.x <= p.x) == (b.x <= p.x)) return false;
  const Rational y = a.y + (p.x - a.x) / (b.x - a.x) * (b.y - a.y);
  return y > p.y;
}

bool is_on(const Point& a, const Point& b, const Point& p) {
  const Rational turn = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  return turn == 0 && (p.x - a.x) * (p.x - b.x) <= 0 && (p.y - a.y) * (p.y - b.y) <= 0;
}

/// Whether a point lies strictly inside a face: it is on no edge, at no vertex, and a ray from it
/// crosses the face's boundary an odd number of times. Without any order, sweep or filter.
bool is_strictly_inside(const ExactComplex& c, FaceId face, const Point& p) {
  for (const Point& vertex : c.vertices) {
    if (vertex == p) return false;
  }
  for (const auto& edge : c.edges) {
    if (is_on(c.vertices[edge.tail], c.vertices[edge.head], p)) return false;
  }
  bool odd = false;
  const auto pass = [&](CycleId cycle) {
    for (const HalfedgeId h : c.cycles[cycle]) {
      const auto& edge = c.edges[edge_of(h)];
      odd ^= crosses_upwards(c.vertices[edge.tail], c.vertices[edge.head], p);
    }
  };
  pass(c.face_outer[face]);
  for (const CycleId hole : c.face_holes[face]) pass(hole);
  return odd;
}

/// Whether a text differs from the right one in points inside faces only, which lie there too.
bool is_right(const Right& right, const std::string& text) {
  const std::vector<std::string> said = certificates::lines_of(text);
  const std::vector<std::string> lines = certificates::lines_of(right.certificate);
  if (said.size() != lines.size()) return false;
  std::size_t face = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t inside = lines[i].find(" inside ");
    if (inside == std::string::npos) {
      if (said[i] != lines[i]) return false;
      continue;
    }
    if (said[i].compare(0, inside, lines[i], 0, inside) != 0) return false;
    if (face > 0) {
      std::istringstream fields(said[i].substr(inside + 8));
      Point p;
      if (!(fields >> p.x >> p.y)) return false;
      if (!is_strictly_inside(right.complex, FaceId(static_cast<std::uint32_t>(face)), p)) {
        return false;
      }
    }
    ++face;
  }
  return true;
}

struct Tally {
  std::size_t unchanged = 0, refused = 0, other_inside = 0, wrong = 0;
};

class Campaign {
 public:
  explicit Campaign(std::string only) : only_(std::move(only)) {}

  void run(std::size_t count, unsigned seed) {
    for (std::size_t done = 0; done < count; ++seed) {
      const std::vector<std::string>& families = inputs::families();
      const std::string& family = families[seed % families.size()];
      const Right right = right_of(inputs::of_family(family, seed));
      ++inputs_;
      const auto verdict = plumbline_checker::verify(right.input, right.certificate);
      if (verdict.outcome != Outcome::Proved) {
        show(fmt::format("{} {}: a right certificate", family, seed), report(verdict));
      }
      Random random(seed);
      for (std::size_t i = 0; i < kDamagesPerInput && done < count; ++i) {
        done += damage(right, fmt::format("{} {} {}", family, seed, i), random) ? 1 : 0;
      }
    }
  }

  bool report_all() const {
    fmt::print(
        "{} certificates, all accepted as they are.\n\n| damage | refused | unchanged | another "
        "point inside, rightly "
        "accepted | wrongly accepted |\n| --- | --- | --- | --- | --- |\n",
        inputs_);
    for (const auto& [kind, n] : tally_) {
      fmt::print("| {} | {} | {} | {} | {} |\n", kind, n.refused, n.unchanged, n.other_inside,
                 n.wrong);
    }
    fmt::print("\n| the first thing that was wrong | times |\n| --- | --- |\n");
    for (const auto& [reason, times] : reasons_) fmt::print("| {} | {} |\n", reason, times);
    return failures_ == 0;
  }

 private:
  /// Whether it changed anything.
  bool damage(const Right& right, const std::string& name, Random& random) {
    const auto& kinds = certificates::kinds();
    const auto only = std::find_if(kinds.begin(), kinds.end(),
                                   [&](const auto& kind) { return kind.name == only_; });
    const std::size_t k = only != kinds.end() ? static_cast<std::size_t>(only - kinds.begin())
                                              : below(random, kinds.size() + 1);
    const std::string kind = k < kinds.size() ? kinds[k].name : "of a slightly different input";
    std::string text = k < kinds.size() ? certificates::damaged(right.certificate, kinds[k], random)
                                        : of_another_input(right, random);
    if (k < kinds.size() && below(random, 2) == 0) text = certificates::with_signature(text);
    const auto verdict = plumbline_checker::verify(right.input, text);
    Tally& tally = tally_[kind];
    if (verdict.outcome == Outcome::Refused) {
      ++tally.refused;
      ++reasons_[without_numbers(verdict.reason)];
      if (text == right.certificate) show(name + ", " + kind + ": unchanged", verdict.reason);
    } else if (text == right.certificate) {
      ++tally.unchanged;
    } else if (verdict.outcome == Outcome::Proved && is_right(right, text)) {
      ++tally.other_inside;
    } else {
      ++tally.wrong;
      show(name + ", " + kind, right.input + text);
    }
    return text != right.certificate;
  }

  static std::string without_numbers(const std::string& reason) {
    std::string text;
    const std::size_t quoted = reason.find(" is \"");
    for (const char c : reason.substr(0, quoted)) {
      const bool digit = c >= '0' && c <= '9';
      if (digit && (text.ends_with('+') || text.ends_with('-'))) text.pop_back();
      if (!digit) text += c;
      if (digit && !text.ends_with('N')) text += 'N';
    }
    return quoted == reason.npos ? text : text + " is another";
  }

  void show(const std::string& name, const std::string& what) {
    if (++failures_ <= kMostShown) std::cerr << name << ": " << what << '\n';
  }

  std::string only_;
  std::size_t inputs_ = 0, failures_ = 0;
  std::map<std::string, Tally> tally_;
  std::map<std::string, std::size_t> reasons_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: " << argv[0] << " COUNT [FIRST-SEED]\n";
    return 2;
  }
  Campaign campaign(argc > 3 ? argv[3] : "");
  campaign.run(std::stoul(argv[1]), argc > 2 ? static_cast<unsigned>(std::stoul(argv[2])) : 1);
  return campaign.report_all() ? EXIT_SUCCESS : EXIT_FAILURE;
}
