#include "cli/completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cli/suggestions.hpp"
#include "cli/usage_error.hpp"

namespace plumbline::cli {
namespace {

/// An option as shells need it.
struct Completed {
  std::vector<std::string> names;    ///< "-o", "--output"
  std::string value;                 ///< "FILE"; "" of a flag
  std::vector<std::string> choices;  ///< of the value
  std::string text;

  bool is_flag() const { return value.empty(); }
  bool takes_files() const { return value == "FILE"; }
};

/// What an option does, up to where details begin.
std::string brief(const std::string& text) {
  std::size_t end = text.size();
  for (const char* mark : {" [", "; ", ": ", ". ", " ("}) end = std::min(end, text.find(mark));
  return text.substr(0, end);
}

std::vector<Completed> completed(const CLI::App& command) {
  std::vector<Completed> result;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty() || option->get_positional()) continue;
    Completed& item = result.emplace_back();
    for (const std::string& name : option->get_snames()) item.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) item.names.push_back("--" + name);
    item.value = value_name(*option);
    item.choices = choices(*option);
    item.text = brief(option->get_description());
  }
  return result;
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

/// Whether what stands for itself is a file; else it is a number.
bool reads_files(const CLI::App& command) { return command.get_option_no_throw("FILE") != nullptr; }

std::string in_quotes(std::string text) {
  return "'" + CLI::detail::find_and_replace(std::move(text), "'", "'\\''") + "'";
}

// ---- bash

/// What follows the options of a command that take a value.
std::string bash_values(const std::vector<Completed>& options) {
  std::string text;
  for (const Completed& option : options) {
    if (option.is_flag()) continue;
    const std::string what =
        option.takes_files()
            ? "files=1"
            : fmt::format("words={}", in_quotes(fmt::format("{}", fmt::join(option.choices, " "))));
    text += fmt::format("        {}) {} ;;\n", fmt::join(option.names, "|"), what);
  }
  return text;
}

