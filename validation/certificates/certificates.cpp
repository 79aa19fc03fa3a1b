// Damages the certificates of random inputs and holds them against the checker, which must refuse
// all that do not have the bytes of the right one. Prints a Markdown table. Exit code 1 if one is
// accepted, or a right one refused. Usage: plumbline_certificates COUNT [FIRST-SEED]

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
  std::string input, certificate;
};

Right right_of(SegmentSet segments) {
  std::string text = certificate(arrange(segments), segments);
  std::string input = to_lines(segments);
  return {std::move(segments), std::move(input), std::move(text)};
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

struct Tally {
  std::size_t unchanged = 0, refused = 0, wrong = 0;
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
        "{} certificates, all accepted as they are.\n\n| damage | refused | unchanged | wrongly "
        "accepted |\n| --- | --- | --- | --- |\n",
        inputs_);
    for (const auto& [kind, n] : tally_) {
      fmt::print("| {} | {} | {} | {} |\n", kind, n.refused, n.unchanged, n.wrong);
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
