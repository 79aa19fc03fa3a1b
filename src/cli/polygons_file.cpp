#include "cli/polygons_file.hpp"

#include "cli/complex_file.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {

void write_polygons(const Output& output, const DrawingArguments& arguments, const Drawing& drawing,
                    const std::vector<DrawnPolygon>& polygons, const std::string& note,
                    Report& report) {
  const std::string_view format = format_of(output);
  std::string text;
  if (format == "geojson") {
    PatchedFile patched;
    if (arguments.unit_square) {
      patched.why_not = "the drawing was mapped to the unit square";
    } else {
      patched = patched_file(drawing.file, arguments.reading, polygons);
    }
    report.set("properties_kept", patched.why_not.empty());
    if (!patched.why_not.empty()) {
      report.print("properties are not kept: {}\n", patched.why_not);
    }
    text = std::move(patched.text);
  }
  if (text.empty()) {
    const SegmentSet& input = drawing.input;
    text = feature_file(
        format,
        {{polygon_layer(polygons, input.files)}, input.crs, note, input.layers, input.unit});
  }
  write_file(*output.file, text);
  report.say_written(*output.file);
}

void ensure_some(std::size_t polygons, const std::string& file) {
  if (polygons > 0) return;
  throw Error(ErrorCode::BadInput,
              "nothing of the file is a polygon or a closed line (lines that enclose areas: "
              "plumbline rooms, or arrange --cells faces -o, makes polygons of them)",
              {file, 0, 0});
}

}  // namespace plumbline::cli
