#include "read/line_list.hpp"

#include <optional>
#include <string_view>

#include "plumbline/error.hpp"
#include "read/json_events.hpp"

namespace plumbline {
namespace {

/// A target of parse_json. Segments and models are lists of lists of lists of numbers alike; the
/// vertices V of a model stand where the first segment would be, its cells in the later ones.
class LineListTeller {
 public:
  bool done() const { return !is_lines_ || items_ > kMostLists; }
  bool is_lines() const { return is_lines_ && items_ > 0; }
  /// Three lists are no model: faces need more than the two vertices of V.
  bool is_model() const { return items_ == 2 && are_edges_; }

  static void key(std::string_view) {}
  void open_object() { is_lines_ = false; }
  static void close_object() {}

  void scalar(JsonScalar kind, std::string_view text) {
    if (kind != JsonScalar::Number || depth_ != kPoint) {
      is_lines_ = false;
      return;
    }
    ++numbers_;
    if (items_ == 1) return;
    const bool is_other_index = numbers_ == 1 || text != index_;
    are_edges_ = are_edges_ && (text == "0" || text == "1") && is_other_index && numbers_ <= 2;
    index_ = text == "0" ? "0" : "1";
  }

  void open_array() {
    ++depth_;
    if (depth_ == kSegment) {
      ++items_;
      points_ = 0;
    } else if (depth_ == kPoint) {
      ++points_;
      numbers_ = 0;
    }
    if (depth_ > kPoint || points_ > 2) is_lines_ = false;
  }

  void close_array() {
    constexpr std::size_t kMostNumbers = 3;
    const bool is_odd_point = depth_ == kPoint && (numbers_ < 2 || numbers_ > kMostNumbers);
    if (is_odd_point || (depth_ == kSegment && points_ != 2)) is_lines_ = false;
    --depth_;
  }

 private:
  static constexpr std::size_t kMostLists = 3;
  static constexpr std::size_t kSegment = 2;  ///< depth
  static constexpr std::size_t kPoint = 3;    ///< depth

  std::size_t depth_ = 0, items_ = 0;
  std::size_t points_ = 0, numbers_ = 0;  ///< of the item, of the point
  std::string_view index_;                ///< the number before, where it is one
  bool is_lines_ = true;
  bool are_edges_ = true;  ///< whether the second item has edges of two vertices
};

}  // namespace

bool is_line_list(ByteStream& bytes) {
  LineListTeller teller;
  parse_json(bytes, teller);
  if (!teller.is_lines() || !teller.is_model()) return teller.is_lines();
  throw Error(ErrorCode::BadInput,
              "a list that can be read in two ways: as two segments, or as (V, EV), two vertices "
              "with two edges; {\"lines\": [...]} or {\"V\": [...], \"EV\": [...]} says which",
              {bytes.file(), 1, 1});
}

}  // namespace plumbline
