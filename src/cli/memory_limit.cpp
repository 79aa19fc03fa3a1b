#include "cli/memory_limit.hpp"

#include <fmt/format.h>
#include <gmp.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <string>

#include "cli/watchdog.hpp"

namespace plumbline::cli {
namespace {

constexpr const char* kOutOfMemory = "out of memory";

/// Made beforehand.
std::string& error() {
  static std::string result = kOutOfMemory;
  return result;
}

// GMP is C: nothing may be thrown through it.
void* gmp_allocate(std::size_t size) {
  void* memory = std::malloc(size);
  if (memory == nullptr) end_without_memory();
  return memory;
}

void* gmp_reallocate(void* old, std::size_t /*old_size*/, std::size_t size) {
  void* memory = std::realloc(old, size);
  if (memory == nullptr) end_without_memory();
  return memory;
}

void gmp_free(void* memory, std::size_t /*size*/) { std::free(memory); }

}  // namespace

void limit_memory(const Limits& limits) {
  if (limits.bytes) {
    error() = fmt::format("{}: more than --max-memory {}", kOutOfMemory, limits.memory);
    // Not the address space: stacks and heaps of threads reserve much that they never use.
    struct ::rlimit limit = {};
    ::getrlimit(RLIMIT_DATA, &limit);
    limit.rlim_cur = std::min<::rlim_t>(*limits.bytes, limit.rlim_max);
    ::setrlimit(RLIMIT_DATA, &limit);
  }
  std::set_new_handler(end_without_memory);
  ::mp_set_memory_functions(gmp_allocate, gmp_reallocate, gmp_free);
}

bool is_memory_limited() { return error() != kOutOfMemory; }

void end_without_memory() { end_with(error()); }

}  // namespace plumbline::cli
