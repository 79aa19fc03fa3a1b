#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumbline/complex.hpp"
#include "plumbline/published.hpp"
#include "plumbline/round.hpp"

namespace plumbline {

struct LarModel;
struct Structure;

/// The complex as JSON: vertices (exact text and nearest double), edges with their sources, faces
/// with cycles of signed edges, area, depth, interior point; components; rejected items; ledger;
/// signature. Documented in docs/json.md.
std::string to_json(const ExactComplex& complex, const SegmentSet& input);

/// The same with numbers that are proven to be those of the same complex: of `complex` itself where
/// the rounding keeps its incidences, else of the snap rounded complex, and what has changed.
std::string to_json(const ExactComplex& complex, const SegmentSet& input, const Grid& grid,
                    const Rounding& rounding);

/// The structure as JSON that `read_struct_json` reads back: definitions in order, references by
/// name, rotations as the exact matrices that they became. Throws: Error BadInput for a reference
/// to no Struct. Documented in docs/json.md.
std::string to_json(const Structure& structure);

/// The model as JSON: V and CV, V, FV and EV, or V and cells. Decimals are numbers, other
/// coordinates strings "p/q". Documented in docs/json.md.
std::string to_json(const LarModel& model);

/// The complex as an SVG picture, in the drawing's own coordinates: faces filled by nesting depth,
/// edges, antennas dashed; y negated where it runs upwards. **Rounded** to nearest doubles.
std::string to_svg(const ExactComplex& complex, bool y_up = false);

/// The segments as an SVG picture of lines, in the same way.
std::string to_svg(const SegmentSet& input);

/// The trace of the published LAR pipeline as JSON, with the keys that the original's recorded
/// outputs have. Documented in docs/json.md.
std::string to_json(const lar::published::Trace& trace);

/// The same of the repaired pipeline, with these keys where the stages are the same.
std::string to_json(const lar::Result& result);

/// What a picture of the float pipeline shows.
enum class LarShow {
  Buckets,     ///< the segments, in the colour of the first bucket that holds them
  Components,  ///< biconnected components in colours, bridges and dangling edges dashed
  Faces,       ///< the faces of the result in colours
  Explode,     ///< the same, pulled apart
  Numbers,     ///< the numbers of vertices, edges and faces
  Pruning,     ///< vertices before merging, clusters with their radii and centroids
  // Of the faces; published: of the cells of `two_complex` where it has a value.
  Filled,     ///< triangulated; those whose edges cross are empty and in the second colour
  Polylines,  ///< boundaries, joined by their bridge edges
  Boundary,   ///< numbered; chosen ones filled, with the boundary of their chain
};
struct LarPicture {
  LarShow show = LarShow::Faces;
  double explode = 1.2;                 ///< factor of the exploded view
  bool y_up = false;                    ///< whether y runs upwards
  std::vector<std::size_t> faces = {};  ///< chosen bounded faces, counted from 0; none: all
};
/// A picture of either variant as SVG. Colours depend on the numbers of the cells alone. Throws:
/// Error BadInput for a factor below 1, a chosen face that is not there, and bridge edges of a
/// complex that is not valid.
std::string to_svg(const lar::Result& result, const LarPicture& options = {});
std::string to_svg(const lar::published::Trace& trace, const LarPicture& options = {});

/// The segments as rows "x1,y1,x2,y2", which `read` takes as a .lines file; the shortest decimals
/// that round to the coordinates.
std::string to_lines(std::span<const lar::SegmentD> segments);

/// The segments in their order as rows "x1,y1,x2,y2" and the isolated points as rows "x,y", with
/// `exact_text`s. **Exact**. `read` takes it as a .lines file (it lists the points as rejected),
/// plumbline-verify as the input of a certificate.
std::string to_lines(const SegmentSet& input);

/// The edges in their order as such rows, with whole decimal expansions: what they say is the
/// complex itself, but for its isolated vertices and sources. **Exact**. Requires: coordinates are
/// decimals, as those of a Rounding are; throws Error BadInput.
std::string to_lines(const ExactComplex& complex);

/// A file that is whole or not there: its content goes to a temporary beside it, which `commit`
/// renames to it. A new file has the permissions that the umask leaves, one that is replaced keeps
/// its own (hard links to it keep the old content). A link stays a link: what it names is replaced.
/// Pipes and devices, which can't be replaced, are written to as they are.
class NewFile {
 public:
  /// Waits for nothing. Throws: Error BadFile, as the others.
  explicit NewFile(const std::filesystem::path& target);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  /// Removes the temporary, unless it was renamed.
  ~NewFile();

  /// The name of the temporary, which no other file had; empty for pipes and devices.
  const std::string& temporary() const { return temporary_; }
  void write(std::string_view content);
  /// Waits until the content is on the disk, then puts it in place of the target.
  void commit();

 private:
  void create_beside(unsigned permissions);
  void open_stream();
  [[noreturn]] void fail(const std::string& what) const;

  std::filesystem::path target_;
  std::string temporary_;
  int file_ = -1;
};

/// Writes a file whole or not at all, as a NewFile. Throws: Error BadFile.
void write_file(const std::filesystem::path& file, std::string_view content);

}  // namespace plumbline
