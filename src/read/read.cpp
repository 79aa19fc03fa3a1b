#include "plumbline/read.hpp"

#include <fstream>

#include "plumbline/error.hpp"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& file) {
  const auto fail = [&file](ErrorCode code, const std::string& why) {
    throw Error(code, why, {file.string(), 0, 0});
  };
  std::error_code status;
  const fs::file_status kind = fs::status(file, status);
  if (!fs::exists(kind)) fail(ErrorCode::BadFile, "no such file");
  if (fs::is_directory(kind)) fail(ErrorCode::BadFile, "is a directory");
  if (!fs::is_regular_file(kind)) fail(ErrorCode::BadFile, "is not a regular file");
  const std::uintmax_t size = fs::file_size(file, status);
  if (status) fail(ErrorCode::BadFile, "cannot be read");
  if (size > kMaxFileSize) {
    fail(ErrorCode::Limit, "is larger than " + std::to_string(kMaxFileSize) + " bytes");
  }
  std::ifstream stream(file, std::ios::binary);
  std::string text(size, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(size));
  if (!stream) fail(ErrorCode::BadFile, "cannot be read");
  return text;
}

std::string lower_case_ending(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return ending;
}

}  // namespace

Structure read(const fs::path& file, const ReadOptions& options) {
  const std::string text = content(file);
  const std::string ending = lower_case_ending(file);
  if (ending == ".svg") return read_svg(text, file.string(), options);
  if (ending == ".dxf") return read_dxf(text, file.string(), options);
  if (ending == ".lines") return read_lines(text, file.string());
  throw Error(ErrorCode::BadInput, "unknown file name ending; known are .svg, .dxf and .lines",
              {file.string(), 0, 0}, ending);
}

}  // namespace plumbline
