// The seam: an engine is added in a few lines, and check knows nothing of it.

#include "plumbline/engine.hpp"

#include <catch2/catch.hpp>
#include <map>

#include "cli/tool.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/check.hpp"
#include "plumbline/engines/files.hpp"
#include "plumbline/engines/inters.hpp"
#include "plumbline/engines/lar.hpp"
#include "plumbline/pipeline.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

/// Returns the input as it is, in doubles, moved by its parameter: it cuts nothing.
Engine unsplit() {
  return {"unsplit",
          "1",
          "unsplit lines",
          {{"shift", Parameter::Type::Number, "by how much x grows [default: 0]"},
           {"mode", Parameter::Type::Text, "whether it does [default: on]", {"on", "off"}},
           {"times", Parameter::Type::Integer, "how often [default: 1]"}},
          [](const SegmentSet& input, const Parameters& parameters, std::size_t /*threads*/) {
            const auto shift = parameters.find("shift");
            const double x = shift == parameters.end() ? 0 : std::get<double>(shift->second);
            LineWork work = rounded(input);
            for (SegmentD& s : work.segments) s = {{s.a.x + x, s.a.y}, {s.b.x + x, s.b.y}};
            Answer answer;
            answer.parameters = {{"shift", x}};
            answer.complex = lines_alone(work.segments, work.sources);
            answer.compared = Compared::Graph;
            return answer;
          }};
}

Check checked(const std::string& drawing, const Parameters& parameters = {}) {
  const SegmentSet input = segments(drawing);
  return check(input, arrange(input), answer_of(unsplit(), input, parameters));
}

/// "2 edge missing": the findings by kind.
std::map<std::string, std::size_t> kinds(const Check& check) {
  std::map<std::string, std::size_t> counts;
  for (const Finding& f : check.comparison.findings) {
    ++counts[f.invariant ? to_text(*f.invariant) : to_text(f.kind) + ' ' + to_text(f.disagreement)];
  }
  return counts;
}

}  // namespace

TEST_CASE("an engine that cuts nothing is right where nothing crosses") {
  const Check right = checked("0 0 4 0  4 0 4 3  0 0 0 3");
  CHECK(right.agree());
  CHECK(right.comparison.compared == Compared::Graph);
  CHECK(right.answer.engine == "unsplit");
}

TEST_CASE("what it leaves uncut is found, and laid to the engine") {
  const Check crossed = checked("0 0 4 4  0 4 4 0");
  CHECK_FALSE(crossed.agree());
  const auto found = kinds(crossed);
  CHECK(found.at("crossing") == 1);
  CHECK(found.at("vertex missing") == 1);
  CHECK_FALSE(crossed.comparison.float_valid);
  for (const Cause& cause : crossed.causes) {
    CHECK(cause.stage == "unsplit");
    CHECK_FALSE(cause.rule.empty());
  }
  CHECK(crossed.causes.size() == crossed.comparison.findings.size());
}

TEST_CASE("no engine gets advice from another one's runs") {
  const SegmentSet input = segments("0 0 4 4  0 4 4 0");
  const Check crossed = advised(check(input, arrange(input), answer_of(unsplit(), input)));
  CHECK(crossed.ladder);
  CHECK_FALSE(crossed.right_radii);
  const Check inters = advised(check(input, arrange(input), answer_of(inters::engine(), input)));
  CHECK_FALSE(inters.right_radii);
  const Check lar = advised(check(input, arrange(input), answer_of(lar::engine(), input)));
  CHECK(lar.right_radii);
}

TEST_CASE("parameters reach the engine, and those that it has not are refused") {
  CHECK_FALSE(checked("0 0 4 0", {{"shift", 0.5}}).agree());
  CHECK_THROWS_WITH(checked("0 0 4 0", {{"radius", 0.5}}),
                    Catch::Contains("unsplit has no such parameter; it has shift"));
  CHECK_THROWS_WITH(checked("0 0 4 0", {{"shift", std::string("far")}}),
                    Catch::Contains("shift is a number"));
  CHECK_THROWS_WITH(checked("0 0 4 0", {{"mode", std::string("never")}}),
                    Catch::Contains("mode is on or off"));
  CHECK(std::get<double>(parameter_value(unsplit(), "shift", "1e-3")) == 1e-3);
  CHECK(std::get<std::int64_t>(parameter_value(unsplit(), "times", "3")) == 3);
  CHECK_THROWS_WITH(parameter_value(unsplit(), "times", "1.5"), Catch::Contains("an integer"));
  CHECK_THROWS_WITH(parameter_value(unsplit(), "times", "99999999999999999999"),
                    Catch::Contains("an integer"));
  CHECK_THROWS_WITH(parameter_value(unsplit(), "shift", "1e999"), Catch::Contains("a number"));
  CHECK_THROWS_WITH(parameter_value(unsplit(), "mode", "never"), Catch::Contains("on or off"));
}

TEST_CASE("every engine of the tool has a name, a title and described parameters") {
  std::string names;
  for (const Engine& engine : engines()) {
    names += engine.name + ' ';
    CHECK_FALSE(engine.title.empty());
    for (const Parameter& parameter : engine.parameters) CHECK_FALSE(parameter.description.empty());
  }
  CHECK(names == "lar inters plasm files ");
  CHECK_THROWS_WITH(engine_named("luck", engines()),
                    Catch::Contains("there are lar, inters, plasm, files"));
}

TEST_CASE("the tool checks an engine that it is given, by name and with its parameters") {
  std::vector<Engine> known = engines();
  known.push_back(unsplit());
  const auto exit_code = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"plumbline", "check"});
    std::vector<char*> words;
    for (std::string& word : arguments) words.push_back(word.data());
    return cli::run(static_cast<int>(words.size()), words.data(), {known});
  };
  const std::string rooms = PLUMBLINE_EXAMPLES "/rooms.lines";
  CHECK(exit_code({rooms, "--engine", "unsplit"}) == 0);
  CHECK(exit_code({rooms, "--engine", "unsplit", "--set", "shift=0.5"}) == 1);
  CHECK(exit_code({rooms, "--engine", "unsplit", "--set", "mode=never"}) == 2);
  CHECK(exit_code({rooms, "--engine", "luck"}) == 2);
  CHECK(exit_code({PLUMBLINE_EXAMPLES "/office-plan.svg", "--engine", "unsplit"}) == 1);
}

TEST_CASE("an answer without lines about a drawing without lines agrees, and about others not") {
  CHECK(checked("").agree());
  const SegmentSet input = segments("0 0 1 0");
  Answer nothing = answer_of(unsplit(), segments(""));
  CHECK_FALSE(check(input, arrange(input), nothing).agree());
}
