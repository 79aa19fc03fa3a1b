#include "times/table.hpp"

#include <cstdio>
#include <ctime>
#include <exception>
#include <iostream>

namespace plumbline::times {

double seconds(const std::function<void()>& job) {
  const std::clock_t start = std::clock();
  job();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

int print_table(int argc, char** argv, const std::vector<std::string>& recorded,
                const std::string& head, void (*print_row)(const std::string& workload)) try {
  const std::vector<std::string> named(argv + 1, argv + argc);
  std::cout << head << std::flush;
  for (const std::string& workload : named.empty() ? recorded : named) {
    print_row(workload);
    std::fflush(stdout);
  }
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}

}  // namespace plumbline::times
