// Do curves meet what they were drawn to meet?
// Usage: plumbline_curves scenes COUNT: scenes whose structure is known, random but the same on
//        every machine; the last row counts those that came out otherwise, and then it fails.
//        plumbline_curves drawings FILE...: loose ends with and without joining curves.
// Prints a Markdown table.

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <map>
#include <string>

#include "geometry/box_tree.hpp"
#include "inputs/curve_scenes.hpp"
#include "plumbline/plumbline.hpp"

using namespace plumbline;

namespace {

std::size_t antennas(const ExactComplex& complex) {
  std::size_t count = 0;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    if (complex.is_antenna(EdgeId(e))) ++count;
  }
  return count;
}

/// Ends of a single edge, and of these the ones that miss another edge by at most `reach`.
struct LooseEnds {
  std::size_t all = 0, near = 0;
};
LooseEnds loose_ends(const ExactComplex& complex, double reach) {
  std::vector<std::size_t> degree(complex.vertices.size());
  std::vector<BoxD> boxes;
  for (const Edge& e : complex.edges) {
    ++degree[e.tail];
    ++degree[e.head];
    BoxD box{complex.vertices.nearest(e.tail), complex.vertices.nearest(e.tail)};
    box.include(complex.vertices.nearest(e.head));
    boxes.push_back(grown(box, 2 * reach));
  }
  const BoxTree tree(boxes);
  LooseEnds result;
  const Rational squared = rational_from(reach) * rational_from(reach);
  for (std::size_t v = 0; v < degree.size(); ++v) {
    if (degree[v] != 1) continue;
    ++result.all;
    const Point p = complex.vertices[v];
    const PointD at = complex.vertices.nearest(v);
    for (const std::size_t i : tree.meeting(BoxD{at, at})) {
      const Edge& e = complex.edges[i];
      if (e.tail == v || e.head == v) continue;
      if (squared_distance(p, complex.vertices[e.tail], complex.vertices[e.head]) > squared) {
        continue;
      }
      ++result.near;
      break;
    }
  }
  return result;
}

double extent_of(const SegmentSet& set) {
  BoxD box{};
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    const Segment s = set.segments[i];
    if (i == 0) box = {nearest(s.a), nearest(s.a)};
    box.include(nearest(s.a));
    box.include(nearest(s.b));
  }
  return box.longer_side();
}

int drawings(int count, char** files) {
  fmt::print(
      "| drawing | joined | loose ends | near | bounded faces | loose ends | near | bounded faces "
      "with `--keep-curves` |\n"
      "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  for (int i = 0; i < count; ++i) {
    ReadOptions options;
    const SegmentSet joined = evaluate(read(files[i], options));
    options.join_curves = false;
    const SegmentSet apart = evaluate(read(files[i], options));
    if (joined.segments == apart.segments) continue;
    const double reach = 1e-9 * extent_of(joined);
    std::string what;
    for (std::size_t k = apart.ledger.size(); k < joined.ledger.size(); ++k) {
      what += fmt::format("{}{} ({})", what.empty() ? "" : "; ", joined.ledger[k].what,
                          joined.ledger[k].bound);
    }
    const auto row = [&](const SegmentSet& set) {
      const ExactComplex complex = arrange(set);
      const LooseEnds ends = loose_ends(complex, reach);
      return fmt::format("{} | {} | {}", ends.all, ends.near, complex.face_count() - 1);
    };
    fmt::print("| `{}` | {} | {} | {} |\n", std::filesystem::path(files[i]).filename().string(),
               what, row(joined), row(apart));
  }
  return 0;
}

int scenes(std::uint64_t count) {
  struct Tally {
    std::size_t scenes = 0, wrong = 0;
    std::uint64_t first = 0;
  };
  std::map<std::string, Tally> tallies;
  std::size_t wrong = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const inputs::CurveScene scene = inputs::curve_scene(i);
    const bool is_svg = scene.file == "scene.svg";
    const SegmentSet drawn =
        evaluate(is_svg ? read_svg(scene.text, scene.file) : read_dxf(scene.text, scene.file));
    const ExactComplex complex = arrange(drawn, ExactEngine::Bucket, {1, {}});
    Tally& tally = tallies[scene.name];
    ++tally.scenes;
    if (complex.face_count() == scene.faces && antennas(complex) == 0) continue;
    ++wrong;
    if (tally.wrong++ == 0) tally.first = i;
  }
  fmt::print("| scene | drawn | otherwise | the first |\n| --- | ---: | ---: | ---: |\n");
  for (const auto& [name, tally] : tallies) {
    fmt::print("| {} | {} | {} | {} |\n", name, tally.scenes, tally.wrong,
               tally.wrong == 0 ? "" : std::to_string(tally.first));
  }
  fmt::print("| all | {} | {} | |\n", count, wrong);
  return wrong == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::string mode = argc > 1 ? argv[1] : "";
    if (mode == "scenes" && argc == 3) return scenes(std::stoull(argv[2]));
    if (mode == "drawings" && argc > 2) return drawings(argc - 2, argv + 2);
    if (mode == "scene" && argc == 3) {
      std::cout << inputs::curve_scene(std::stoull(argv[2])).text;
      return 0;
    }
    std::cerr << "plumbline_curves scenes COUNT | scene NUMBER | drawings FILE...\n";
    return 2;
  } catch (const std::exception& problem) {
    std::cerr << problem.what() << "\n";
    return 2;
  }
}
