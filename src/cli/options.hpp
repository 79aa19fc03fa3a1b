#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <limits>

#include "cli/commands.hpp"
#include "cli/formats.hpp"

namespace plumbline::cli {

/// Each adds a command to the tool, whose options are stored in `arguments`, which must live as
/// long as `app`.
CLI::App* add_command(CLI::App& app, ArrangeArguments& arguments);
CLI::App* add_command(CLI::App& app, CheckArguments& arguments);
CLI::App* add_command(CLI::App& app, MinimiseArguments& arguments);
CLI::App* add_command(CLI::App& app, InfoArguments& arguments);
CLI::App* add_command(CLI::App& app, RoomsArguments& arguments);
CLI::App* add_command(CLI::App& app, OverlayArguments& arguments);
CLI::App* add_command(CLI::App& app, SelectArguments& arguments);
CLI::App* add_command(CLI::App& app, CoverageArguments& arguments);
CLI::App* add_command(CLI::App& app, ValidityArguments& arguments);
CLI::App* add_command(CLI::App& app, RepairArguments& arguments);
CLI::App* add_command(CLI::App& app, LarArguments& arguments);
CLI::App* add_command(CLI::App& app, EvalArguments& arguments);
CLI::App* add_command(CLI::App& app, RandomArguments& arguments);
CLI::App* add_command(CLI::App& app, EnginesArguments& arguments);
CLI::App* add_command(CLI::App& app, TileArguments& arguments);

/// The file of an argument: "-" is standard input.
std::string file_of(const std::string& argument);
/// A drawing; `what` is what the help says of it.
void add_file(CLI::App& command, InputArguments& arguments, const char* what = nullptr);
/// How drawings are read, and what all commands have.
void add_reading(CLI::App& command, InputArguments& arguments);
/// -o and --format; `what` says what is written, `formats` in which forms, the first by default.
CLI::Option* add_output(CLI::App& command, std::optional<std::string>& output,
                        std::optional<std::string>& format, const std::string& what,
                        const std::vector<std::string_view>& formats);
/// Several drawings.
void add_files(CLI::App& command, DrawingArguments& arguments);
/// --tiles and --workers.
void add_tiles(CLI::App& command, ArrangeArguments& arguments);
/// How they are arranged and read.
void add_drawing(CLI::App& command, DrawingArguments& arguments);
/// The old name of --exact-engine, for commands where it means nothing else.
void add_old_engine(CLI::App& command, DrawingArguments& arguments);
/// --json, --quiet, --verbose and the limits.
void add_common(CLI::App& command, CommonArguments& arguments);
/// An exact number in drawing units.
void add_size(CLI::App& command, const std::string& name, std::optional<Rational>& size,
              const std::string& what);
/// Lets only integers of 64 bits pass, from the least to the most. CLI11 takes nothing for 0 and
/// lets negative ones overflow.
inline constexpr auto kAnyInteger = std::numeric_limits<std::int64_t>::max();
CLI::Validator integer(std::int64_t least = std::numeric_limits<std::int64_t>::min(),
                       std::int64_t most = kAnyInteger);
/// Lets only finite numbers pass.
CLI::Validator finite();
/// Those above 0.
CLI::Validator positive();
/// What may be a number, or the name of a preset.
CLI::Validator radius();
/// Widths of doors: "0.6..1.2". Throws: Error BadInput.
Range door_range(const std::string& text);
void add_threads(CLI::App& command, std::size_t& threads);
/// "bucket" or "cgal".
ExactEngine exact_engine(const std::string& name);

}  // namespace plumbline::cli
