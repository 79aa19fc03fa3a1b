#include "plumbline/engines/files.hpp"

#include "engines/files/readers.hpp"
#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "read/input_file.hpp"
#include "read/json_kind.hpp"
#include "read/line_list.hpp"

namespace plumbline::files {
namespace {

namespace fs = std::filesystem;

Result read_json_result(const fs::path& file) {
  ByteStream beginning(file);
  const JsonKind kind = json_kind(beginning);
  ByteStream bytes(file);
  switch (kind) {
    case JsonKind::GeoJson:
      return read_features(bytes, plumbline::read_geojson);
    case JsonKind::Arrangement:
      return read_arrangement(bytes);
    case JsonKind::Lar: {
      ByteStream list(file);
      return is_line_list(list) ? read_features(bytes, plumbline::read_line_list) : read_lar(bytes);
    }
    case JsonKind::LarTrace:
      return read_lar(bytes);
    case JsonKind::Struct:
      break;
  }
  throw Error(ErrorCode::BadInput, "a LAR structure is a drawing and no result",
              {file.string(), 0, 0});
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

Result read(const fs::path& file) {
  check_is_file(file);
  checked_size(file, kMaxStreamedFileSize);
  const std::string ending = lower_case_ending(file);
  if (ending == ".json") return read_json_result(file);
  FeatureReader reader = nullptr;
  if (ending == ".geojson") reader = plumbline::read_geojson;
  if (ending == ".wkt") reader = plumbline::read_wkt;
  if (ending == ".wkb") reader = plumbline::read_wkb;
  if (ending == ".csv") reader = plumbline::read_csv;
  if (reader == nullptr) {
    throw Error(ErrorCode::BadInput,
                "unknown file name ending of a result; known are .json .geojson .wkt .wkb .csv",
                {file.string(), 0, 0}, ending);
  }
  ByteStream bytes(file);
  return read_features(bytes, reader);
}

}  // namespace plumbline::files
