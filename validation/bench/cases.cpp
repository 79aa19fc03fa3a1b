#include "cases.hpp"

#include <cmath>

#include "inputs/hostile.hpp"
#include "inputs/workloads.hpp"

namespace plumbline::bench {
namespace {

constexpr unsigned kHostileLimit = 10, kQuickLimit = 2;  // seconds

struct NamedAbsence {
  const char* workload;
  Absent absent;
};

const NamedAbsence kAbsences[] = {
    {"D_1e6", {"geos", "no end within 420 s"}},
    {"R1_5e6", {"geos", "some 10 minutes"}},
    {"R1_5e6", {"cgal", "some 13 GB"}},
};

Case workload(const std::string& name, const std::filesystem::path& drawings) {
  Case result;
  result.id = result.title = name;
  result.make = [name, drawings] { return inputs::workload(name, drawings); };
  for (const char* contender : {"bucket1", "bucket2", "cgal", "geos"}) {
    const Absent* absent = nullptr;
    for (const NamedAbsence& a : kAbsences) {
      if (name == a.workload && a.absent.contender == contender) absent = &a.absent;
    }
    if (absent == nullptr) {
      result.contenders.emplace_back(contender);
    } else {
      result.absent.push_back(*absent);
    }
  }
  if (const inputs::Known* known = inputs::known(name)) {
    result.cells = Cells{known->vertices, known->edges, known->faces};
    result.crossings = known->crossings;
  }
  return result;
}

Case text(const std::string& name) {
  Case result = workload(name, {});
  result.kind = Kind::Text;
  result.id = "text_" + name;
  result.title = name;
  result.contenders = {"read", "text"};
  result.absent.clear();
  return result;
}

/// `check` only where it takes some seconds at most: nearly all of R1 is found wrong by it.
Case command(const std::string& name, bool with_check) {
  Case result = workload(name, {});
  result.kind = Kind::Command;
  result.id = "command_" + name;
  result.contenders = {"bucket1", "arrange", "json", "compact", "safe"};
  if (with_check) result.contenders.insert(result.contenders.end(), {"check_fine", "check"});
  result.absent.clear();
  return result;
}

Case hostile(const inputs::Hostile& input, std::size_t index, bool quick) {
  const std::uint64_t size = quick ? input.small_size : input.size;
  Case result;
  result.kind = Kind::Hostile;
  result.id = "hostile_" + std::to_string(index);
  result.title = input.name;
  result.make = [make = input.make, size] { return make(size); };
  result.contenders = {"bucket1", "bucket2", "cgal"};
  if (const auto cells = input.cells(size)) {
    result.cells = Cells{cells->vertices, cells->edges, cells->faces};
  }
  result.limit_seconds = quick ? kQuickLimit : kHostileLimit;
  return result;
}

}  // namespace

std::vector<Case> cases(bool quick, const std::filesystem::path& drawings) {
  static const std::vector<std::string> kQuick{"R1_1e3", "R1_1e4", "R5_5e3", "G_300", "Gr_300",
                                               "D_1e4",  "S_1e4",  "S1_1e3", "F_1e4", "T_30",
                                               "Q_4e3",  "I_1e4",  "L_1e4",  "W_30"};
  static const std::vector<std::string> kFull{
      "R1_1e4",  "R1_1e5", "R1_1e6", "R1_5e6", "R5_5e3", "R5_1e5", "G_300", "G_1000", "Gr_300",
      "Gr_1000", "D_1e4",  "D_1e5",  "D_1e6",  "S_1e4",  "S_1e5",  "S_1e6", "S1_1e3", "S1_1e4",
      "F_1e5",   "F_1e6",  "T_100",  "T_300",  "Q_4e4",  "I_1e5",  "I_4e5", "L_1e5",  "W_100"};
  static const std::vector<std::string> kQuickDrawings{"P_1"},
      kFullDrawings{"P_1", "P_10", "P_100"};
  static const std::vector<std::string> kQuickTexts{"R1_1e4"}, kFullTexts{"R1_1e5", "R1_1e6"};
  std::vector<Case> all;
  for (const auto& name : quick ? kQuick : kFull) all.push_back(workload(name, drawings));
  if (!drawings.empty()) {
    for (const auto& name : quick ? kQuickDrawings : kFullDrawings) {
      all.push_back(workload(name, drawings));
    }
  }
  for (const auto& name : quick ? kQuickTexts : kFullTexts) all.push_back(text(name));
  if (quick) {
    all.push_back(command("R1_1e3", true));
  } else {
    all.push_back(command("R1_1e4", true));
    all.push_back(command("R1_1e5", false));
  }
  std::size_t index = 0;
  for (const auto& input : inputs::hostile()) all.push_back(hostile(input, ++index, quick));
  return all;
}

}  // namespace plumbline::bench
