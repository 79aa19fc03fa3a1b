#include "cli/help.hpp"

#include <algorithm>
#include <sstream>

#include "cli/suggestions.hpp"

namespace plumbline::cli {
namespace {

/// Line by line; what is longer goes on below the first word.
std::string wrapped_lines(const std::string& text, std::size_t columns) {
  std::string result, line;
  for (std::istringstream lines(text); std::getline(lines, line);) {
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    if (line.size() <= columns) {
      result += line + '\n';
    } else {
      result += std::string(indent, ' ') + wrapped(line, indent, columns) + '\n';
    }
  }
  return result;
}

/// Names of other options, as they are said first.
std::string names_of(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) {
    names.push_back(option->get_snames().empty() ? "--" + option->get_lnames().front()
                                                 : "-" + option->get_snames().front());
  }
  std::ranges::sort(names);
  return CLI::detail::join(names, ", ");
}

HelpEntry entry_of(const CLI::Option& option) {
  HelpEntry entry{"", option.get_description()};
  for (const std::string& name : option.get_snames()) entry.name += "-" + name + ", ";
  for (const std::string& name : option.get_lnames()) entry.name += "--" + name + ", ";
  if (option.get_positional()) entry.name = option.get_name(true, false) + ", ";
  entry.name.resize(entry.name.size() - 2);
  if (const std::string value = value_name(option); !value.empty()) entry.name += ' ' + value;
  if (!option.get_needs().empty()) entry.text += " (with " + names_of(option.get_needs()) + ")";
  if (!option.get_excludes().empty()) {
    entry.text += " (not with " + names_of(option.get_excludes()) + ")";
  }
  return entry;
}

class Help : public CLI::FormatterBase {
 public:
  explicit Help(std::size_t columns) : columns_(std::max(columns, kNarrowest)) {}

  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode /*mode*/) const override {
    std::string text = wrapped_lines(app->get_description() + '\n', columns_) + '\n';
    text += wrapped("Usage: " + usage_line(*app, name), kIndent, columns_) + '\n';
    const HelpGroup commands = help_commands(*app);
    if (!commands.entries.empty()) text += group_text(commands);
    for (const HelpGroup& group : help_groups(*app)) text += group_text(group);
    return text + '\n' + wrapped_lines(app->get_footer() + '\n', columns_);
  }

 private:
  static constexpr std::size_t kNarrowest = 20, kIndent = 4, kColumn = 27, kWide = 70;

  std::string group_text(const HelpGroup& group) const {
    std::string text = '\n' + group.title + ":\n";
    const std::size_t column = columns_ < kWide ? kIndent : kColumn;
    for (const HelpEntry& entry : group.entries) {
      const std::string name = "  " + entry.name;
      const bool is_short = name.size() + 1 < column;
      text += name +
              (is_short ? std::string(column - name.size(), ' ') : '\n' + std::string(column, ' '));
      text += wrapped(entry.text, column, columns_) + '\n';
    }
    return text;
  }

  std::size_t columns_;
};

}  // namespace

std::string wrapped(const std::string& text, std::size_t indent, std::size_t columns) {
  std::string result, word;
  std::size_t used = indent;
  for (std::istringstream words(text); words >> word;) {
    if (!result.empty()) {
      const bool fits = used + 1 + word.size() <= columns;
      result += fits ? " " : '\n' + std::string(indent, ' ');
      used = fits ? used + 1 : indent;
    }
    result += word;
    used += word.size();
  }
  return result;
}

std::vector<HelpGroup> help_groups(const CLI::App& command) {
  std::vector<HelpGroup> groups;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;
    const std::string title = option->get_positional() ? "Arguments" : option->get_group();
    auto group = std::ranges::find(groups, title, &HelpGroup::title);
    if (group == groups.end()) group = groups.insert(group, {title, {}});
    group->entries.push_back(entry_of(*option));
  }
  return groups;
}

HelpGroup help_commands(const CLI::App& app) {
  HelpGroup group{"Commands", {}};
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_group().empty()) continue;
    group.entries.push_back({command->get_name(), command->get_description()});
  }
  return group;
}

std::string usage_line(const CLI::App& command, const std::string& name) {
  std::string line = name;
  if (!help_commands(command).entries.empty()) line += " COMMAND";
  line += " [OPTIONS]";
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) continue;
    line +=
        ' ' + option->get_name(true, false) + (option->get_items_expected_max() > 1 ? "..." : "");
  }
  return line;
}

std::shared_ptr<CLI::FormatterBase> help_format(std::size_t columns) {
  return std::make_shared<Help>(columns);
}

}  // namespace plumbline::cli
