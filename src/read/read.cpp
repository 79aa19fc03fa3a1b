#include "plumbline/read.hpp"

#include <fstream>

#include "plumbline/error.hpp"
#include "read/gzip.hpp"
#include "read/input_file.hpp"
#include "read/json_kind.hpp"
#include "read/line_list.hpp"
#include "read/streams.hpp"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& file) {
  constexpr std::size_t kBlock = std::size_t{1} << 16U;
  std::string text;
  text.reserve(checked_size(file, kMaxFileSize) + kBlock);
  std::ifstream stream(file, std::ios::binary);
  // To the end that it has now: some files, as those of /proc, have no size beforehand.
  for (std::size_t size = 0; stream; text.resize(size)) {
    text.resize(size + kBlock);
    stream.read(text.data() + size, kBlock);
    size += static_cast<std::size_t>(stream.gcount());
    if (size > kMaxFileSize) {
      throw Error(ErrorCode::Limit, "grows while it is read", {file.string(), 0, 0});
    }
  }
  if (!stream.eof()) throw Error(ErrorCode::BadFile, "cannot be read", {file.string(), 0, 0});
  return text;
}

Structure read_streamed(const fs::path& file, const ReadOptions& options, FeatureReader reader) {
  checked_size(file, kMaxStreamedFileSize);
  ByteStream bytes(file);
  return reader(bytes, feature_options(options));
}

Structure read_json(const fs::path& file, const ReadOptions& options) {
  checked_size(file, kMaxStreamedFileSize);
  ByteStream beginning(file);
  switch (json_kind(beginning)) {
    case JsonKind::GeoJson:
      return read_streamed(file, options, read_geojson);
    case JsonKind::Lar: {
      ByteStream list(file);
      return read_streamed(
          file, options,
          is_line_list(list) ? read_line_list : static_cast<FeatureReader>(read_lar_json));
    }
    case JsonKind::Struct: {
      ByteStream bytes(file);
      return read_struct_json(bytes, options);
    }
    case JsonKind::Arrangement:
    case JsonKind::LarTrace:
      break;
  }
  throw Error(ErrorCode::BadInput,
              "JSON of a format that is no drawing: a result of this program (see check --against)",
              {file.string(), 0, 0});
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
  if (ending == ".lines") return read_lines(content(file), file.string(), options);
  if (ending == ".json") return read_json(file, options);
  if (ending == ".geojson") return read_streamed(file, options, read_geojson);
  if (ending == ".wkt") return read_streamed(file, options, read_wkt);
  if (ending == ".wkb") return read_streamed(file, options, read_wkb);
  if (ending == ".csv") return read_streamed(file, options, read_csv);
  throw Error(ErrorCode::BadInput,
              "unknown file name ending; known are .svg .svgz .dxf .lines .geojson .json .wkt .wkb "
              ".csv",
              {file.string(), 0, 0}, ending);
}

}  // namespace plumbline
