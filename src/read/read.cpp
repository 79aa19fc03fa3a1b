#include "plumbline/read.hpp"

#include "plumbline/error.hpp"
#include "read/gzip.hpp"
#include "read/input_file.hpp"
#include "read/json_kind.hpp"
#include "read/layer_choice.hpp"
#include "read/line_list.hpp"
#include "read/streams.hpp"

namespace plumbline {
namespace {

Structure read_streamed(const InputFile& input, const ReadOptions& options, FeatureReader reader) {
  ByteStream bytes = input.stream();
  return reader(bytes, feature_options(options));
}

/// For formats without layers. Throws: Error BadInput where some are asked for.
Structure without_layers(Structure structure, const ReadOptions& options) {
  LayerChoice(options.layers, options.without_layers).check(structure.files.at(0));
  return structure;
}

Structure read_json(const InputFile& input, const ReadOptions& options) {
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

Structure read_svgz(InputFile& input, const ReadOptions& options) {
  const std::string bytes = input.text();
  return read_svg(is_gzip(bytes) ? inflated(bytes, input.name()) : bytes, input.name(), options);
}

}  // namespace

Structure read(const std::filesystem::path& file, const ReadOptions& options) {
  InputFile input(file);
  const std::string format = input.format(kFormats, options.format);
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
