#include "read/json_tree.hpp"

#include <algorithm>
#include <set>

#include "plumbline/error.hpp"

namespace plumbline {

JsonTree::JsonTree(ByteStream& bytes) : bytes_(&bytes), file_(bytes.file()) {
  parse_json(bytes, *this);
}

void JsonTree::key(std::string_view name) { key_ = name; }

std::uint32_t JsonTree::add(JsonType type) {
  if (nodes_.size() >= JsonValue::kNone) {
    throw Error(ErrorCode::Limit, "JSON of more than 2^32 values", bytes_->place());
  }
  const auto node = static_cast<std::uint32_t>(nodes_.size());
  const Place& place = bytes_->place();
  nodes_.push_back({type, place.line, place.column});
  if (!open_.empty()) {
    Open& parent = open_.back();
    (parent.last == JsonValue::kNone ? nodes_[parent.node].first : nodes_[parent.last].next) = node;
    parent.last = node;
    ++nodes_[parent.node].size;
    nodes_[node].text = texts_.size();
    if (nodes_[parent.node].type == JsonType::Object) {
      nodes_[node].key_size = static_cast<std::uint32_t>(key_.size());
      texts_ += key_;
    }
  }
  return node;
}

void JsonTree::scalar(JsonScalar kind, std::string_view text) {
  const std::uint32_t node = add(kind == JsonScalar::Null     ? JsonType::Null
                                 : kind == JsonScalar::Bool   ? JsonType::Bool
                                 : kind == JsonScalar::Number ? JsonType::Number
                                                              : JsonType::String);
  nodes_[node].text_size = static_cast<std::uint32_t>(text.size());
  texts_ += text;
}

void JsonTree::open(JsonType type) {
  const std::uint32_t node = add(type);
  open_.push_back({node, JsonValue::kNone});
}

void JsonTree::close() {
  const std::uint32_t node = open_.back().node;
  open_.pop_back();
  if (nodes_[node].type != JsonType::Object) return;
  std::set<std::string_view> keys;
  for (JsonValue member(*this, nodes_[node].first); member; member = member.next()) {
    if (keys.insert(member.key()).second) continue;
    throw Error(ErrorCode::BadInput, "a member that is there twice", member.place(),
                printable(member.key()));
  }
}

JsonType JsonValue::type() const { return tree_->nodes_[node_].type; }

std::string_view JsonValue::text() const {
  const JsonTree::Node& node = tree_->nodes_[node_];
  return std::string_view(tree_->texts_).substr(node.text + node.key_size, node.text_size);
}

std::string_view JsonValue::key() const {
  const JsonTree::Node& node = tree_->nodes_[node_];
  return std::string_view(tree_->texts_).substr(node.text, node.key_size);
}

Place JsonValue::place() const {
  const JsonTree::Node& node = tree_->nodes_[node_];
  return {tree_->file_, node.line, node.column};
}

std::size_t JsonValue::size() const { return tree_->nodes_[node_].size; }

JsonValue JsonValue::first() const { return {*tree_, tree_->nodes_[node_].first}; }

JsonValue JsonValue::next() const { return {*tree_, tree_->nodes_[node_].next}; }

JsonValue JsonValue::find(std::string_view key) const {
  JsonValue member = first();
  while (member && member.key() != key) member = member.next();
  return member;
}

void JsonValue::fail(const std::string& message) const {
  throw Error(ErrorCode::BadInput, message, place(), printable(text()));
}

}  // namespace plumbline
