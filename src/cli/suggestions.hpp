#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::cli {

/// The name that was probably meant: the only one that begins with the word, else the nearest one
/// by letters that are missing, wrong, too many or swapped, at most a third of them; "" for none.
std::string probable(std::string_view word, const std::vector<std::string>& names);
/// "; did you mean --radius?", or "".
std::string did_you_mean(std::string_view word, const std::vector<std::string>& names);

/// Lets only these values pass, in any case, and makes them lower case; the help and completion
/// know them by the validator's description.
CLI::Validator one_of(std::vector<std::string> names);
/// The values that are told behind a colon of the type's name, as `one_of` does it; or none.
std::vector<std::string> choices(const CLI::Option& option);
/// What the option's value is called in the help: "FILE"; "" for flags.
std::string value_name(const CLI::Option& option);

}  // namespace plumbline::cli
