#include "plumbline/engines/files.hpp"

#include <array>

#include "engines/files/readers.hpp"
#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "read/input_file.hpp"
#include "read/json_kind.hpp"
#include "read/line_list.hpp"

namespace plumbline::files {
namespace {

Result read_json_result(const InputFile& file) {
  ByteStream beginning = file.stream();
  const JsonKind kind = json_kind(beginning);
  ByteStream bytes = file.stream();
  switch (kind) {
    case JsonKind::GeoJson:
      return read_features(bytes, plumbline::read_geojson);
    case JsonKind::Arrangement:
      return read_arrangement(bytes);
    case JsonKind::Lar: {
      ByteStream list = file.stream();
      return is_line_list(list) ? read_features(bytes, plumbline::read_line_list) : read_lar(bytes);
    }
    case JsonKind::LarTrace:
      return read_lar(bytes);
    case JsonKind::Struct:
      break;
  }
  throw Error(ErrorCode::BadInput, "a LAR structure is a drawing and no result",
              {file.name(), 0, 0});
}

}  // namespace

void note_lost_faces(Result& result, std::size_t face_count) {
  const std::size_t lost = face_count + 1 - result.complex.face_count();
  if (lost == 0) return;
  Rejected& item = result.rejected.emplace_back();
  item.source.element = "face";
  item.reason = "faces without any edge are left out";
  item.harmless = true;  // the comparison finds what is missing
  item.text = std::to_string(lost) + (lost == 1 ? " face" : " faces");
}

Result read(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 5> kKnown{"json", "geojson", "wkt", "wkb", "csv"};
  const InputFile file(path);
  const std::string format = file.format(kKnown, "", " of a result");
  if (format == "json") return read_json_result(file);
  FeatureReader reader = plumbline::read_geojson;
  if (format == "wkt") reader = plumbline::read_wkt;
  if (format == "wkb") reader = plumbline::read_wkb;
  if (format == "csv") reader = plumbline::read_csv;
  ByteStream bytes = file.stream();
  return read_features(bytes, reader);
}

}  // namespace plumbline::files
