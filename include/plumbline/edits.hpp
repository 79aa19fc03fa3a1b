#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline {

/// What one edit of line work does.
enum class EditKind {
  Merge,     ///< lines that overlap, or are the same, became one; nothing moves
  Dissolve,  ///< lines end to end on one line, where nothing else is any more, became one
  Grow,      ///< a loose end ran straight on to what it met first
  Bridge,    ///< two loose ends that face each other on one line ran on and met
  Joint,     ///< two loose ends that face each other on parallel lines were joined by a short line
  Door,      ///< a virtual line, or two, closed an opening
  Trim,      ///< a loose chain went
  Sliver,    ///< a part of a thin face's border went, and with it the face to its neighbour
  Weld,      ///< a line went onto a stronger one beside it, or its end along with such a line
  Snap,      ///< ends went to a vertex near them
  Simplify,  ///< a vertex between two lines went
};
inline constexpr std::size_t kEditKinds = 11;
/// "merge", "dissolve", ...
std::string to_text(EditKind kind);

/// A line of a drawing under repair. Lines of one drawing that are equal stand for different
/// segments.
struct Line {
  Point a, b;                       ///< in lexicographic order; a != b
  std::vector<SegmentId> segments;  ///< of the input, for which it stands, ascending; none: virtual

  friend bool operator==(const Line&, const Line&) = default;
};

/// One edit: lines of the drawing at that time gave way to others.
struct Edit {
  EditKind kind = EditKind::Merge;
  Point where;  ///< where to look: the loose end, the junction of a trimmed chain, ...
  /// How far the edit goes, squared, **exact**: of Merge and Dissolve 0, of Grow, Bridge, Joint and
  /// Door the length that was added (of Bridge that of the gap, of Door the width), of Trim the
  /// chain's reach from its junction, of Sliver the largest distance of the border that went from
  /// the one that stays, of Weld, Snap and Simplify how far a point moved from where it was
  /// authored.
  Rational squared_size;
  std::vector<Line> before;  ///< that are no longer there
  std::vector<Line> after;   ///< that are there instead

  friend bool operator==(const Edit&, const Edit&) = default;
};

/// What would have been an edit, and why it is none.
struct Refusal {
  EditKind kind = EditKind::Grow;
  Point where;
  Rational squared_size;
  std::string reason;
  std::vector<SegmentId> segments;  ///< of the input, ascending

  friend bool operator==(const Refusal&, const Refusal&) = default;
};

/// Up to which size each operation repairs, in drawing units; 0, or no range: it does not.
struct Tolerances {
  Rational weld, grow, trim, sliver, snap, simplify;
  std::optional<Range> doors = std::nullopt;  ///< widths

  friend bool operator==(const Tolerances&, const Tolerances&) = default;
};

/// A tolerance as it is said, and read again as the same: "0.018", "2.71e-12", "1/30".
std::string tolerance_text(const Rational& tolerance);

/// What became of a face.
enum class FaceFate {
  Closed,   ///< it is new: what it covers was open, part of the unbounded face
  Split,    ///< a part of a face that now is several
  Joined,   ///< it went into another one, the area of which is mostly that of a third face
  Opened,   ///< it went into the unbounded face
  Changed,  ///< it is there, with another area
};
/// "closed", "split", "joined", "opened", "changed".
std::string to_text(FaceFate fate);

/// A face of the drawing before or after, and what the edits did to it.
struct FaceOutcome {
  FaceFate fate = FaceFate::Changed;
  FaceId before;  ///< that it was part of, in the arrangement of the input; kUnbounded of Closed
  FaceId after;   ///< that it is part of, in that of the output; kUnbounded of Opened
  Rational area_before;  ///< of the face before, **exact**; 0 of the unbounded one
  Rational area_after;
  Point where;                     ///< inside the part that is spoken of
  std::vector<std::size_t> edits;  ///< that did it, ascending

  friend bool operator==(const FaceOutcome&, const FaceOutcome&) = default;
};

