#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace plumbline {

/// Throws: Error BadFile for what is no regular file.
void check_is_file(const std::filesystem::path& file);
/// The file's size in bytes. Throws: Error BadFile; Limit for more than `most`.
std::uintmax_t checked_size(const std::filesystem::path& file, std::uintmax_t most);
/// The ending of the file's name, ".json", in lower case.
std::string lower_case_ending(const std::filesystem::path& file);

}  // namespace plumbline
