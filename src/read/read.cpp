#include "plumbline/read.hpp"

#include <fstream>

#include "plumbline/error.hpp"
#include "read/gzip.hpp"
#include "read/json_kind.hpp"
#include "read/streams.hpp"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(ErrorCode code, const std::string& why, const fs::path& file) {
  throw Error(code, why, {file.string(), 0, 0});
}

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

std::string content(const fs::path& file) {
  const std::uintmax_t size = checked_size(file, kMaxFileSize);
  std::ifstream stream(file, std::ios::binary);
  std::string text(size, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(size));
  if (!stream) fail(ErrorCode::BadFile, "cannot be read", file);
  return text;
}

using StreamReader = Structure (*)(ByteStream&);

Structure read_streamed(const fs::path& file, StreamReader reader) {
  checked_size(file, kMaxStreamedFileSize);
  ByteStream bytes(file);
  return reader(bytes);
}

Structure read_json(const fs::path& file, const ReadOptions& options) {
  checked_size(file, kMaxStreamedFileSize);
  ByteStream beginning(file);
  switch (json_kind(beginning)) {
    case JsonKind::GeoJson:
      return read_streamed(file, read_geojson);
    case JsonKind::Lar:
      return read_streamed(file, read_lar_json);
    case JsonKind::Struct:
      break;
  }
  ByteStream bytes(file);
  return read_struct_json(bytes, options);
}

std::string lower_case_ending(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return ending;
}

Structure read_svgz(const fs::path& file, const ReadOptions& options) {
  const std::string bytes = content(file);
  const std::string name = file.string();
  return read_svg(is_gzip(bytes) ? inflated(bytes, name) : bytes, name, options);
}

}  // namespace

Structure read(const fs::path& file, const ReadOptions& options) {
  check_is_file(file);
  const std::string ending = lower_case_ending(file);
  if (ending == ".svg") return read_svg(content(file), file.string(), options);
  if (ending == ".svgz") return read_svgz(file, options);
  if (ending == ".dxf") return read_dxf(content(file), file.string(), options);
  if (ending == ".lines") return read_lines(content(file), file.string());
  if (ending == ".json") return read_json(file, options);
  if (ending == ".geojson") return read_streamed(file, read_geojson);
  if (ending == ".wkt") return read_streamed(file, read_wkt);
  if (ending == ".wkb") return read_streamed(file, read_wkb);
  if (ending == ".csv") return read_streamed(file, read_csv);
  throw Error(ErrorCode::BadInput,
              "unknown file name ending; known are .svg .svgz .dxf .lines .geojson .json .wkt .wkb "
              ".csv",
              {file.string(), 0, 0}, ending);
}

}  // namespace plumbline