std::string bash_command(const CLI::App& command) {
  const std::vector<Completed> options = completed(command);
  std::vector<std::string> names;
  for (const Completed& option : options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return fmt::format(
      "    {})\n      case $previous in\n{}        *) words='{}' {} ;;\n      esac ;;\n",
      command.get_name(), bash_values(options), fmt::join(names, " "),
      reads_files(command) ? "; [[ $current == -* ]] || files=1" : "");
}

std::string bash(const CLI::App& app) {
  std::string text =
      "# bash completion for plumbline, made from its options\n"
      "_plumbline() {\n"
      "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} words='' "
      "files=''\n"
      "  # --option=value is three words.\n"
      "  if [[ $current == '=' ]]; then\n"
      "    current=''\n"
      "  elif [[ $previous == '=' ]]; then\n"
      "    previous=${COMP_WORDS[COMP_CWORD-2]}\n"
      "  fi\n"
      "  ((COMP_CWORD == 1)) && previous=''\n"
      "  case $((COMP_CWORD > 1))${COMP_WORDS[1]} in\n";
  const std::string names = fmt::format("{}", fmt::join(command_names(app), " "));
  text += fmt::format("    0*) words='{} help --help --version' ;;\n    1help) words='{}' ;;\n",
                      names, names);
  for (const CLI::App* command : commands_of(app)) text += bash_command(*command).insert(4, "1");
  return text +
         "  esac\n"
         "  COMPREPLY=()\n"
         "  if [[ $files ]]; then\n"
         "    compopt -o filenames 2>/dev/null\n"
         "    mapfile -t COMPREPLY < <(compgen -f -- \"$current\")\n"
         "  else\n"
         "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n"
         "  fi\n"
         "}\n"
         "complete -F _plumbline plumbline\n";
}

// ---- zsh

/// Text within the brackets of an `_arguments` specification.
std::string zsh_text(std::string text) {
  for (const char* mark : {"\\", "[", "]", ":"}) {
    text = CLI::detail::find_and_replace(std::move(text), mark, std::string("\\") + mark);
  }
  return text;
}

std::string zsh_option(const Completed& option) {
  std::string names = option.names.front(), excluded;
  if (option.names.size() > 1) {
    excluded = fmt::format("({})", fmt::join(option.names, " "));
    names = fmt::format("'{{{}}}'", fmt::join(option.names, ","));
  }
  std::string value;
  if (option.takes_files()) {
    value = ":FILE:_files";
  } else if (!option.is_flag()) {
    value = fmt::format(":{}:({})", zsh_text(option.value), fmt::join(option.choices, " "));
  }
  const std::string quoted = in_quotes(fmt::format("[{}]{}", zsh_text(option.text), value));
  return option.names.size() > 1
             ? fmt::format("'{}'{{{}}}{}", excluded, fmt::join(option.names, ","), quoted)
             : in_quotes(names) + quoted;
}

std::string zsh(const CLI::App& app) {
  std::string text =
      "#compdef plumbline\n# zsh completion for plumbline, made from its options\n"
      "local state\nlocal -a commands=(\n";
  for (const CLI::App* command : commands_of(app)) {
    text += fmt::format(
        "  {}\n", in_quotes(command->get_name() + ':' + zsh_text(command->get_description())));
  }
  text +=
      "  'help:Tell the options of a command'\n)\n"
      "_arguments -C '(-)'{-h,--help}'[Tell this]' '(-)'{-V,--version}'[Tell the version]' \\\n"
      "  '1:command:->command' '*::argument:->argument'\n"
      "case $state in\n  command) _describe command commands ;;\n  argument)\n    case $words[1] "
      "in\n"
      "      help) _describe command commands ;;\n";
  for (const CLI::App* command : commands_of(app)) {
    text += fmt::format("      {})\n        _arguments -s", command->get_name());
    for (const Completed& option : completed(*command)) {
      text += " \\\n          " + zsh_option(option);
    }
    text += reads_files(*command) ? " \\\n          '*:FILE:_files' ;;\n" : " ;;\n";
  }
  return text + "    esac ;;\nesac\n";
}

// ---- fish

std::string fish_option(const std::string& command, const Completed& option) {
  std::string text =
      fmt::format("complete -c plumbline -n '__fish_seen_subcommand_from {}'", command);
  for (const std::string& name : option.names) {
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  if (option.takes_files()) text += " -r -F";
  if (!option.is_flag() && !option.takes_files()) text += " -x";
  if (!option.choices.empty()) text += fmt::format(" -a '{}'", fmt::join(option.choices, " "));
  return text + " -d " + CLI::detail::find_and_replace(in_quotes(option.text), "'\\''", "\\'") +
         '\n';
}

std::string fish(const CLI::App& app) {
  std::string text = "# fish completion for plumbline, made from its options\n";
  const std::string names = fmt::format("{}", fmt::join(command_names(app), " "));
  for (const CLI::App* command : commands_of(app)) {
    text += fmt::format(
        "complete -c plumbline -n __fish_use_subcommand -f -a {} -d {}\n", command->get_name(),
        CLI::detail::find_and_replace(in_quotes(command->get_description()), "'\\''", "\\'"));
  }
  text +=
      "complete -c plumbline -n __fish_use_subcommand -f -a help -d 'Tell the options of a "
      "command'\n";
  text += "complete -c plumbline -n __fish_use_subcommand -s V -l version -d 'Tell the version'\n";
  text += fmt::format("complete -c plumbline -n '__fish_seen_subcommand_from help' -f -a '{}'\n",
                      names);
  for (const CLI::App* command : commands_of(app)) {
    for (const Completed& option : completed(*command)) {
      text += fish_option(command->get_name(), option);
    }
  }
  return text;
}

}  // namespace

std::string completion(const CLI::App& app, std::string_view shell) {
  if (shell == "zsh") return zsh(app);
  return shell == "fish" ? fish(app) : bash(app);
}

}  // namespace plumbline::cli
