#include "adapter.hpp"

#include <cxxabi.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <typeinfo>

namespace study {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~' ? ' ' : c;
  }
  return out + "\"";
}

// The shortest decimals that are read as the same double.
std::string decimals(double x) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x).ptr;
  return std::string(text.data(), end);
}

// The text after `"name":`; null where there is none.
const char* value_or_null(const std::string& line, const std::string& name) {
  const std::size_t at = line.find(quoted(name));
  return at == std::string::npos ? nullptr : std::strchr(line.c_str() + at, ':') + 1;
}

const char* value_of(const std::string& line, const std::string& name) {
  const char* const value = value_or_null(line, name);
  if (value == nullptr) throw std::runtime_error("a case without " + name);
  return value;
}

// What is no number is read as NaN.
std::optional<double> number_of(const char* text) {
  if (text == nullptr) return std::nullopt;
  char* end = nullptr;
  const double number = std::strtod(text, &end);
  return end == text ? std::nan("") : number;
}

// Lists of numbers, as lists within a list: nothing but numbers has to be found. -0.0 is 0.0.
std::vector<std::vector<double>> read_lists(const char* at) {
  std::vector<std::vector<double>> lists;
  int depth = 0;
  while (at != nullptr && *at != '\0') {
    if (*at == '[' && ++depth == 2) lists.emplace_back();
    if (*at == ']' && --depth == 0) break;
    if (std::strchr("[], \t\r", *at) != nullptr) {
      ++at;
      continue;
    }
    char* end = nullptr;
    const double number = std::strtod(at, &end) + 0.0;
    if (end == at || lists.empty()) throw std::runtime_error("a case whose lists are no numbers");
    lists.back().push_back(number);
    at = end;
  }
  return lists;
}

std::vector<std::vector<double>> lists_of(const std::string& line, const std::string& name) {
  return read_lists(std::strchr(value_of(line, name), '['));
}

std::vector<Segment> segments_of(const std::string& line) {
  std::vector<Segment> segments;
  for (const std::vector<double>& row : lists_of(line, "segments")) {
    const Segment s{Point{row.at(0), row.at(1)}, Point{row.at(2), row.at(3)}};
    if (s[0] != s[1]) segments.push_back(s);
  }
  return segments;
}

Rings rings_of(const std::string& line) {
  Rings result;
  for (const std::vector<double>& numbers : lists_of(line, "rings")) {
    std::vector<Point>& ring = result.rings.emplace_back();
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
      ring.push_back({numbers[i], numbers[i + 1]});
    }
  }
  const std::string rule = value_of(line, "rule");
  result.is_even_odd = rule.find("\"evenodd\"") < rule.find(',');
  return result;
}

double tolerance_of(const Configuration& configuration, const std::string& line) {
  const std::optional<double> given = number_of(value_or_null(line, "tolerance"));
  if (!given) return configuration.tolerance;
  if (configuration.tolerance_kind == "none") {
    throw BadTolerance("this configuration has no tolerance");
  }
  if (!std::isfinite(*given) || *given < 0) {
    throw BadTolerance("a tolerance is a number, not below 0");
  }
  if (configuration.tolerance_kind == "grid" && *given == 0) {
    throw BadTolerance("a grid has a distance above 0");
  }
  return *given;
}

Model run(const Configuration& configuration, const std::string& line, Clock& clock) {
  if (configuration.run_rings) return configuration.run_rings(rings_of(line), clock);
  const double tolerance = tolerance_of(configuration, line);
  return configuration.run(segments_of(line), clock, tolerance);
}

// A list of what `item` writes.
template <class Items, class Item>
std::string list(const Items& items, Item item) {
  std::string out = "[";
  for (const auto& x : items) {
    if (out.size() > 1) out += ", ";
    out += item(x);
  }
  return out + "]";
}

std::string written(const Model& model) {
  const auto number = [](std::int64_t i) { return std::to_string(i); };
  const auto numbers = [&](const auto& row) { return list(row, number); };
  std::string out =
      "{\"V\": " + list(model.vertices, [](const Point& p) { return list(p, decimals); });
  out += ", \"EV\": " + list(model.edges, numbers);
  if (model.polygons) {
    const auto rings = [&](const std::vector<Ring>& polygon) { return list(polygon, numbers); };
    out += ", \"polygons\": " + list(*model.polygons, rings);
  }
  return out + "}";
}

