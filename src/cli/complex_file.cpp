#include "cli/complex_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "cli/print.hpp"
#include "cli/progress.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output.hpp"

namespace plumbline::cli {
namespace {

template <class Merges>
std::size_t merged_count(const Merges& merges) {
  std::size_t count = 0;
  for (const auto& merge : merges) count += merge.from.size();
  return count;
}

/// What happened, "no change of incidences" excepted, in words.
std::string changes_text(const RoundingChanges& c) {
  std::vector<std::string> parts;
  const auto say = [&](std::size_t count, const std::string& text) {
    if (count > 0) parts.push_back(text);
  };
  say(c.merged_vertices.size(),
      fmt::format("{} vertices merged into {}", merged_count(c.merged_vertices),
                  c.merged_vertices.size()));
  say(c.bent_edges.size(), fmt::format("{} edges bent by at most {:.3g}", c.bent_edges.size(),
                                       nearest_sqrt(c.largest_squared_bend())));
  say(c.merged_edges.size(),
      fmt::format("{} edges merged into {}", merged_count(c.merged_edges), c.merged_edges.size()));
  say(c.vanished_edges.size(), fmt::format("{} edges vanished", c.vanished_edges.size()));
  say(c.vanished_faces.size(), fmt::format("{} faces vanished", c.vanished_faces.size()));
  say(c.split_faces.size(), fmt::format("{} faces split", c.split_faces.size()));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string line(const Drawing& drawing, const Grid& grid, const Rounding& rounding) {
  const RoundingChanges c = changes(drawing.complex, rounding);
  const std::string movement =
      fmt::format("largest movement {:.3g}", nearest_sqrt(c.largest_squared_movement()));
  if (rounding.method == RoundingMethod::NearestDoubles ||
      (grid.decimals && rounding.has_same_incidences())) {
    return fmt::format("rounded to {}: same incidences, proven; {}", to_text(grid), movement);
  }
  const double spacing = nearest_double(rounding.spacing);
  if (rounding.has_same_incidences()) {
    return fmt::format("rounded to multiples of {:.3g}: same incidences, proven; {}", spacing,
                       movement);
  }
  return fmt::format("snap rounded to multiples of {:.3g}: {}; {}; verified", spacing,
                     changes_text(c), movement);
}

Features features_of(std::string_view format, const ArrangeArguments& arguments,
                     const Drawing& drawing, const Rounding& rounding) {
  Features features{
      {}, drawing.input.crs, note_of(rounding), drawing.input.layers, drawing.input.unit};
  std::vector<std::string> chosen = arguments.cells;
  if (chosen.empty()) chosen.emplace_back(format == "dxf" ? "edges" : "faces");
  for (const std::string& cells : chosen) {
    if (cells == "faces") {
      features.layers.push_back(face_layer(drawing.complex, drawing.input, rounding));
    } else if (cells == "edges") {
      features.layers.push_back(edge_layer(drawing.input, rounding));
    } else {
      features.layers.push_back(vertex_layer(rounding));
    }
  }
  return features;
}

struct FeatureWriter {
  std::string_view format;
  std::string (*write)(const Features&);
};
constexpr std::array kFeatureWriters{
    FeatureWriter{"geojson", to_geojson},
    FeatureWriter{"json", to_geojson},  // of findings
    FeatureWriter{"topojson", to_topojson},
    FeatureWriter{"dxf", to_dxf},
    FeatureWriter{"wkt", to_wkt},
    FeatureWriter{"csv", [](const Features& features) { return to_csv(features.layers.front()); }},
    FeatureWriter{"wkb", to_wkb_hex},
};

/// The formats of complexes that are not made of features.
struct ComplexWriter {
  std::string_view format;
  bool holds_decimals = false;  ///< of any length, not just doubles
  std::string (*exact)(const Drawing&) = nullptr;
  std::string (*rounded)(const Drawing&, const Grid&, const Rounding&) = nullptr;
};
constexpr std::array kComplexWriters{
    ComplexWriter{"json", true, [](const Drawing& d) { return to_json(d.complex, d.input); },
                  [](const Drawing& d, const Grid& grid, const Rounding& rounding) {
                    return to_json(d.complex, d.input, grid, rounding);
                  }},
    ComplexWriter{"svg", false, [](const Drawing& d) { return to_svg(d.complex, d.input.y_up); },
                  [](const Drawing& d, const Grid&, const Rounding& rounding) {
                    return to_svg(rounding.complex, d.input.y_up);
                  }},
    ComplexWriter{
        "obj", false, nullptr,
        [](const Drawing&, const Grid&, const Rounding& rounding) { return to_obj(rounding); }},
    ComplexWriter{"lar", true, [](const Drawing& d) { return to_lar_json(d.complex); },
                  [](const Drawing&, const Grid&, const Rounding& rounding) {
                    return to_lar_json(rounding.complex);
                  }},
    ComplexWriter{"lines", true, [](const Drawing& d) { return to_lines(d.complex); },
                  [](const Drawing&, const Grid&, const Rounding& rounding) {
                    return to_lines(rounding.complex);
                  }},
};

/// None: it is a format of features.
const ComplexWriter* writer_of(std::string_view format) {
  const auto found = std::ranges::find(kComplexWriters, format, &ComplexWriter::format);
  return found == kComplexWriters.end() ? nullptr : &*found;
}

ComplexFile rounded_file(std::string_view format, const ArrangeArguments& arguments,
                         const Drawing& drawing) {
  const Progress progress(fmt::format("rounding {} vertices", drawing.complex.vertices.size()),
                          arguments);
  const Rounding rounding =
      safely_rounded(drawing.complex, arguments.grid, {arguments.threads, {}});
  ComplexFile file;
  file.line = line(drawing, arguments.grid, rounding) + "\nwritten: " +
              counts_line(counts(rounding.complex, rounding.complex.vertices.size()));
  const ComplexWriter* writer = writer_of(format);
  if (!rounding.valid_as_doubles) {
    if (writer == nullptr || !writer->holds_decimals) {
      throw Error(ErrorCode::BadInput,
                  "such a file holds doubles, which so many --decimals are too fine for; ask for "
                  "fewer, or for a .json or .lines file",
                  {}, *arguments.output);
    }
    file.line += "\nread as doubles, these decimals are no valid complex";
  }
  file.content = writer == nullptr
                     ? feature_file(format, features_of(format, arguments, drawing, rounding))
                     : writer->rounded(drawing, arguments.grid, rounding);
  return file;
}

}  // namespace

std::string feature_file(std::string_view format, const Features& features) {
  const auto found = std::ranges::find(kFeatureWriters, format, &FeatureWriter::format);
  ensure(found != kFeatureWriters.end(), "the format is one of features");
  return found->write(features);
}

bool is_always_rounded(std::string_view format) {
  const ComplexWriter* writer = writer_of(format);
  return writer == nullptr || writer->exact == nullptr;
}

ComplexFile complex_file(std::string_view format, const ArrangeArguments& arguments,
                         const Drawing& drawing) {
  if (arguments.compact) return {to_compact_json(drawing.complex, drawing.input), ""};
  const bool lacks_digits = format == "lines" && !are_decimals(drawing.complex);
  if (arguments.safe || is_always_rounded(format) || lacks_digits) {
    return rounded_file(format, arguments, drawing);
  }
  return {writer_of(format)->exact(drawing), ""};
}

}  // namespace plumbline::cli
