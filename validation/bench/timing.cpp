#include "timing.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>

namespace plumbline::bench {
namespace {

/// Shorter runs are repeated within one measurement until they take this long together.
constexpr double kShortest = 0.1;

/// Keeps the times of single repetitions.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      seconds_[run.run_name.function_name].push_back(run.real_accumulated_time /
                                                     static_cast<double>(run.iterations));
    }
  }
  const std::map<std::string, std::vector<double>>& seconds() const { return seconds_; }

 private:
  std::map<std::string, std::vector<double>> seconds_;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

void run(benchmark::State& state, const Job& job) {
  for (auto _ : state) {
    Outcome outcome = job();
    state.PauseTiming();
    outcome = {};
    state.ResumeTiming();
  }
}

}  // namespace

void initialize_timing() {
  char program[] = "plumbline_bench",
       interleaving[] = "--benchmark_enable_random_interleaving=true";
  char* argv[] = {program, interleaving, nullptr};
  int argc = 2;
  benchmark::Initialize(&argc, argv);
}

std::map<std::string, double> median_seconds(const std::string& title,
                                             const std::vector<Timed>& timed) {
  for (const Timed& t : timed) {
    benchmark::RegisterBenchmark(t.contender->id.c_str(), run, t.job)
        ->UseRealTime()
        ->MinTime(kShortest)
        ->Repetitions(t.repetitions);
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  std::map<std::string, double> medians;
  for (const auto& [id, seconds] : collector.seconds()) {
    medians[id] = median(seconds);
    fmt::print(stderr, "{}: {} {:.4g} s, {} times\n", title, id, medians[id], seconds.size());
  }
  return medians;
}

}  // namespace plumbline::bench
