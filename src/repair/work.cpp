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
  std::ranges::stable_sort(
      result, {}, [&](LineId id) { return is_added(id) ? SegmentId() : first_segment(id); });
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
  if (is_added(id)) return kVirtualLayer;
  return input_.sources[source(id)].layer;
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

bool Work::is_end(LineId id, const Point& p) const {
  return std::ranges::any_of(pieces(id), [&](LineId piece) {
    const Line found = line(piece);
    return found.a == p || found.b == p;
  });
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

void Work::refuse(EditKind kind, Point where, Rational squared_size, std::string reason,
                  const std::vector<LineId>& lines) {
  Refusal refusal{kind, std::move(where), std::move(squared_size), std::move(reason), {}};
  for (const LineId id : lines) {
    const std::vector<SegmentId> segments = line(id).segments;
    refusal.segments.insert(refusal.segments.end(), segments.begin(), segments.end());
  }
  std::ranges::sort(refusal.segments);
  refusal.segments.erase(std::unique(refusal.segments.begin(), refusal.segments.end()),
                         refusal.segments.end());
  refused_.push_back(std::move(refusal));
}

Segment Work::directed(const Line& line) const {
  if (line.segments.empty()) return {line.a, line.b};
  const Segment first = input_.segments[line.segments.front()];
  return first.b < first.a ? Segment{line.b, line.a} : Segment{line.a, line.b};
}

void Work::add_rings(SegmentSet& drawing, const std::vector<LineId>& order) const {
  if (input_.rings.empty()) return;
  // Per segment of the input, where it is in the drawing if a line stands for it alone.
  std::vector<std::size_t> place(input_.segments.size(), order.size());
  std::vector<std::size_t> lines_of(input_.segments.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Line line = this->line(order[i]);
    for (const SegmentId s : line.segments) {
      lines_of[s] += line.segments.size();
      place[s] = i;
    }
  }
  for (const Ring& ring : input_.rings) {
    bool is_whole = ring.count > 0 && lines_of[ring.first] == 1;
    for (std::size_t k = 0; is_whole && k + 1 < ring.count; ++k) {
      const std::size_t s = ring.first + k;
      is_whole = lines_of[s + 1] == 1 && place[s + 1] == place[s] + 1 &&
                 drawing.segments[place[s]].b == drawing.segments[place[s + 1]].a;
    }
    if (!is_whole) continue;
    const std::size_t first = place[ring.first], last = place[ring.first + ring.count - 1];
    const bool was_closed =
        input_.segments[ring.first].a == input_.segments[ring.first + ring.count - 1].b;
    if (was_closed && !(drawing.segments[first].a == drawing.segments[last].b)) continue;
    drawing.rings.push_back({static_cast<std::uint32_t>(first), ring.count, ring.role});
  }
}

SegmentSet Work::drawing(const std::vector<LineId>& order) const {
  SegmentSet result;
  const SourceId source = result.add_source({});
  for (const LineId id : order) {
    if (id < first_made()) {
      const auto n = input_.segments.numbers(id);
      result.add({n[0], n[1]}, {n[2], n[3]}, source);
    } else {
      result.add(directed(made_[id - first_made()]), source);
    }
  }
  ensure(result.rejected.empty(), "lines under repair have a length");
  add_rings(result, order);
  return result;
}

void Work::write(Repair& result) const {
  result.edits = edits_;
  result.refused = refused_;
  std::ranges::stable_sort(result.refused, [](const Refusal& p, const Refusal& q) {
    return p.kind != q.kind ? p.kind < q.kind : p.where < q.where;
  });
  result.refused.erase(std::unique(result.refused.begin(), result.refused.end()),
                       result.refused.end());
  const std::vector<LineId> order = lines();
  SegmentSet drawing = this->drawing(order);
  SegmentSet& output = result.output = input_;
  output.segments = std::move(drawing.segments);
  output.rings = std::move(drawing.rings);
  output.segment_source.clear();
  output.rounding.clear();
  SourceId virtual_source;
  for (const LineId id : order) {
    if (is_added(id)) {
      if (!virtual_source.valid()) {
        Source source;
        source.element = "line";
        source.layer = kVirtualLayer;
        virtual_source = output.add_source(source);
      }
      output.segment_source.push_back(virtual_source);
    } else {
      output.segment_source.push_back(source(id));
    }
    result.origins.push_back(line(id).segments);
  }
}

Line united(const Line& line, const Line& other) {
  Line result{std::min(line.a, other.a), std::max(line.b, other.b), line.segments};
  result.segments.insert(result.segments.end(), other.segments.begin(), other.segments.end());
  std::ranges::sort(result.segments);
  result.segments.erase(std::unique(result.segments.begin(), result.segments.end()),
                        result.segments.end());
  return result;
}

std::vector<LineId> Arranged::lines(EdgeId e) const {
  std::vector<LineId> result;
  for (const SegmentId s : complex.edge_sources[e]) result.push_back(line_of[s]);
  return result;
}

Arranged arranged(const Work& work) { return {arrange(work.drawing()), work.lines()}; }

void rename_lines(Arranged& arranged, const Work& work) {
  const std::vector<LineId> lines = work.lines();
  std::vector<SegmentId> place(work.count());
  for (std::size_t i = 0; i < lines.size(); ++i) place[lines[i]] = SegmentId(i);
  for (const LineId id : arranged.line_of) {
    if (!work.is_there(id)) place[id] = place[work.pieces(id).front()];
  }
  const Lists<SegmentId> before = std::move(arranged.complex.edge_sources);
  Lists<SegmentId>& sources = arranged.complex.edge_sources = {};
  sources.reserve(before.size(), before.flat().size());
  std::vector<SegmentId> renamed;
  for (std::size_t e = 0; e < before.size(); ++e) {
    renamed.clear();
    for (const SegmentId s : before[e]) renamed.push_back(place[arranged.line_of[s]]);
    std::ranges::sort(renamed);
    renamed.erase(std::unique(renamed.begin(), renamed.end()), renamed.end());
    sources.push_back(renamed);
  }
  arranged.line_of = lines;
}

}  // namespace plumbline::repair_steps