std::string failed(const std::string& kind, const std::string& message) {
  return "\"error\": {\"class\": " + quoted(kind) +
         ", \"message\": " + quoted(message.substr(0, 500)) + "}";
}

std::string class_of(const std::exception& error) {
  const char* const mangled = typeid(error).name();
  char* const name = abi::__cxa_demangle(mangled, nullptr, nullptr, nullptr);
  std::string result = name == nullptr ? mangled : name;
  std::free(name);
  return result;
}

void ensure_finite(const Model& model) {
  for (const Point& p : model.vertices) {
    if (!std::isfinite(p[0]) || !std::isfinite(p[1])) {
      throw EngineError("NotFinite", "coordinates of the result are not finite");
    }
  }
}

std::string answer(const Configuration& configuration, const std::string& line) {
  const std::string number = std::to_string(std::strtoll(value_of(line, "case"), nullptr, 10));
  Clock clock;
  std::string said;
  try {
    const Model model = run(configuration, line, clock);
    ensure_finite(model);
    said = "\"model\": " + written(model);
  } catch (const EngineError& error) {
    said = failed(error.kind(), error.what());
  } catch (const std::exception& error) {
    said = failed(class_of(error), error.what());
  }
  return "{\"case\": " + number + ", \"seconds\": " + decimals(clock.seconds()) + ", " + said +
         "}\n";
}

std::string listed(const Engine& engine) {
  std::string out =
      "{\"engine\": " + quoted(engine.engine) + ", \"title\": " + quoted(engine.title) +
      ", \"version\": " + quoted(engine.version) + ", \"algorithm\": " + quoted(engine.algorithm) +
      ", \"licence\": " + quoted(engine.licence);
  if (!engine.takes.empty()) {
    out += ", \"input\": \"rings\", \"takes\": " + list(engine.takes, quoted);
  }
  out += ", \"configurations\": " + list(engine.configurations, [](const Configuration& c) {
           return "{\"name\": " + quoted(c.name) + ", \"title\": " + quoted(c.title) +
                  ", \"tolerance\": {\"kind\": " + quoted(c.tolerance_kind) +
                  ", \"value\": " + decimals(c.tolerance) + ", \"way\": " + quoted(c.way) +
                  (c.promise.empty() ? "" : ", \"promise\": " + quoted(c.promise)) +
                  "}, \"source\": " + quoted(c.source) + "}";
         });
  return out + "}";
}

// Standard output, for answers alone: what an engine prints goes to standard error.
std::FILE* own_output() {
  std::FILE* const answers = fdopen(dup(STDOUT_FILENO), "w");
  if (answers == nullptr || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) std::abort();
  return answers;
}

}  // namespace

std::int64_t Numbering::operator()(Point point) {
  point = {point[0] + 0.0, point[1] + 0.0};
  const auto [at, is_new] = number_.try_emplace(point, static_cast<std::int64_t>(points_.size()));
  if (is_new) points_.push_back(point);
  return at->second;
}

std::vector<Edge> each_once(std::vector<Edge> edges) {
  for (Edge& e : edges) std::sort(e.begin(), e.end());
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::erase_if(edges, [](const Edge& e) { return e[0] == e[1]; });
  return edges;
}

int serve(const Engine& engine, int argc, char** argv) {
  const std::string wanted = argc == 2 ? argv[1] : "";
  if (wanted == "--list") {
    std::puts(listed(engine).c_str());
    return 0;
  }
  for (const Configuration& configuration : engine.configurations) {
    if (configuration.name != wanted) continue;
    std::FILE* const answers = own_output();
    for (std::string line; std::getline(std::cin, line);) {
      std::fputs(answer(configuration, line).c_str(), answers);
      std::fflush(answers);
    }
    return 0;
  }
  std::fputs("usage: --list, or one of the configurations that it lists\n", stderr);
  return 2;
}

}  // namespace study
