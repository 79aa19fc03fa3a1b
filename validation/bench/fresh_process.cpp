// Peak memory and the cells of one run, which may also crash, take all memory or never end, without
// harm to the others.

#include "fresh_process.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace plumbline::bench {
namespace {

constexpr double kKib = 1024;

/// A line "name: <n> kB" of a file of /proc, in bytes.
double kib_line(const char* file, const std::string& name) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(name + ":")) return kKib * std::stod(line.substr(name.size() + 1));
  }
  throw std::runtime_error(std::string(file) + " has no " + name);
}

double resident() { return kib_line("/proc/self/status", "VmRSS"); }
double peak_resident() { return kib_line("/proc/self/status", "VmHWM"); }
void reset_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

/// Most memory that a run may have, and the part of what is free on a smaller machine.
constexpr double kMostMemory = 10e9, kPartOfFree = 0.8;

void limit_memory() {
  const double part = kPartOfFree * kib_line("/proc/meminfo", "MemAvailable");
  const auto bytes = static_cast<rlim_t>(std::min(kMostMemory, part));
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_AS, &limit);
}

std::string ended_by(int status) {
  if (WIFEXITED(status)) return fmt::format("exit code {}", WEXITSTATUS(status));
  if (WTERMSIG(status) == SIGALRM) return "time limit";
  return fmt::format("signal {}", WTERMSIG(status));
}

Measure parsed(const std::string& line, int status) {
  Measure measure;
  std::istringstream words(line);
  std::string kind;
  words >> kind;
  if (kind == "failed") {
    std::getline(words >> std::ws, measure.failure);
  } else if (!(words >> measure.segments >> measure.cells.vertices >> measure.cells.edges >>
               measure.cells.faces >> measure.seconds >> measure.peak)) {
    measure.failure = ended_by(status);
  }
  return measure;
}

}  // namespace

Measure measure_in_fresh_process(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"plumbline_bench"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  int pipe_ends[2];
  if (pipe(pipe_ends) != 0) throw std::runtime_error("no pipe");
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    dup2(pipe_ends[1], STDOUT_FILENO);
    close(pipe_ends[0]);
    close(pipe_ends[1]);
    execv("/proc/self/exe", argv.data());
    _exit(127);
  }
  close(pipe_ends[1]);
  if (child < 0) throw std::runtime_error("no process");
  std::string output;
  char buffer[256];
  for (ssize_t n; (n = read(pipe_ends[0], buffer, sizeof buffer)) > 0;) {
    output.append(buffer, static_cast<std::size_t>(n));
  }
  close(pipe_ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return parsed(output, status);
}

void measure_here(const Case& input, const Contender& contender) {
  try {
    limit_memory();
    const SegmentSet segments = input.make();
    const Job job = contender.prepare(segments);
    malloc_trim(0);
    reset_peak();
    const double before = resident();
    alarm(input.limit_seconds);
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = job();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    const double peak = peak_resident() - before;
    alarm(0);
    const Cells cells = outcome.cells();
    fmt::print("measured {} {} {} {} {} {}\n", segments.segments.size(), cells.vertices,
               cells.edges, cells.faces, time.count(), peak);
  } catch (const std::bad_alloc&) {
    fmt::print("failed out of memory\n");
  } catch (const std::exception& error) {
    fmt::print("failed {}\n", error.what());
  }
  std::fflush(nullptr);
  _exit(0);  // the result's destruction would only cost time
}

}  // namespace plumbline::bench
