// Runs of the engine on smaller drawings, each held against its exact arrangement.

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>

#include "minimise/steps.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/error.hpp"
#include "plumbline/round.hpp"

namespace plumbline::minimise_steps {
namespace {

constexpr std::size_t kMostKept = 4096;  ///< lines of a drawing whose verdict is kept

std::string key_of(const Lines& lines) {
  std::string key(lines.size() * sizeof(Line::numbers), '\0');
  char* to = key.data();
  for (const Line& line : lines) {
    std::memcpy(to, line.numbers.data(), sizeof(line.numbers));
    to += sizeof(line.numbers);
  }
  return key;
}

/// An exception as the answer of an engine that has none.
Answer failed(const Engine& engine, const std::string& message) {
  Answer answer;
  answer.engine = engine.name;
  answer.version = engine.version;
  answer.title = engine.title;
  answer.short_title = engine.name.substr(0, 12);
  answer.complex = lines_alone({});
  answer.compared = Compared::Graph;
  Explained failure;
  failure.finding.kind = CellKind::Complex;
  failure.finding.disagreement = Disagreement::Missing;
  failure.finding.message = message;
  failure.cause.stage = engine.name;
  failure.cause.rule = "exception";
  failure.cause.explanation = "it threw an exception";
  failure.cause.confirmed = true;
  answer.failures.push_back(std::move(failure));
  return answer;
}

}  // namespace

Trials::Trials(const SegmentSet& input, const Engine& engine, const Parameters& parameters,
               const MinimiseOptions& options)
    : input_(input), engine_(engine), parameters_(parameters), options_(options) {}

Answer Trials::answered(const SegmentSet& drawing) {
  try {
    return answer_of(engine_, drawing, parameters_, options_.threads);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Internal && error.code() != ErrorCode::Limit) throw;
    return failed(engine_, error.what());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return failed(engine_, error.what());
  }
}

Check Trials::checked(const Lines& lines, bool by_stages) {
  ++runs_;
  if (options_.progress && !options_.progress(runs_, lines.size())) {
    throw Error(ErrorCode::Cancelled, "minimising was cancelled");
  }
  return checked(drawing_of(lines, input_), by_stages);
}

Check Trials::checked(SegmentSet drawing, bool by_stages) {
  ExactComplex complex = arrange(drawing, ExactEngine::Bucket, {options_.threads, {}});
  Answer answer = answered(drawing);
  if (!by_stages) {
    answer.trace = {};
    answer.with_radius = {};
  }
  CheckOptions options;
  options.tolerance = options_.tolerance;
  options.threads = options_.threads;
  return check(std::move(drawing), std::move(complex), std::move(answer), options);
}

bool Trials::show_in_decimals(const Lines& lines) {
  SegmentSet drawing;
  const SourceId source = drawing.add_source({});
  for (const Line& line : lines) {
    std::array<Number, 4> n;
    for (std::size_t k = 0; k < 4; ++k) n[k] = parse_number(shortest_text(line.numbers[k]));
    drawing.add(NumberPoint{n[0], n[1]}, NumberPoint{n[2], n[3]}, source);
  }
  return is_same(outcome(checked(std::move(drawing), false)), sought_);
}

void Trials::seek(const Outcome& outcome, bool is_representable) {
  sought_ = outcome;
  must_be_representable_ = is_representable;
}

Trials::Verdict Trials::verdict(const Lines& lines) {
  try {
    const Check check = checked(lines, false);
    if (!is_same(outcome(check), sought_)) return {};
    return {true, is_kept_by_simple_rounding(check.exact_complex, {})};
  } catch (const Error& error) {
    if (error.code() == ErrorCode::Cancelled) throw;
    return {};  // refused, by the engine or by the exact side
  }
}

bool Trials::show(const Lines& lines) {
  const auto has_no_length = [](const Line& line) {
    const auto& [ax, ay, bx, by] = line.numbers;
    return ax == bx && ay == by;
  };
  if (std::ranges::any_of(lines, has_no_length)) return false;
  const bool is_kept = lines.size() <= kMostKept;
  const std::string key = is_kept ? key_of(lines) : std::string();
  const auto found = is_kept ? known_.find(key) : known_.end();
  Verdict of_lines;
  if (found != known_.end()) {
    of_lines = found->second;
  } else {
    const bool is_enough = runs_ >= options_.max_runs || (options_.enough && options_.enough());
    have_ended_ = have_ended_ || is_enough;
    if (have_ended_) return false;
    of_lines = verdict(lines);
    if (is_kept) known_.emplace(key, of_lines);
  }
  if (!of_lines.is_same || (must_be_representable_ && !of_lines.is_representable)) return false;
  must_be_representable_ = of_lines.is_representable;
  return true;
}

}  // namespace plumbline::minimise_steps
