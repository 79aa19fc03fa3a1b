// The command line: whatever it says, it is understood or refused in words. An argument ends with a
// line or a NUL.

#include "cli/arguments.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "plumbline/error.hpp"

using namespace plumbline;

namespace {

[[noreturn]] void fail(const std::string& why) {
  std::fprintf(stderr, "broken promise: %s\n", why.c_str());
  std::abort();
}

std::vector<std::string> arguments_of(std::string_view text) {
  std::vector<std::string> arguments;
  while (!text.empty()) {
    const std::string_view argument =
        text.substr(0, text.find_first_of(std::string_view("\n\0", 2)));
    arguments.emplace_back(argument);
    text.remove_prefix(std::min(argument.size() + 1, text.size()));
  }
  return arguments;
}

void check_told(const std::string& text) {
  if (text.empty()) fail("nothing is said");
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20U && c != '\n') || byte == 0x7fU) fail("a control character: " + text);
  }
}

void check_number(double value) {
  if (!std::isfinite(value)) fail("a number that is not finite");
}

void check_limits(const cli::Limits& limits) {
  if (limits.seconds) check_number(*limits.seconds);
  if (limits.seconds && *limits.seconds <= 0) fail("a time that is not positive");
  if (limits.bytes && *limits.bytes == 0) fail("no memory");
}

void check_input(const cli::InputArguments& arguments) {
  check_limits(arguments.limits);
  check_number(arguments.reading.angle_bound);
  if (arguments.reading.angle_bound <= 0) fail("an angle that is not positive");
  if (sgn(arguments.reading.chord_tolerance) < 0) fail("a negative tolerance");
}

void check_command(const cli::ArrangeArguments& arguments) { check_input(arguments); }
void check_command(const cli::CheckArguments& arguments) {
  check_input(arguments);
  check_number(arguments.tolerance.value_or(0));
}
void check_command(const cli::MinimiseArguments& arguments) {
  check_input(arguments);
  check_number(arguments.tolerance.value_or(0));
  check_number(arguments.seconds.value_or(1));
  if (arguments.seconds && *arguments.seconds <= 0) fail("a time that is not positive");
}
void check_command(const cli::InfoArguments& arguments) {
  check_input(arguments);
  if (arguments.within && sgn(*arguments.within) < 0) fail("a negative distance");
}
void check_command(const cli::LarArguments& arguments) {
  check_input(arguments);
  if (arguments.radius && !cli::is_preset(*arguments.radius)) {
    check_number(nearest_double(parse_decimal(*arguments.radius)));
  }
  check_number(arguments.picture.explode);
}
void check_command(const cli::EvalArguments& arguments) { check_input(arguments); }
void check_command(const cli::RoomsArguments& arguments) { check_input(arguments); }
void check_command(const cli::OverlayArguments& arguments) {
  check_input(arguments);
  if (arguments.second.empty()) fail("one layer");
}
void check_command(const cli::SelectArguments& arguments) { check_input(arguments); }
void check_command(const cli::CoverageArguments& arguments) { check_input(arguments); }
void check_command(const cli::ValidityArguments& arguments) { check_input(arguments); }
void check_command(const cli::RepairArguments& arguments) {
  check_input(arguments);
  const RepairOptions& repair = arguments.repair;
  for (const Rational& size :
       {repair.weld.value_or(0), repair.grow.value_or(0), repair.trim.value_or(0),
        repair.sliver.value_or(0), repair.snap, repair.simplify}) {
    if (sgn(size) < 0) fail("a negative tolerance");
  }
}
void check_command(const cli::EnginesArguments& arguments) { check_limits(arguments.limits); }
void check_command(const cli::TileArguments& arguments) { check_limits(arguments.limits); }
void check_command(const cli::RandomArguments& arguments) {
  check_limits(arguments.limits);
  check_number(arguments.scaling);
  if (arguments.count > cli::kMostRandomSegments) fail("too many random segments");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto parsed = cli::parse(arguments_of({reinterpret_cast<const char*>(data), size}));
    if (const auto* told = std::get_if<cli::Notice>(&parsed)) {
      check_told(told->text);
    } else {
      std::visit([](const auto& command) { check_command(command); },
                 std::get<cli::Command>(parsed));
    }
  } catch (const Error& error) {
    if (error.code() == ErrorCode::Internal) fail(error.what());
    check_told(error.what());
  }
  return 0;
}
