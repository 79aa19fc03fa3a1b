#include "machine.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <gmp.h>
#include <gnu/libc-version.h>
#include <oneapi/tbb/version.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "contenders.hpp"

namespace plumbline::bench {
namespace {

std::string processor() {
  std::ifstream lines("/proc/cpuinfo");
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

std::string compiler() {
#ifdef __clang__
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

double memory_gib() {
  std::ifstream file("/proc/meminfo");
  std::string name;
  double kib = 0;
  file >> name >> kib;  // MemTotal
  return kib / 1024 / 1024;
}

std::string first_line(const char* file) {
  std::ifstream lines(file);
  std::string line;
  std::getline(lines, line);
  return line;
}

/// The shared library that this process has its `malloc` of.
std::string allocator() {
  Dl_info info{};
  void* symbol = dlsym(RTLD_DEFAULT, "malloc");
  if (symbol == nullptr || dladdr(symbol, &info) == 0) return "unknown";
  const std::string library = std::filesystem::path(info.dli_fname).filename();
  return library.starts_with("libc.so") ? fmt::format("glibc {}", gnu_get_libc_version()) : library;
}

}  // namespace

std::string machine() {
  return fmt::format(
      "- {}, {} threads, {:.0f} GiB; load when started {}\n"
      "- {}, -O2; CGAL {} (Epeck over GMP {}); GEOS {}; oneTBB {}\n"
      "- allocator: {}\n",
      processor(), std::thread::hardware_concurrency(), memory_gib(),
      first_line("/proc/loadavg").substr(0, 4), compiler(), cgal_version(), gmp_version,
      geos_version(), TBB_VERSION_STRING, allocator());
}

}  // namespace plumbline::bench
