// Every recorded input of the published pipeline through `check --engine inters`, for each of
// its results: the findings by stage and rule.
// Usage: plumbline_attribution DIRECTORY. Prints Markdown; exit code 1 if a finding has no cause.

#include <fmt/format.h>
#include <rapidjson/document.h>
#include <rapidjson/istreamwrapper.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include "plumbline/plumbline.hpp"

namespace fs = std::filesystem;
using namespace plumbline;

namespace {

/// Far below the radius, so that what is moved shows, too.
constexpr double kTolerance = 1e-6;

struct Rule {
  std::size_t findings = 0, confirmed = 0, healed = 0, files = 0;
  std::string first_file;
};

struct Totals {
  std::size_t files = 0, agreeing = 0, findings = 0, unattributed = 0;
  std::map<std::pair<std::string, std::string>, Rule> rules;
};

/// The lines of a recorded case; none for a case of another kind.
std::optional<SegmentSet> recorded_lines(const fs::path& path) {
  std::ifstream file(path);
  rapidjson::IStreamWrapper stream(file);
  rapidjson::Document document;
  document.ParseStream<rapidjson::kParseFullPrecisionFlag>(stream);
  if (document.HasParseError() || !document.IsObject() || !document.HasMember("kind") ||
      document["kind"] != "inters" || !document["input"]["lines"].IsArray()) {
    return std::nullopt;
  }
  SegmentSet set;
  set.add_file(path.filename().string());
  const auto point = [](const rapidjson::Value& p) {
    return PointD{p[0].GetDouble(), p[1].GetDouble()};
  };
  for (const auto& line : document["input"]["lines"].GetArray()) {
    set.add(point(line[0]), point(line[1]), set.add_source({}));
  }
  return set;
}

void add(const fs::path& file, SegmentSet input, const std::string& result, Totals& totals) {
  Answer answer = answer_of(inters::engine(), input, {{"result", result}});
  ExactComplex complex = arrange(input);
  const Check checked =
      check(std::move(input), std::move(complex), std::move(answer), {kTolerance, {}, 0, {}});
  ++totals.files;
  totals.agreeing += checked.agree();
  totals.findings += checked.comparison.findings.size();
  totals.unattributed += checked.comparison.findings.size() - checked.causes.size();
  std::map<std::pair<std::string, std::string>, Rule> here;
  for (const Cause& cause : checked.causes) {
    if (cause.rule.empty()) {
      ++totals.unattributed;
      continue;
    }
    Rule& rule = here[{cause.stage, cause.rule}];
    ++rule.findings;
    rule.confirmed += cause.confirmed;
    rule.healed += cause.remade == false;
  }
  for (const auto& [name, rule] : here) {
    Rule& total = totals.rules[name];
    total.findings += rule.findings;
    total.confirmed += rule.confirmed;
    total.healed += rule.healed;
    if (total.files++ == 0) total.first_file = file.stem().string();
  }
}

void print(const char* title, const Totals& totals) {
  fmt::print("\n## {}\n\n{} inputs, {} of them right; {} findings, {} without a cause.\n\n", title,
             totals.files, totals.agreeing, totals.findings, totals.unattributed);
  fmt::print("| stage | rule | findings | confirmed | healed | inputs | the first |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- | --- |\n");
  for (const auto& [name, rule] : totals.rules) {
    fmt::print("| {} | {} | {} | {} | {} | {} | {} |\n", name.first, name.second, rule.findings,
               rule.confirmed, rule.healed, rule.files, rule.first_file);
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: plumbline_attribution DIRECTORY\n";
    return 2;
  }
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(argv[1])) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  Totals of_largest, of_all, of_cells;
  for (const fs::path& file : files) {
    const std::optional<SegmentSet> lines = recorded_lines(file);
    if (!lines) continue;
    add(file, *lines, "larFromLines", of_largest);
    add(file, *lines, "allComponents", of_all);
    add(file, *lines, "cells", of_cells);
  }
  print("larFromLines", of_largest);
  print("allComponents", of_all);
  print("cells", of_cells);
  return of_largest.unattributed + of_all.unattributed + of_cells.unattributed == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "plumbline_attribution: " << error.what() << '\n';
  return 3;
}
