#pragma once

#include <cstddef>
#include <vector>

#include "plumbline/edits.hpp"

namespace plumbline::repair_steps {

/// A line that is, or was, part of the drawing under repair; those of the input come first.
using LineId = Index<struct LineTag>;
inline constexpr LineId kFirstLine{std::size_t{0}};

/// The drawing under repair, with the edits so far.
class Work {
 public:
  /// Keeps a reference to the input. `anchored` are segments that no edit may touch, ascending.
  Work(const SegmentSet& input, const std::vector<SegmentId>& anchored);

  const SegmentSet& input() const { return input_; }
  const std::vector<Edit>& edits() const { return edits_; }
  /// All lines that there are, by the first of their segments.
  std::vector<LineId> lines() const;
  /// Of all lines that there are and were.
  std::size_t count() const { return is_there_.size(); }
  bool is_there(LineId id) const { return is_there_[id] != 0; }
  Line line(LineId id) const;
  SegmentD rounded(LineId id) const;
  bool is_anchored(LineId id) const;
  /// Whether they belong together on one layer.
  bool is_same_layer(LineId id, LineId other) const { return layer(id) == layer(other); }
  std::string layer(LineId id) const;
  /// Whether it closes an opening; made now, or in a repair before.
  bool is_virtual(LineId id) const { return is_added(id) || layer(id) == kVirtualLayer; }
  /// Of its first segment. Requires: it is not virtual.
  SourceId source(LineId id) const { return input_.segment_source[first_segment(id)]; }
  /// What became of a line that an edit took away: the pieces that there are now.
  std::vector<LineId> pieces(LineId id) const;
  /// The piece that has p and q, which the line had. Requires: there is one.
  LineId piece(LineId id, const Point& p, const Point& q) const;

  /// Whether one of the pieces ends at p.
  bool is_end(LineId id, const Point& p) const;
  /// The piece that ends at p. Requires: there is one.
  LineId ending_at(LineId id, const Point& p) const;

  /// Requires: the lines are there and not anchored.
  void apply(EditKind kind, Point where, Rational squared_size, const std::vector<LineId>& before,
             std::vector<Line> after);

  /// Notes what is not done.
  void refuse(EditKind kind, Point where, Rational squared_size, std::string reason,
              const std::vector<LineId>& lines);
  /// But for what is not welded, which is not looked at again.
  void forget_refusals() {
    std::erase_if(refused_, [](const Refusal& r) { return r.kind != EditKind::Weld; });
  }

  /// The lines as a drawing of segments, in the order of `lines`, with the rings that are still
  /// closed lines of a segment for each one that they had.
  SegmentSet drawing() const { return drawing(lines()); }
  /// The same of some lines.
  SegmentSet drawing(const std::vector<LineId>& order) const;
  /// All of them as a result, with sources, and the direction that segments had.
  void write(Repair& result) const;

 private:
  std::size_t first_made() const { return input_.segments.size(); }
  /// A made line in the direction of its first segment.
  Segment directed(const Line& line) const;
  void add_rings(SegmentSet& drawing, const std::vector<LineId>& order) const;
  SegmentId first_segment(LineId id) const;
  /// Whether it stands for no segment.
  bool is_added(LineId id) const {
    return id >= first_made() && made_[id - first_made()].segments.empty();
  }

  const SegmentSet& input_;
  std::vector<char> is_anchored_;  ///< per segment of the input
  std::vector<char> is_there_;     ///< per line
  std::vector<Line> made_;
  std::vector<std::vector<LineId>> became_;  ///< per edit
  std::vector<std::uint32_t> taken_by_;      ///< per line, the edit that took it away
  std::vector<Edit> edits_;
  std::vector<Refusal> refused_;
};

/// The shortest line that covers both, for all their segments. Requires: they are on one line.
Line united(const Line& line, const Line& other);

/// The arrangement of the lines that there are.
struct Arranged {
  ExactComplex complex;
  std::vector<LineId> line_of;  ///< per source of its edges

  /// The lines that cover an edge, ascending.
  std::vector<LineId> lines(EdgeId e) const;
};
Arranged arranged(const Work& work);
/// After edits that move, add and remove nothing: the same arrangement, of the lines that there are
/// now.
void rename_lines(Arranged& arranged, const Work& work);

}  // namespace plumbline::repair_steps
