// plumbline-verify: checks a certificate against the input that it is of.

#include <gmp.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>

#include "verify.hpp"

namespace {

constexpr int kAccepted = 0;
constexpr int kRefused = 1;
constexpr int kBad = 2;
constexpr std::size_t kMaxBytes = 0xFFFFFFFF;

constexpr std::string_view kUsage =
    "usage: plumbline-verify INPUT CERTIFICATE\n"
    "\n"
    "Proves, in exact arithmetic and without anything of what made it, that CERTIFICATE holds the\n"
    "planar arrangement of INPUT, a .lines file, or says what is wrong first, and where.\n"
    "\n"
    "  plumbline eval plan.svg -o plan.lines\n"
    "  plumbline arrange plan.lines --certify plan.certificate\n"
    "  plumbline-verify plan.lines plan.certificate\n"
    "\n"
    "Exit codes: 0 proved, 1 refused, 2 bad input or usage. docs/certificate.md has the format "
    "and\n"
    "what is proved.\n";

void complain(std::string_view text) {
  std::fprintf(stderr, "plumbline-verify: %.*s\n", static_cast<int>(text.size()), text.data());
}

/// A file's bytes; none, with a complaint, if it cannot be read or is no text that would be
/// checked.
std::optional<std::string> content(const char* name) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(name, "rb"), std::fclose);
  if (!file) {
    complain(std::string(name) + ": " + std::strerror(errno));
    return std::nullopt;
  }
  constexpr std::size_t kBlock = 1 << 16;
  std::string text;
  for (std::size_t size = 0;;) {
    text.resize(size + kBlock);
    const std::size_t got = std::fread(text.data() + size, 1, kBlock, file.get());
    // A text has no such bytes, and a huge file without content has nothing else.
    const bool is_binary = std::memchr(text.data() + size, 0, got) != nullptr;
    size += got;
    if (is_binary || size > kMaxBytes) {
      complain(std::string(name) + (is_binary ? ": is not a text" : ": has 4 GiB or more"));
      return std::nullopt;
    }
    if (got == kBlock) continue;
    if (std::ferror(file.get()) != 0) {
      complain(std::string(name) + ": " + std::strerror(errno));
      return std::nullopt;
    }
    text.resize(size);
    return text;
  }
}

[[noreturn]] void end_without_memory() {
  complain("out of memory");
  std::_Exit(kBad);
}
void* allocate(std::size_t size) {
  void* const memory = std::malloc(size);
  if (memory == nullptr) end_without_memory();
  return memory;
}
void* reallocate(void* old, std::size_t /*old_size*/, std::size_t size) {
  void* const memory = std::realloc(old, size);
  if (memory == nullptr) end_without_memory();
  return memory;
}

int run(const char* input_name, const char* certificate_name) {
  const std::optional<std::string> input = content(input_name);
  if (!input) return kBad;
  const std::optional<std::string> certificate = content(certificate_name);
  if (!certificate) return kBad;
  const plumbline_checker::Verdict verdict = plumbline_checker::verify(*input, *certificate);
  const std::string text = plumbline_checker::report(verdict);
  switch (verdict.outcome) {
    case plumbline_checker::Outcome::Proved:
      std::fputs(text.c_str(), stdout);
      return std::fflush(stdout) == 0 ? kAccepted : kBad;
    case plumbline_checker::Outcome::Refused:
      std::fprintf(stderr, "%s: %s", certificate_name, text.c_str());
      return kRefused;
    default:
      std::fprintf(stderr, "%s: %s", input_name, text.c_str());
      if (!std::string_view(input_name).ends_with(".lines")) {
        complain("INPUT is a .lines file; make one: plumbline eval " + std::string(input_name) +
                 " -o plan.lines");
      }
      return kBad;
  }
}

}  // namespace

int main(int argc, char** argv) {
  // GMP would abort.
  mp_set_memory_functions(allocate, reallocate, nullptr);
  const bool asks_for_help = std::any_of(argv + 1, argv + argc, [](const char* argument) {
    return argument == std::string_view("--help") || argument == std::string_view("-h");
  });
  if (asks_for_help) {
    std::fputs(kUsage.data(), stdout);
    return kAccepted;
  }
  const auto is_option = [](const char* argument) { return argument[0] == '-'; };
  if (const int files = 2; argc != files + 1 || std::any_of(argv + 1, argv + argc, is_option)) {
    std::fputs(kUsage.data(), stderr);
    return kBad;
  }
  try {
    return run(argv[1], argv[2]);
  } catch (const std::bad_alloc&) {
    complain("out of memory");
    return kBad;
  }
}
