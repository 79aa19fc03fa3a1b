// The protocol of adapters, for engines that C++ calls: cases in, models out. ../README.md has it.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace study {

using Point = std::array<double, 2>;
using Segment = std::array<Point, 2>;
using Edge = std::array<std::int64_t, 2>;
using Ring = std::vector<std::int64_t>;

// What an engine made of a case. Edges are each there once, of two vertices. Of each polygon the
// outer ring comes first; in no ring the first vertex is repeated.
struct Model {
  std::vector<Point> vertices;
  std::vector<Edge> edges;
  std::optional<std::vector<std::vector<Ring>>> polygons;
};

// What engines of rings get: in no ring the first vertex is repeated.
struct Rings {
  std::vector<std::vector<Point>> rings;
  bool is_even_odd = false;  // else nonzero
};

// The time that an engine takes. What an adapter does before and after is not the engine's.
class Clock {
 public:
  void start() { began_ = std::chrono::steady_clock::now(); }
  void stop() {
    seconds_ += (std::chrono::steady_clock::now() - began_) / std::chrono::duration<double>(1);
  }
  double seconds() const { return seconds_; }

 private:
  std::chrono::steady_clock::time_point began_;
  double seconds_ = 0;
};

// What an engine says of itself that failed, with the engine's own word for it.
class EngineError : public std::runtime_error {
 public:
  EngineError(std::string kind, const std::string& message)
      : std::runtime_error(message), kind_(std::move(kind)) {}
  const std::string& kind() const { return kind_; }

 private:
  std::string kind_;
};

// A tolerance that an engine cannot have.
class BadTolerance : public EngineError {
 public:
  explicit BadTolerance(const std::string& message) : EngineError("BadTolerance", message) {}
};

// One way to call an engine. `run` gets segments of which none is of length 0, and the tolerance:
// this one, or that of a case. `tolerance_kind` is none, grid or snap; `source` says where the
// engine's own documentation has this way; `promise`, if it is not empty, what the tolerance
// promises, as ../README.md has it; `way` what is called, without the tolerance.
struct Configuration {
  std::string name;
  std::string title;
  std::string tolerance_kind;
  double tolerance;
  std::string source;
  std::function<Model(const std::vector<Segment>&, Clock&, double)> run;
  std::string promise = "";
  std::string way = "";
  std::function<Model(const Rings&, Clock&)> run_rings = nullptr;  // instead, of engines of rings
};

// `algorithm` is what counts as one independent engine: wrappers of one share it. `takes` is of
// engines of rings: kinds of rings and fill rules, as "simple nonzero".
struct Engine {
  std::string engine;
  std::string title;
  std::string version;
  std::string algorithm;
  std::string licence;
  std::vector<Configuration> configurations;
  std::vector<std::string> takes = {};
};

// Numbers points in the order in which they come, equal ones alike. -0.0 is 0.0.
class Numbering {
 public:
  std::int64_t operator()(Point point);
  std::vector<Point> points() && { return std::move(points_); }

 private:
  std::map<Point, std::int64_t> number_;
  std::vector<Point> points_;
};

// Each edge once, in either direction, without those of one vertex alone.
std::vector<Edge> each_once(std::vector<Edge> edges);

// Runs an adapter: lists it, or answers the cases of standard input. Returns main's exit code.
int serve(const Engine& engine, int argc, char** argv);

}  // namespace study
