#include "foreign/table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::foreign {
namespace {

std::string outcome(std::size_t wrong) {
  return wrong == 0 ? "ok" : fmt::format("**{} wrong**", wrong);
}

/// On one line, and without what markdown would take for its own.
std::string shown(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
    text.insert(at, 1, '\\');
  }
  return text;
}

std::string line(const Row& row) {
  if (!row.error.empty()) {
    return fmt::format("| {} | **not read**: {} | | | | | | | | | | | |\n", row.file,
                       shown(row.error));
  }
  const std::string claims =
      row.claims == 0 ? "" : fmt::format("{}/{}", row.claims - row.contradicted.size(), row.claims);
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n",
                     row.file, row.cases, row.segments, row.rejected, row.vertices, row.edges,
                     row.faces, row.components, outcome(row.engines_differ),
                     outcome(row.invariants_broken), outcome(row.refused),
                     outcome(row.relations_broken), claims);
}

Row sum(const std::vector<Row>& rows) {
  Row all;
  all.file = "**all**";
  for (const Row& row : rows) {
    for (const auto member :
         {&Row::cases, &Row::segments, &Row::rejected, &Row::vertices, &Row::edges, &Row::faces,
          &Row::components, &Row::engines_differ, &Row::invariants_broken, &Row::refused,
          &Row::relations_broken, &Row::claims}) {
      all.*member += row.*member;
    }
    all.contradicted.insert(all.contradicted.end(), row.contradicted.begin(),
                            row.contradicted.end());
    for (const auto& [reason, count] : row.rejected_by_reason) {
      all.rejected_by_reason[reason] += count;
    }
    for (const auto& [operation, count] : row.unexamined) all.unexamined[operation] += count;
  }
  return all;
}

}  // namespace

std::string table(const std::vector<Row>& rows) {
  const Row all = sum(rows);
  const auto unread =
      std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.error.empty(); });
  std::string text = fmt::format(
      "{} files, {} of which are not read; {} cases of {} segments; {} items rejected. Cases on "
      "which "
      "the engines differ: {}; the invariants are broken: {}; the checker refuses: {}. Relations "
      "that "
      "do not hold: {}. Claims of the files that hold: {} of {}.\n\n",
      rows.size(), unread, all.cases, all.segments, all.rejected, all.engines_differ,
      all.invariants_broken, all.refused, all.relations_broken,
      all.claims - all.contradicted.size(), all.claims);
  text +=
      "| file | cases | segments | rejected | V | E | F | C | engines | invariants | checker | "
      "relations | claims |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- | --- | --- | --- | --- |\n";
  for (const Row& row : rows) text += line(row);
  text += line(all);
  text += "\n## Claims that do not hold\n\n";
  if (all.contradicted.empty()) text += "None.\n";
  for (const Row& row : rows) {
    for (const std::string& claim : row.contradicted) {
      text += fmt::format("- {}: {}\n", row.file, shown(claim));
    }
  }
  text += "\n## Areas that differ by a hundredth or more, as rounded corners explain\n\n";
  for (const Row& row : rows) {
    for (const std::string& claim : row.differ_by_rounding) {
      text += fmt::format("- {}: {}\n", row.file, shown(claim));
    }
  }
  text += "\n## Operations whose outcomes are not looked at\n\n";
  for (const auto& [operation, count] : all.unexamined) {
    text += fmt::format("- {}: {}\n", shown(operation), count);
  }
  text += "\n## Rejected items\n\n| reason | items | in |\n| --- | ---: | --- |\n";
  for (const auto& [reason, count] : all.rejected_by_reason) {
    const auto where = std::find_if(rows.begin(), rows.end(), [&r = reason](const Row& row) {
      return row.rejected_by_reason.contains(r);
    });
    const auto files = std::count_if(rows.begin(), rows.end(), [&r = reason](const Row& row) {
      return row.rejected_by_reason.contains(r);
    });
    text += fmt::format("| {} | {} | {}{} |\n", shown(reason), count, where->file,
                        files > 1 ? fmt::format(" and {} more", files - 1) : "");
  }
  return text;
}

}  // namespace plumbline::foreign