/// A repaired drawing, and what was done to it.
struct Repair {
  SegmentSet output;         ///< files, sources, labels, layers and units are those of the input
  Lists<SegmentId> origins;  ///< per output segment those of the input, ascending
  std::vector<Edit> edits;   ///< in the order in which they were made
  std::vector<Refusal> refused;     ///< by kind and place
  std::vector<FaceOutcome> faces;   ///< by fate and place
  std::vector<SegmentId> anchored;  ///< that no edit may touch, ascending
  Tolerances tolerances;            ///< as used
  std::vector<std::string>
      reasons;  ///< of tolerances that were chosen automatically, a sentence each
};

/// The layer of virtual lines, in `output`.
inline constexpr const char* kVirtualLayer = "plumbline-virtual";

/// A promise of `repair` that is not kept.
struct Breach {
  std::string message;  ///< one sentence, with numbers
  Point where;
  std::optional<std::size_t> edit;  ///< index, if it is that of one edit

  friend bool operator==(const Breach&, const Breach&) = default;
};

inline constexpr std::size_t kMaxBreaches = 100;

/// What is not true of a repair, the first kMaxBreaches; none for one that keeps its promises: the
/// edits, one after the other, make the output of the input; each does what its kind says, within
/// the tolerances, to what is there at its time; anchored segments stay; what moves stays within
/// bounds on the whole and meets nothing new; what became of the faces is as it says, and some edit
/// did it that can. Shares nothing with what makes repairs. `before` and `after` are the
/// arrangements of the input and of the output. **Exact**. Order: by promise; once an edit is wrong
/// by itself, nothing is said of what comes of it. Cost: of what no edit touches, less than that of
/// `arrange`.
std::vector<Breach> verify(const SegmentSet& input, const ExactComplex& before,
                           const Repair& repair, const ExactComplex& after);
std::vector<Breach> verify(const SegmentSet& input, const Repair& repair);

/// What became of each face that is not there as it was. The parent of a face is the one before
/// that it has most of its area in common with (of several the first), the heir of a face the one
/// after; both may be the unbounded face. `before` and `after` are the arrangements of the input
/// and of the output. **Exact**. Order: by fate and place. Cost: linear, and the arrangement of the
/// borders of faces whose border changed.
std::vector<FaceOutcome> face_outcomes(const ExactComplex& before, const Repair& repair,
                                       const ExactComplex& after);

/// A segment of the input, with all that the drawing says of it.
struct SourcedSegment {
  Segment segment;
  Source source;     ///< its `file` is an index that says nothing here: see below
  std::string file;  ///< its file's name

  friend bool operator==(const SourcedSegment&, const SourcedSegment&) = default;
};

/// Segments of the input, and those of the output that they became together.
struct NetChange {
  std::vector<SourcedSegment> before;  ///< in the input's order; none: virtual lines were added
  std::vector<Segment> after;          ///< in the output's order; none: they went

  friend bool operator==(const NetChange&, const NetChange&) = default;
};

/// What a repair changed on the whole. Segments hang together by `origins`, those of the output
/// also where their ends have the same nearest doubles. What was turned at most is in no change.
/// Order: by the first segment of the input; virtual lines last.
std::vector<NetChange> net_changes(const SegmentSet& input, const Repair& repair);

/// The signature of the arrangement of the segments with their ends rounded to doubles: by it a
/// drawing is known in every format. Cost: that of `arrange`.
std::string rounded_signature(const SegmentSet& drawing);

/// The input again: what the changes say became of its segments is taken away from the output, and
/// these are put back, behind all that stays. Segments of the output are known by the nearest
/// doubles of their ends, in either direction, so the output may have been written with rounded
/// coordinates. Rings are not restored. Throws: Error BadInput where the output has a segment of a
/// change less or more often than the change says.
SegmentSet undo(const SegmentSet& output, const std::vector<NetChange>& changes);

}  // namespace plumbline
