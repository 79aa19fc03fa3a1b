#include "repair/work.hpp"

#include <algorithm>
#include <utility>

#include "plumbline/arrange.hpp"

namespace plumbline::repair_steps {

Work::Work(const SegmentSet& input, const std::vector<SegmentId>& anchored)
    : input_(input),
      is_anchored_(input.segments.size()),
      is_there_(input.segments.size(), 1),
      taken_by_(input.segments.size()) {
  for (const SegmentId s : anchored) is_anchored_[s] = 1;
}

std::vector<LineId> Work::lines() const {
  std::vector<LineId> result;
  for (std::size_t i = 0; i < is_there_.size(); ++i) {
    if (is_there_[i] != 0) result.emplace_back(i);
  }
  return result;
}

Line Work::line(LineId id) const {
  if (id >= first_made()) return made_[id - first_made()];
  Segment segment = input_.segments[id];
  if (segment.b < segment.a) std::swap(segment.a, segment.b);
  return {std::move(segment.a), std::move(segment.b), {SegmentId(static_cast<std::size_t>(id))}};
}

SegmentD Work::rounded(LineId id) const {
  if (id < first_made()) {
    const auto n = input_.segments.numbers(id);
    return {{nearest_double(n[0]), nearest_double(n[1])},
            {nearest_double(n[2]), nearest_double(n[3])}};
  }
  const Line& line = made_[id - first_made()];
  return {nearest(line.a), nearest(line.b)};
}

bool Work::is_anchored(LineId id) const {
  if (id < first_made()) return is_anchored_[id] != 0;
  return std::ranges::any_of(made_[id - first_made()].segments,
                             [&](SegmentId s) { return is_anchored_[s] != 0; });
}

SegmentId Work::first_segment(LineId id) const {
  return id < first_made() ? SegmentId(static_cast<std::size_t>(id))
                           : made_[id - first_made()].segments.front();
}

std::string Work::layer(LineId id) const {
  if (is_virtual(id)) return kVirtualLayer;
  return input_.sources[input_.segment_source[first_segment(id)]].layer;
}

std::vector<LineId> Work::pieces(LineId id) const {
  if (is_there(id)) return {id};
  std::vector<LineId> result;
  for (const LineId next : became_[taken_by_[id]]) {
    const std::vector<LineId> further = pieces(next);
    result.insert(result.end(), further.begin(), further.end());
  }
  return result;
}

LineId Work::piece(LineId id, const Point& p, const Point& q) const {
  for (const LineId piece : pieces(id)) {
    const Line found = line(piece);
    if (on_segment(found.a, found.b, p) && on_segment(found.a, found.b, q)) return piece;
  }
  throw Error(ErrorCode::Internal, "a line under repair has lost a part");
}

LineId Work::ending_at(LineId id, const Point& p) const {
  for (const LineId piece : pieces(id)) {
    const Line found = line(piece);
    if (found.a == p || found.b == p) return piece;
  }
  throw Error(ErrorCode::Internal, "a line under repair has lost an end");
}

void Work::apply(EditKind kind, Point where, Rational squared_size,
                 const std::vector<LineId>& before, std::vector<Line> after) {
  Edit edit{kind, std::move(where), std::move(squared_size), {}, {}};
  for (const LineId id : before) {
    ensure(is_there(id) && !is_anchored(id), "an edit may touch its lines");
    edit.before.push_back(line(id));
    is_there_[id] = 0;
    taken_by_[id] = static_cast<std::uint32_t>(edits_.size());
  }
  std::vector<LineId> made;
  for (Line& line : after) {
    if (line.b < line.a) std::swap(line.a, line.b);
    edit.after.push_back(line);
    made.emplace_back(is_there_.size());
    is_there_.push_back(1);
    taken_by_.push_back(0);
    made_.push_back(std::move(line));
  }
  became_.push_back(std::move(made));
  edits_.push_back(std::move(edit));
}

SegmentSet Work::drawing() const {
  SegmentSet result;
  const SourceId source = result.add_source({});
  for (const LineId id : lines()) {
    if (id < first_made()) {
      const auto n = input_.segments.numbers(id);
      result.add({n[0], n[1]}, {n[2], n[3]}, source);
    } else {
      result.add(Segment{made_[id - first_made()].a, made_[id - first_made()].b}, source);
    }
  }
  ensure(result.rejected.empty(), "lines under repair have a length");
  return result;
}

void Work::write(Repair& result) const {
  result.edits = edits_;
  SegmentSet& output = result.output = input_;
  output.segments = {};
  output.segment_source.clear();
  output.rounding.clear();
  output.rings.clear();
  std::vector<LineId> order = lines();
  std::ranges::stable_sort(
      order, {}, [&](LineId id) { return is_virtual(id) ? SegmentId() : first_segment(id); });
  SourceId virtual_source;
  for (const LineId id : order) {
    if (id < first_made()) {
      const auto n = input_.segments.numbers(id);
      output.segments.push_back({n[0], n[1]}, {n[2], n[3]});
      output.segment_source.push_back(input_.segment_source[id]);
      result.origins.push_back(std::vector<SegmentId>{SegmentId(static_cast<std::size_t>(id))});
      continue;
    }
    const Line& line = made_[id - first_made()];
    Segment segment{line.a, line.b};
    if (line.segments.empty()) {
      if (!virtual_source.valid()) {
        Source source;
        source.element = "line";
        source.layer = kVirtualLayer;
        virtual_source = output.add_source(source);
      }
      output.segment_source.push_back(virtual_source);
    } else {
      const Segment first = input_.segments[line.segments.front()];
      if (first.b < first.a) std::swap(segment.a, segment.b);
      output.segment_source.push_back(input_.segment_source[line.segments.front()]);
    }
    output.segments.push_back(std::move(segment));
    result.origins.push_back(line.segments);
  }
}

Line united(const Line& line, const Line& other) {
  Line result{std::min(line.a, other.a), std::max(line.b, other.b), line.segments};
  result.segments.insert(result.segments.end(), other.segments.begin(), other.segments.end());
  std::ranges::sort(result.segments);
  const auto repeated = std::ranges::unique(result.segments);
  result.segments.erase(repeated.begin(), repeated.end());
  return result;
}

std::vector<LineId> Arranged::lines(EdgeId e) const {
  std::vector<LineId> result;
  for (const SegmentId s : complex.edge_sources[e]) result.push_back(line_of[s]);
  return result;
}

Arranged arranged(const Work& work) { return {arrange(work.drawing()), work.lines()}; }

}  // namespace plumbline::repair_steps
