#include "cli/safe_output.hpp"

#include <fmt/format.h>

#include <vector>

#include "cli/outputs.hpp"
#include "cli/print.hpp"
#include "cli/progress.hpp"
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

Features features_of(const ArrangeArguments& arguments, const Drawing& drawing,
                     const Rounding& rounding) {
  Features features{{}, drawing.input.crs, note_of(rounding)};
  for (const std::string& cells : arguments.cells) {
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

std::string feature_file(const std::string& kind, const Features& features) {
  if (kind == ".geojson") return to_geojson(features);
  if (kind == ".wkt") return to_wkt(features);
  if (kind == ".wkb") return to_wkb_hex(features);
  return to_csv(features.layers.front());
}

}  // namespace

bool is_of_features(const std::string& ending) {
  return ending == ".geojson" || ending == ".wkt" || ending == ".csv" || ending == ".wkb";
}

SafeOutput safe_output(const ArrangeArguments& arguments, const Drawing& drawing) {
  const Progress progress(fmt::format("rounding {} vertices", drawing.complex.vertices.size()));
  const Rounding rounding =
      safely_rounded(drawing.complex, arguments.grid, {arguments.threads, {}});
  SafeOutput output;
  output.line = line(drawing, arguments.grid, rounding) +
                "\nwritten: " + counts_line(rounding.complex, rounding.complex.vertices.size());
  const std::string kind = ending(*arguments.output);
  if (!rounding.valid_as_doubles) {
    if (kind == ".svg" || is_of_features(kind)) {
      throw Error(ErrorCode::BadInput,
                  "such a file holds doubles, which so many --decimals are too fine for; ask for "
                  "fewer, or for a .json or .lines file",
                  {}, *arguments.output);
    }
    output.line += "\nread as doubles, these decimals are no valid complex";
  }
  if (kind == ".json") {
    output.content = to_json(drawing.complex, drawing.input, arguments.grid, rounding);
  } else if (is_of_features(kind)) {
    output.content = feature_file(kind, features_of(arguments, drawing, rounding));
  } else if (kind == ".svg") {
    output.content = to_svg(rounding.complex, drawing.input.y_up);
  } else {
    output.content = to_lines(rounding.complex);
  }
  return output;
}

}  // namespace plumbline::cli
