#include "read/input_file.hpp"

#include "plumbline/error.hpp"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(ErrorCode code, const std::string& why, const fs::path& file) {
  throw Error(code, why, {file.string(), 0, 0});
}

}  // namespace

void check_is_file(const fs::path& file) {
  std::error_code status;
  const fs::file_status kind = fs::status(file, status);
  if (!fs::exists(kind)) fail(ErrorCode::BadFile, "no such file", file);
  if (fs::is_directory(kind)) fail(ErrorCode::BadFile, "is a directory", file);
  if (!fs::is_regular_file(kind)) fail(ErrorCode::BadFile, "is not a regular file", file);
}

std::uintmax_t checked_size(const fs::path& file, std::uintmax_t most) {
  std::error_code status;
  const std::uintmax_t size = fs::file_size(file, status);
  if (status) fail(ErrorCode::BadFile, "cannot be read", file);
  if (size > most) {
    fail(ErrorCode::Limit, "is larger than " + std::to_string(most) + " bytes", file);
  }
  return size;
}

std::string lower_case_ending(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return ending;
}

}  // namespace plumbline
