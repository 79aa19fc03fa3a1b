#include "cli/manual.hpp"

#include <sstream>

#include "cli/help.hpp"
#include "cli/usage_error.hpp"

namespace plumbline::cli {
namespace {

std::string upper_case(std::string text) {
  for (char& c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return text;
}

/// Text that troff shows as it is; "-" is the character of options.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (result.empty() && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  return result + '\n';
}

/// Lines that stay lines.
std::string example(const std::string& text) {
  std::string result = ".nf\n", line;
  for (std::istringstream lines(text); std::getline(lines, line);) {
    line.erase(0, line.find_first_not_of(' '));
    if (!line.empty()) result += escaped(line);
  }
  return result + ".fi\n";
}

/// Words that troff fills lines with.
std::string prose(const std::string& text) {
  constexpr std::size_t kColumns = 70;
  std::string result, line;
  for (std::istringstream lines(wrapped(text, 0, kColumns)); std::getline(lines, line);) {
    result += escaped(line);
  }
  return result;
}

std::string section(const std::string& title) { return ".SH " + title + '\n'; }

std::string entries(const HelpGroup& group) {
  std::string text;
  for (const HelpEntry& entry : group.entries) {
    text += ".TP\n.B " + escaped(entry.name) + prose(entry.text);
  }
  return text;
}

std::string head(const std::string& name, const std::string& what, const CLI::App& app) {
  return ".TH " + upper_case(name) + " 1 \"\" \"" + app.version() + "\" \"User Commands\"\n" +
         section("NAME") + prose(name + " - " + what);
}

/// The parts of what is told below the options: "Examples: ..." line by line, then sentences.
std::string footer(const std::string& text) {
  std::string examples, rest, line;
  for (std::istringstream lines(text); std::getline(lines, line);) {
    const std::size_t call = line.find("plumbline ");
    const bool is_example = call != line.npos && (call == 0 || line.find(':') < call ||
                                                  line.find_first_not_of(' ') == call);
    (is_example ? examples += line.substr(call) : rest += line) += '\n';
  }
  std::string result;
  if (!examples.empty()) result += section("EXAMPLES") + example(examples);
  if (rest.find_first_not_of(" \n") != rest.npos) result += section("NOTES") + prose(rest);
  return result;
}

std::string tool_page(const CLI::App& app) {
  const std::string all = app.get_description();
  const std::size_t end = all.find('\n');
  std::string text = head(app.get_name(), all.substr(0, end), app);
  text += section("SYNOPSIS") + ".B " + escaped(usage_line(app, app.get_name()));
  text += section("DESCRIPTION") + "Each command has a manual page of its own.\n";
  text += section("COMMANDS") + entries(help_commands(app)) + section("OPTIONS");
  for (const HelpGroup& group : help_groups(app)) text += entries(group);
  text += section("EXIT STATUS") + prose(app.get_footer().substr(app.get_footer().find(": ") + 2));
  text += section("EXAMPLES") + example(all.substr(end, all.find("\n\n", end + 2) - end));
  text += section("SEE ALSO");
  for (const std::string& name : command_names(app)) text += ".BR plumbline\\-" + name + " (1)\n";
  return text;
}

}  // namespace

std::string manual(const CLI::App& app, const std::string& name) {
  if (name.empty()) return tool_page(app);
  const CLI::App& command = *app.get_subcommand(name);
  std::string text = head("plumbline-" + name, command.get_description(), app);
  text += section("SYNOPSIS") + ".B " + escaped(usage_line(command, "plumbline " + name));
  for (const HelpGroup& group : help_groups(command)) {
    text += section(upper_case(group.title)) + entries(group);
  }
  return text + footer(command.get_footer()) + section("SEE ALSO") +
         ".BR plumbline (1), which has the exit codes\n";
}

}  // namespace plumbline::cli
