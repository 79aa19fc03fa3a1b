// Parameters of engines, and running them.

#include "plumbline/engine.hpp"

#include <algorithm>
#include <cmath>

#include "plumbline/error.hpp"
#include "plumbline/number.hpp"

namespace plumbline {
namespace {

std::string known_names(const Engine& engine) {
  std::string text;
  for (const Parameter& p : engine.parameters) text += (text.empty() ? "" : ", ") + p.name;
  return text.empty() ? "it has none" : "it has " + text;
}

const Parameter& parameter_of(const Engine& engine, const std::string& name) {
  const auto found = std::find_if(engine.parameters.begin(), engine.parameters.end(),
                                  [&](const Parameter& p) { return p.name == name; });
  if (found == engine.parameters.end()) {
    throw Error(ErrorCode::BadInput,
                "the engine " + engine.name + " has no such parameter; " + known_names(engine), {},
                name);
  }
  return *found;
}

bool is_choice(const Parameter& parameter, const std::string& text) {
  return parameter.choices.empty() || std::find(parameter.choices.begin(), parameter.choices.end(),
                                                text) != parameter.choices.end();
}

[[noreturn]] void refuse(const Parameter& parameter, std::string_view text) {
  std::string expected;
  switch (parameter.type) {
    case Parameter::Type::Number:
      expected = "a number";
      break;
    case Parameter::Type::Integer:
      expected = "an integer";
      break;
    case Parameter::Type::Text:
      for (const std::string& choice : parameter.choices) {
        expected += (expected.empty() ? "" : " or ") + choice;
      }
      break;
  }
  throw Error(ErrorCode::BadInput, "the parameter " + parameter.name + " is " + expected, {},
              std::string(text));
}

void check(const Parameter& parameter, const ParameterValue& value) {
  if (value.index() != static_cast<std::size_t>(parameter.type)) refuse(parameter, "another type");
  const auto* text = std::get_if<std::string>(&value);
  if (text != nullptr && !is_choice(parameter, *text)) refuse(parameter, *text);
}

}  // namespace

ParameterValue parameter_value(const Engine& engine, const std::string& name,
                               std::string_view text) {
  const Parameter& parameter = parameter_of(engine, name);
  if (parameter.type == Parameter::Type::Text) {
    ParameterValue value = std::string(text);
    check(parameter, value);
    return value;
  }
  try {
    const Rational number = parse_decimal(text);
    const double nearest = nearest_double(number);
    if (!std::isfinite(nearest)) refuse(parameter, text);
    if (parameter.type == Parameter::Type::Number) return nearest;
    if (number.get_den() == 1 && number.get_num().fits_slong_p()) {
      return std::int64_t{number.get_num().get_si()};
    }
  } catch (const Error&) {
    // Told below, in the words of the parameter.
  }
  refuse(parameter, text);
}

Answer answer_of(const Engine& engine, const SegmentSet& input, const Parameters& parameters,
                 std::size_t threads) {
  for (const auto& [name, value] : parameters) check(parameter_of(engine, name), value);
  Answer answer = engine.run(input, parameters, threads);
  answer.engine = engine.name;
  answer.version = engine.version;
  if (answer.title.empty()) answer.title = engine.title;
  if (answer.short_title.empty()) answer.short_title = engine.title;
  return answer;
}

FloatComplex lines_alone(std::span<const SegmentD> lines, const Lists<SegmentId>& sources) {
  FloatComplex complex;
  for (const SegmentD& line : lines) {
    complex.vertices.push_back(line.a);
    complex.vertices.push_back(line.b);
  }
  std::sort(complex.vertices.begin(), complex.vertices.end());
  complex.vertices.erase(std::unique(complex.vertices.begin(), complex.vertices.end()),
                         complex.vertices.end());
  const auto vertex = [&](const PointD& p) {
    const auto at = std::lower_bound(complex.vertices.begin(), complex.vertices.end(), p);
    return VertexId(static_cast<std::size_t>(at - complex.vertices.begin()));
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const VertexId a = vertex(lines[i].a), b = vertex(lines[i].b);
    complex.edges.push_back({std::min(a, b), std::max(a, b)});
    complex.edge_sources.push_back(i < sources.size() ? sources[i] : std::span<const SegmentId>());
  }
  complex.face_outer.emplace_back();
  complex.face_holes.push_back(std::vector<CycleId>());
  complex.face_isolated_vertices.push_back(std::vector<VertexId>());
  return canonical(std::move(complex));
}

}  // namespace plumbline
