#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/commands.hpp"
#include "cli/report.hpp"
#include "plumbline/engines/programs.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

using programs::Configuration;
using programs::Listing;
using programs::Program;
using programs::ToleranceKind;

std::string tolerance_text(const Configuration& c) {
  const std::string kind = programs::to_text(c.tolerance_kind);
  if (c.tolerance_kind == ToleranceKind::None) return "no tolerance";
  return kind + ' ' + shortest_text(c.tolerance);
}

void print_built_in(const Engine& engine, Report& report) {
  report.print("{} {} ({})\n", engine.name, engine.version, engine.title);
  for (const Parameter& p : engine.parameters) {
    report.print("  {}: {}\n", p.name, p.description);
  }
}

void print_listing(const Program& program, const Listing& listing, Report& report) {
  report.print("{} {} ({}), the program {}\n", line_text(program.name), line_text(listing.version),
               line_text(listing.title), line_text(program.path.string()));
  if (listing.takes_rings) report.print("  takes rings and no line work: not for check\n");
  for (const Configuration& c : listing.configurations) {
    report.print("  {}: {}; {}\n    {}\n", line_text(c.name), line_text(c.title), tolerance_text(c),
                 line_text(c.source));
  }
}

Summary summary_of(const Engine& engine) {
  Summary summary;
  summary.set("name", engine.name);
  summary.set("version", engine.version);
  summary.set("title", engine.title);
  std::vector<std::string> names;
  for (const Parameter& p : engine.parameters) names.push_back(p.name);
  summary.set("parameters", names);
  return summary;
}

Summary summary_of(const Configuration& c) {
  Summary summary;
  summary.set("name", c.name);
  summary.set("title", c.title);
  summary.set("tolerance_kind", programs::to_text(c.tolerance_kind));
  summary.set("tolerance", c.tolerance);
  summary.set("source", c.source);
  return summary;
}

/// What a program says of itself, or why its engine is not here.
Summary tell(const Program& program, Report& report) {
  Summary summary;
  summary.set("name", program.name);
  summary.set("program", program.path.string());
  try {
    const Listing listing = programs::listing(program.path);
    print_listing(program, listing, report);
    summary.set("version", listing.version);
    summary.set("title", listing.title);
    summary.set("algorithm", listing.algorithm);
    summary.set("licence", listing.licence);
    summary.set("takes_rings", listing.takes_rings);
    std::vector<Summary> configurations;
    for (const Configuration& c : listing.configurations) configurations.push_back(summary_of(c));
    summary.set("configurations", configurations);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::Internal) throw;
    report.print("{} not here: {}\n", line_text(program.name), error.what());
    summary.set("not_here", std::string(error.what()));
  }
  return summary;
}

}  // namespace

ExitCode run(const EnginesArguments& /*arguments*/, Report& report, const KnownEngines& known) {
  std::vector<Summary> summaries;
  for (const Engine& engine : known.built_in) {
    print_built_in(engine, report);
    summaries.push_back(summary_of(engine));
  }
  for (const Program& program : programs::found_in(known.folders)) {
    const bool is_hidden =
        std::ranges::find(known.built_in, program.name, &Engine::name) != known.built_in.end();
    if (!is_hidden) summaries.push_back(tell(program, report));
  }
  report.set("engines", summaries);
  return kAgree;
}

}  // namespace plumbline::cli
