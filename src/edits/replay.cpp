#include "edits/replay.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

#include "diagnose/edge_tree.hpp"

namespace plumbline::edits {
namespace {

constexpr std::size_t kForever = static_cast<std::size_t>(-1);

struct ByContent {
  bool operator()(const Line& l, const Line& m) const {
    if (l.segments != m.segments) return l.segments < m.segments;
    return l.a == m.a ? l.b < m.b : l.a < m.a;
  }
};

std::vector<bool> touched(const SegmentSet& input, const std::vector<Edit>& edits) {
  std::vector<bool> result(input.segments.size(), false);
  for (const Edit& edit : edits) {
    for (const std::vector<Line>* lines : {&edit.before, &edit.after}) {
      for (const Line& line : *lines) {
        for (const SegmentId s : line.segments) result[s] = true;
      }
    }
  }
  return result;
}

Line line_of(Segment segment, std::vector<SegmentId> segments) {
  Segment s = ordered(std::move(segment));
  return {std::move(s.a), std::move(s.b), std::move(segments)};
}

/// Lines that are there and what happens to them.
class Lines {
 public:
  Lines(const SegmentSet& input, Replay& replay) : replay_(replay) {
    for (std::size_t s = 0; s < input.segments.size(); ++s) {
      if (replay.is_touched[s]) put(line_of(input.segments[s], {SegmentId(s)}), 0);
    }
  }

  void put(const Line& line, std::size_t state) {
    there_.emplace(line, replay_.lives.size());
    replay_.lives.push_back({line, state, kForever});
  }

  bool take(const Line& line, std::size_t state) {
    const auto place = there_.find(line);
    if (place == there_.end()) return false;
    replay_.lives[place->second].last = state;
    there_.erase(place);
    return true;
  }

  /// Those that are there in the end and nobody took.
  void expect_none(std::vector<Breach>& breaches) const {
    for (const auto& [line, life] : there_) {
      breaches.push_back(
          {"after all edits there is a line that the output has not: " + to_text(extent_of(line)),
           line.a,
           {}});
    }
  }

 private:
  Replay& replay_;
  std::multimap<Line, std::size_t, ByContent> there_;
};

bool is_same(std::span<const Number, 4> s, std::span<const Number, 4> t) {
  return std::ranges::equal(s, t) || (s[0] == t[2] && s[1] == t[3] && s[2] == t[0] && s[3] == t[1]);
}

/// The output's segments are the lines that are there, and the segments that no edit names.
void compare_output(const SegmentSet& input, const Repair& repair, Lines lines, Replay& replay) {
  std::vector<bool> is_there = replay.is_touched;
  const SegmentList& segments = repair.output.segments;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto origins = repair.origins[i];
    const bool is_untouched = origins.size() == 1 && !is_there[origins[0]] &&
                              is_same(input.segments.numbers(origins[0]), segments.numbers(i));
    if (is_untouched) {
      is_there[origins[0]] = true;
      continue;
    }
    const Line line = line_of(segments[i], {origins.begin(), origins.end()});
    if (lines.take(line, kForever)) continue;
    replay.breaches.push_back({"the output has a segment of " + std::to_string(origins.size()) +
                                   " origins that no edit put there: " + to_text(segments[i]),
                               line.a,
                               {}});
  }
  lines.expect_none(replay.breaches);
  for (std::size_t s = 0; s < is_there.size(); ++s) {
    if (is_there[s]) continue;
    const Segment segment = input.segments[s];
    replay.breaches.push_back(
        {"segment " + std::to_string(s) +
             " of the input is not in the output, and no edit names it: " + to_text(segment),
         segment.a,
         {}});
  }
}

}  // namespace

Replay replay(const SegmentSet& input, const Repair& repair) {
  Replay result;
  result.is_touched = touched(input, repair.edits);
  Lines lines(input, result);
  for (std::size_t t = 0; t < repair.edits.size(); ++t) {
    const Edit& edit = repair.edits[t];
    for (const Line& line : edit.before) {
      if (lines.take(line, t)) continue;
      result.breaches.push_back(
          {to_text(edit.kind) + " takes a line away that is not there: " + to_text(extent_of(line)),
           edit.where, t});
    }
    for (const Line& line : edit.after) lines.put(line, t + 1);
  }
  compare_output(input, repair, std::move(lines), result);
  return result;
}

struct Drawing::Tree {
  Tree(const SegmentSet& set, const Replay& all)
      : input(set),
        replay(all),
        edges(all_edges()),
        slack(largest_coordinate(ends) * 0x1p-45),
        tree(edges, ends) {}

  std::vector<Edge> all_edges() {
    std::vector<Edge> result;
    const auto add = [&](const PointD& a, const PointD& b) {
      result.push_back({VertexId(ends.size()), VertexId(ends.size() + 1)});
      ends.insert(ends.end(), {a, b});
    };
    for (std::size_t s = 0; s < input.segments.size(); ++s) {
      if (replay.is_touched[s]) continue;
      const auto n = input.segments.numbers(s);
      add(nearest(NumberPoint{n[0], n[1]}), nearest(NumberPoint{n[2], n[3]}));
      untouched.push_back(SegmentId(s));
    }
    for (const Life& life : replay.lives) add(nearest(life.line.a), nearest(life.line.b));
    return result;
  }

  /// Lines no further from p, and some that are.
  std::vector<Line> near(const PointD& p, double distance, std::size_t first,
                         std::size_t last) const {
    std::vector<std::size_t> found;
    tree.visit(p, distance + 4 * slack,
               [&](EdgeId e, const auto& /*foot*/) { found.push_back(e); });
    std::ranges::sort(found);
    std::vector<Line> result;
    for (const std::size_t i : found) {
      if (i < untouched.size()) {
        result.push_back(line_of(input.segments[untouched[i]], {untouched[i]}));
        continue;
      }
      const Life& life = replay.lives[i - untouched.size()];
      if (life.first <= last && first <= life.last) result.push_back(life.line);
    }
    return result;
  }

  const SegmentSet& input;
  const Replay& replay;
  std::vector<SegmentId> untouched;
  std::vector<PointD> ends;
  std::vector<Edge> edges;
  double slack = 0;  ///< of coordinates, and of computing with them
  diagnose_steps::EdgeTree tree;
};

Drawing::Drawing(const SegmentSet& input, const Replay& replay)
    : tree_(std::make_unique<Tree>(input, replay)) {}
Drawing::~Drawing() = default;

std::vector<Line> Drawing::at(const Point& p, std::size_t first, std::size_t last) const {
  std::vector<Line> result = tree_->near(nearest(p), 0, first, last);
  std::erase_if(result, [&](const Line& line) { return !on_segment(line.a, line.b, p); });
  return result;
}

std::vector<Line> Drawing::around(const Segment& s, std::size_t first, std::size_t last) const {
  const PointD a = nearest(s.a), b = nearest(s.b);
  return tree_->near(point_at({a, b}, 0.5), distance(a, b) / 2, first, last);
}

std::vector<Line> Drawing::near(const Point& p, const Rational& distance, std::size_t state) const {
  return tree_->near(nearest(p), nearest_double(distance), state, state);
}

}  // namespace plumbline::edits
