#include "plumbline/read.hpp"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <optional>

#include "plumbline/error.hpp"
#include "read/first_bytes.hpp"
#include "read/gzip.hpp"
#include "read/input_file.hpp"
#include "read/json_kind.hpp"
#include "read/layer_choice.hpp"
#include "read/line_list.hpp"
#include "read/streams.hpp"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStandardInput = "/dev/stdin";

std::string content(const fs::path& file) {
  constexpr std::size_t kBlock = std::size_t{1} << 16U;
  std::ifstream opened;
  if (file != kStandardInput) opened.open(file, std::ios::binary);
  std::istream& stream = file == kStandardInput ? std::cin : opened;
  std::string text;
  // To the end that it has now: pipes, and some files, as those of /proc, have no size beforehand.
  for (std::size_t size = 0; stream; text.resize(size)) {
    text.resize(size + kBlock);
    stream.read(text.data() + size, kBlock);
    size += static_cast<std::size_t>(stream.gcount());
    if (size > kMaxFileSize) {
      throw Error(ErrorCode::Limit, "is larger than " + std::to_string(kMaxFileSize) + " bytes",
                  {file.string(), 0, 0});
    }
  }
  if (!stream.eof()) throw Error(ErrorCode::BadFile, "cannot be read", {file.string(), 0, 0});
  return text;
}

/// A drawing's bytes: in a file that can be read again, or in memory.
class Input {
 public:
  explicit Input(const fs::path& file) : file_(file) {
    std::error_code ignored;
    if (file != kStandardInput && !fs::is_fifo(file, ignored)) {
      check_is_file(file);
    } else {
      text_ = content(file);
    }
  }

  const std::string& name() const { return file_.native(); }
  /// Requires: not called before.
  std::string text() {
    if (text_) return *std::move(text_);
    checked_size(file_, kMaxFileSize);
    return content(file_);
  }
  ByteStream stream() const {
    if (text_) return {*text_, {name(), 1, 1}};
    checked_size(file_, kMaxStreamedFileSize);
    return ByteStream(file_);
  }

 private:
  fs::path file_;
  std::optional<std::string> text_;
};

std::string_view known_format(std::string_view name) {
  const auto found = std::ranges::find(kFormats, name);
  return found == kFormats.end() ? "" : *found;
}

/// One of kFormats. Throws: Error BadInput.
std::string_view format_of(const fs::path& file, const Input& input, const ReadOptions& options) {
  constexpr std::size_t kBeginning = 4096;
  const std::string ending = lower_case_ending(file);
  if (options.format.empty() && ending.empty()) {
    ByteStream bytes = input.stream();
    const std::string_view told = format_by_first_bytes(bytes.ahead(kBeginning));
    if (!told.empty()) return told;
    throw Error(ErrorCode::BadInput, "no file name ending, and the first bytes tell no format",
                {input.name(), 0, 0});
  }
  const std::string_view format =
      known_format(options.format.empty() ? ending.substr(1) : options.format);
  if (!format.empty()) return format;
  std::string known;
  for (const std::string_view name : kFormats) known += " ." + std::string(name);
  throw Error(
      ErrorCode::BadInput,
      options.format.empty() ? "unknown file name ending; known are" + known : "unknown format",
      {input.name(), 0, 0}, options.format.empty() ? ending : options.format);
}

Structure read_streamed(const Input& input, const ReadOptions& options, FeatureReader reader) {
  ByteStream bytes = input.stream();
  return reader(bytes, feature_options(options));
}

/// For formats without layers. Throws: Error BadInput where some are asked for.
Structure without_layers(Structure structure, const ReadOptions& options) {
  LayerChoice(options.layers, options.without_layers).check(structure.files.at(0));
  return structure;
}

Structure read_json(const Input& input, const ReadOptions& options) {
  ByteStream beginning = input.stream();
  switch (json_kind(beginning)) {
    case JsonKind::GeoJson:
      return read_streamed(input, options, read_geojson);
    case JsonKind::Lar: {
      ByteStream list = input.stream();
      return read_streamed(
          input, options,
          is_line_list(list) ? read_line_list : static_cast<FeatureReader>(read_lar_json));
    }
    case JsonKind::Struct: {
      ByteStream bytes = input.stream();
      return without_layers(read_struct_json(bytes, options), options);
    }
    case JsonKind::Arrangement:
    case JsonKind::LarTrace:
      break;
  }
  throw Error(ErrorCode::BadInput,
              "JSON of a format that is no drawing: a result of this program (see check --against)",
              {input.name(), 0, 0});
}

Structure read_svgz(Input& input, const ReadOptions& options) {
  const std::string bytes = input.text();
  return read_svg(is_gzip(bytes) ? inflated(bytes, input.name()) : bytes, input.name(), options);
}

}  // namespace

Structure read(const fs::path& file, const ReadOptions& options) {
  Input input(file);
  const std::string_view format = format_of(file, input, options);
  const std::string& name = input.name();
  if (format == "svg") return read_svg(input.text(), name, options);
  if (format == "svgz") return read_svgz(input, options);
  if (format == "dxf") return read_dxf(input.text(), name, options);
  if (format == "lines") {
    return without_layers(read_lines(input.text(), name, options), options);
  }
  if (format == "json") return read_json(input, options);
  if (format == "geojson") return read_streamed(input, options, read_geojson);
  if (format == "wkt") return read_streamed(input, options, read_wkt);
  if (format == "wkb") return read_streamed(input, options, read_wkb);
  ensure(format == "csv", "every format has its reader");
  return read_streamed(input, options, read_csv);
}

}  // namespace plumbline
