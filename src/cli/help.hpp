#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

namespace plumbline::cli {

/// A line of the help: an option, or what stands for files.
struct HelpEntry {
  std::string name;  ///< "-o, --output FILE"
  std::string text;
};
struct HelpGroup {
  std::string title;
  std::vector<HelpEntry> entries;
};
/// What a command's help, and its manual page, tell of its options, group by group.
std::vector<HelpGroup> help_groups(const CLI::App& command);
/// The same of the tool's commands.
HelpGroup help_commands(const CLI::App& app);
/// "plumbline check [OPTIONS] FILE..."
std::string usage_line(const CLI::App& command, const std::string& name);

/// The words of a text in lines of so many columns; all but the first begin with the indent.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t columns);

/// Writes the help of the tool and of its commands in lines of at most so many columns, as far as
/// words allow it.
std::shared_ptr<CLI::FormatterBase> help_format(std::size_t columns);

}  // namespace plumbline::cli
