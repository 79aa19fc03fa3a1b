#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline::bench {

struct Cells {
  std::size_t vertices = 0, edges = 0, faces = 0;  ///< faces with the unbounded one

  friend bool operator==(const Cells&, const Cells&) = default;
};

/// A result that stays in memory, and a count of its cells (not timed).
struct Outcome {
  std::shared_ptr<const void> result;
  std::function<Cells()> cells;
};

/// One computation, its input being ready: what is timed.
using Job = std::function<Outcome()>;

struct Contender {
  std::string id;     ///< for command lines
  std::string title;  ///< for tables
  /// Makes the engine's own form of the input (not timed), which must outlive the job.
  Job (*prepare)(const SegmentSet& input);
};

/// Our engine: arrangement with faces, holes, nesting and provenance in memory.
Job prepare_bucket_1(const SegmentSet& input);
Job prepare_bucket_2(const SegmentSet& input);
/// Aggregated `CGAL::insert` of all curves, equal ones too, into an empty Arrangement_2 over the
/// exact-constructions kernel, with the traits of the reference engine.
Job prepare_cgal(const SegmentSet& input);
/// GEOS through its C API, coordinates rounded to doubles: unary union, then polygonize. Its cells:
/// distinct points and edges of the union; polygons and 1.
Job prepare_geos(const SegmentSet& input);
/// The input as `.lines` text in memory: to segments (no cells); to our engine's arrangement, 2
/// threads.
Job prepare_read_text(const SegmentSet& input);
Job prepare_arrange_text(const SegmentSet& input);
/// Whole commands with one thread, from `.lines` text in memory to the text that they write:
/// `arrange` to its summary (validated, signature), with -o x.json, with --compact, with --safe
/// --decimals 6; `check --no-advice` with --radius 1e-9 and with the default radius.
Job prepare_arrange(const SegmentSet& input);
Job prepare_json(const SegmentSet& input);
Job prepare_compact(const SegmentSet& input);
Job prepare_safe(const SegmentSet& input);
Job prepare_check_fine(const SegmentSet& input);
Job prepare_check(const SegmentSet& input);

std::string cgal_version();
std::string geos_version();

inline const std::vector<Contender>& contenders() {
  static const std::vector<Contender> all{
      {"bucket1", "bucket, 1 thread", prepare_bucket_1},
      {"bucket2", "bucket, 2 threads", prepare_bucket_2},
      {"cgal", "CGAL insert", prepare_cgal},
      {"geos", "GEOS union + polygonize", prepare_geos},
      {"read", "text to segments", prepare_read_text},
      {"text", "text to arrangement, 2 threads", prepare_arrange_text},
      {"arrange", "arrange", prepare_arrange},
      {"json", "arrange -o x.json", prepare_json},
      {"compact", "arrange -o x.json --compact", prepare_compact},
      {"safe", "arrange -o x.json --safe --decimals 6", prepare_safe},
      {"check_fine", "check --radius 1e-9", prepare_check_fine},
      {"check", "check", prepare_check},
  };
  return all;
}

}  // namespace plumbline::bench
