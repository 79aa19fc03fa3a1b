#include "cli/usage_error.hpp"

#include <algorithm>

#include "cli/formats.hpp"
#include "cli/suggestions.hpp"

namespace plumbline::cli {
namespace {

Error usage(const std::string& message) { return {ErrorCode::BadInput, message}; }

/// An argument in a sentence: in quotes, shortened, without what a terminal would obey.
std::string quoted(const std::string& text) {
  constexpr std::size_t kShown = 60;
  const std::string shown = valid_utf8(line_text(text).substr(0, kShown));
  return '"' + shown + (text.size() > kShown ? "...\"" : "\"");
}

/// "--radius", "-o" and so on.
std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;  // old names
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// What is neither an option nor taken by one.
Error unexpected(const CLI::App& command, const std::vector<std::string>& extras,
                 const std::string& see) {
  const auto is_option = [](const std::string& text) { return text.size() > 1 && text[0] == '-'; };
  const auto option = std::ranges::find_if(extras, is_option);
  if (option == extras.end()) {
    return usage(command.get_name() + " takes no further argument: " + quoted(extras.front()) +
                 see);
  }
  const std::string name = option->substr(0, option->find('='));
  std::string meant = did_you_mean(name, option_names(command));
  if (meant.empty() && name == "--format") meant = "; did you mean --from?";
  return usage("unknown option of " + command.get_name() + ": " + quoted(*option) + meant + see);
}

bool ends_with(std::string& text, const std::string& end) {
  if (!text.ends_with(end)) return false;
  text.resize(text.size() - end.size());
  return true;
}

/// The first part of the text, up to the separator.
std::string before(const std::string& text, const std::string& separator) {
  return text.substr(0, text.find(separator));
}

/// CLI11's sentence in our words.
std::string said(const CLI::ParseError& error) {
  std::string text = error.what();
  const std::string kind = error.get_name();
  if (kind == "RequiredError" && ends_with(text, " is required")) return text + " is missing";
  if (kind == "RequiresError") {
    return before(text, " requires ") + " needs " + text.substr(text.rfind(' ') + 1);
  }
  if (kind == "ExcludesError") {
    return before(text, " excludes ") + " and " + text.substr(text.rfind(' ') + 1) +
           " do not go together";
  }
  if (kind == "ConversionError") {
    return before(text.substr(std::min(text.find("--"), text.size())), " = ") +
           " takes no such value";
  }
  if (kind != "ArgumentMismatch") return text;
  if (ends_with(text, " was given a disallowed flag override")) {
    return (text.starts_with('-') ? "" : "--") + text + " takes no value";
  }
  if (text.find("At Most") != text.npos) return before(text, ":") + " is given more than once";
  if (ends_with(text, " missing")) {
    return before(text, ":") + " needs a value, " + text.substr(text.rfind(' ') + 1);
  }
  return text;
}

}  // namespace

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (!command->get_group().empty()) names.push_back(command->get_name());
  }
  return names;
}

void check_command_is_known(const CLI::App& app, const std::vector<std::string>& arguments) {
  std::vector<std::string> names = command_names(app);
  std::ranges::sort(names);
  const std::string known = "the commands are " + CLI::detail::join(names, ", ");
  if (arguments.empty()) throw usage("which command? " + known + "; plumbline help tells more");
  const std::string& first = arguments[0];
  const bool is_command = std::ranges::any_of(
      app.get_subcommands({}), [&](const CLI::App* command) { return command->check_name(first); });
  if (is_command || app.get_option_no_throw(first) != nullptr) return;
  if (first.starts_with('-')) {
    throw usage("a command comes first, not " + quoted(first) + "; " + known);
  }
  const std::string meant = did_you_mean(first, names);
  throw usage("unknown command: " + quoted(first) + (meant.empty() ? "; " + known : meant));
}

Error usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const auto called = app.get_subcommands();
  const CLI::App& command = called.empty() ? app : *called.front();
  const std::string see =
      " (plumbline " + (called.empty() ? "" : command.get_name() + ' ') + "--help tells more)";
  const std::vector<std::string> extras = app.remaining(true);
  if (!extras.empty()) return unexpected(command, extras, see);
  return usage(said(error) + see);
}

}  // namespace plumbline::cli
