#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "read/json_events.hpp"

namespace plumbline {

enum class JsonType : std::uint8_t { Null, Bool, Number, String, Array, Object };

class JsonTree;

/// A value of a JsonTree.
class JsonValue {
 public:
  JsonType type() const;
  bool is(JsonType type) const { return this->type() == type; }
  /// Of a scalar: a string's content; else as it is written.
  std::string_view text() const;
  /// The name of an object's member.
  std::string_view key() const;
  Place place() const;
  /// How many members or items it has.
  std::size_t size() const;

  /// Goes over the members or items: `for (auto v = value.first(); v; v = v.next())`.
  JsonValue first() const;
  JsonValue next() const;
  explicit operator bool() const { return node_ != kNone; }
  /// The member of this name; none if there is none.
  JsonValue find(std::string_view key) const;

  /// Throws: Error BadInput at the value's place, with its text.
  [[noreturn]] void fail(const std::string& message) const;

 private:
  friend class JsonTree;
  static constexpr std::uint32_t kNone = 0xffffffffU;
  JsonValue(const JsonTree& tree, std::uint32_t node) : tree_(&tree), node_(node) {}

  const JsonTree* tree_;
  std::uint32_t node_;
};

/// A JSON text as a tree, its numbers as texts and every value with its place: 40 bytes a value and
/// the texts. Nothing recurses.
class JsonTree {
 public:
  /// Throws: as parse_json; Error BadInput for a member that is there twice; Limit for 2^32 values.
  explicit JsonTree(ByteStream& bytes);

  JsonValue root() const { return {*this, 0}; }

  // Called by parse_json.
  static bool done() { return false; }
  void key(std::string_view name);
  void scalar(JsonScalar kind, std::string_view text);
  void open_object() { open(JsonType::Object); }
  void close_object() { close(); }
  void open_array() { open(JsonType::Array); }
  void close_array() { close(); }

 private:
  friend class JsonValue;
  struct Node {
    JsonType type;
    std::uint32_t line, column;
    std::uint32_t next = JsonValue::kNone;
    std::uint32_t first = JsonValue::kNone;  ///< child
    std::uint32_t size = 0;                  ///< children
    std::uint32_t key_size = 0, text_size = 0;
    std::uint64_t text = 0;  ///< of the key, which the value's follows, in texts_
  };

  std::uint32_t add(JsonType type);
  void open(JsonType type);
  void close();

  ByteStream* bytes_;
  std::string file_;
  std::vector<Node> nodes_;
  std::string texts_;
  // While parsing:
  struct Open {
    std::uint32_t node;
    std::uint32_t last;  ///< child so far
  };
  std::vector<Open> open_;
  std::string key_;
};

}  // namespace plumbline
