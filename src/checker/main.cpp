// plumbline-verify: checks a certificate against the input that it is of.

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limits.hpp"
#include "verify.hpp"

namespace {

constexpr int kAccepted = 0;
constexpr int kRefused = 1;
constexpr int kBad = 2;
constexpr std::size_t kMaxBytes = 0xFFFFFFFF;

constexpr std::string_view kUsage =
    "usage: plumbline-verify [--max-memory SIZE] [--timeout SECONDS] INPUT CERTIFICATE\n"
    "\n"
    "Proves, in exact arithmetic and without anything of what made it, that CERTIFICATE holds the\n"
    "planar arrangement of INPUT, a .lines file, or says what is wrong first, and where.\n"
    "\n"
    "  plumbline eval plan.svg -o plan.lines\n"
    "  plumbline arrange plan.lines --certify plan.certificate\n"
    "  plumbline-verify plan.lines plan.certificate\n"
    "\n"
    "  --max-memory SIZE   give up, with exit code 2, where more would be needed; 500M, 4G\n"
    "  --timeout SECONDS   give up after so long, with exit code 2\n"
    "\n"
    "Exit codes: 0 proved, 1 refused, 2 bad input or usage, or a limit. docs/certificate.md has\n"
    "the format and what is proved.\n";

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

/// The files that the arguments name, their options obeyed; none, with a complaint, if they are no
/// such arguments.
std::optional<std::vector<const char*>> files(const std::vector<const char*>& arguments) {
  std::vector<const char*> result;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string_view argument = arguments[i];
    const bool is_memory = argument == "--max-memory";
    if (is_memory || argument == "--timeout") {
      const char* const value = ++i < arguments.size() ? arguments[i] : "";
      if (is_memory && !plumbline_checker::limit_memory(value)) {
        complain("not a size, as 500M or 4G: --max-memory " + std::string(value));
        return std::nullopt;
      }
      if (!is_memory && !plumbline_checker::limit_time(value)) {
        complain("not a positive number of seconds, at most 1e9: --timeout " + std::string(value));
        return std::nullopt;
      }
    } else if (argument.starts_with('-')) {
      result.clear();
      break;
    } else {
      result.push_back(arguments[i]);
    }
  }
  if (result.size() == 2) return result;
  std::fputs(kUsage.data(), stderr);
  return std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
  plumbline_checker::end_where_memory_ends();
  const std::vector<const char*> arguments(argv + std::min(argc, 1), argv + argc);
  const bool asks_for_help = std::any_of(
      arguments.begin(), arguments.end(),
      [](std::string_view argument) { return argument == "--help" || argument == "-h"; });
  if (asks_for_help) {
    std::fputs(kUsage.data(), stdout);
    return kAccepted;
  }
  const auto names = files(arguments);
  return names ? run(names->front(), names->back()) : kBad;
}
