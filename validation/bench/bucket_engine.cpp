// Our engine: on segments in memory, and from text.

#include "contenders.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/output.hpp"
#include "plumbline/read.hpp"
#include "plumbline/structure.hpp"

namespace plumbline::bench {
namespace {

Outcome arranged(const SegmentSet& input, std::size_t threads) {
  const auto result = std::make_shared<const Arrangement>(input, ArrangeOptions{threads, {}});
  return {result, [result] {
            return Cells{result->vertex_count(), result->edge_count(), result->face_count()};
          }};
}

std::shared_ptr<const std::string> lines_text(const SegmentSet& input) {
  return std::make_shared<const std::string>(to_lines(input));
}

SegmentSet segments_of(const std::string& text) { return evaluate(read_lines(text, "text")); }

}  // namespace

Job prepare_bucket_1(const SegmentSet& input) {
  return [&input] { return arranged(input, 1); };
}

Job prepare_bucket_2(const SegmentSet& input) {
  return [&input] { return arranged(input, 2); };
}

Job prepare_read_text(const SegmentSet& input) {
  return [text = lines_text(input)] {
    const auto result = std::make_shared<const SegmentSet>(segments_of(*text));
    return Outcome{result, [] { return Cells{}; }};
  };
}

Job prepare_arrange_text(const SegmentSet& input) {
  return [text = lines_text(input)] {
    const auto segments = std::make_shared<const SegmentSet>(segments_of(*text));
    Outcome outcome = arranged(*segments, 2);
    outcome.result = std::make_shared<std::pair<std::shared_ptr<const void>, decltype(segments)>>(
        outcome.result, segments);
    return outcome;
  };
}

}  // namespace plumbline::bench
