#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "plumbline/engines/inters.hpp"

namespace plumbline::inters {

/// A cell of one or two vertices: a pair of equal ones is one vertex.
struct Cell {
  VertexPair vertices;
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// Hashes of CPython 2.7 on 64 bits, without randomisation: of a text, a number, a tuple of two, of
/// one or two, of any number of numbers.
std::uint64_t python_hash(std::string_view text);
std::uint64_t python_hash(std::size_t number);
std::uint64_t python_hash(const VertexPair& pair);
std::uint64_t python_hash(const Cell& cell);
std::uint64_t python_hash(const std::vector<VertexId>& tuple);

/// The distinct keys in the order in which CPython 2.7 lists a set or a dictionary to which they
/// were added one by one: that of its table, with open addressing and growth by four. It decides
/// the numbering of the module's results.
template <class Key>
class HashTable {
 public:
  HashTable() : slots_(kLeastSize, kFree) {}
  explicit HashTable(std::span<const Key> keys) : HashTable() {
    for (const Key& key : keys) insert(key);
  }

  /// The position of the key among those inserted; whether it is new.
  std::pair<std::size_t, bool> insert(const Key& key) {
    const std::uint64_t hash = python_hash(key);
    std::uint32_t& slot = find(key, hash);
    if (slot != kFree) return {slot, false};
    slot = static_cast<std::uint32_t>(keys_.size());
    keys_.push_back(key);
    hashes_.push_back(hash);
    if (keys_.size() * 3 >= slots_.size() * 2) grow();
    return {keys_.size() - 1, true};
  }

  std::size_t size() const { return keys_.size(); }
  /// In the order of insertion.
  const std::vector<Key>& keys() const { return keys_; }
  /// Positions among `keys`, in the order of the table.
  std::vector<std::size_t> order() const {
    std::vector<std::size_t> result;
    result.reserve(keys_.size());
    for (const std::uint32_t slot : slots_) {
      if (slot != kFree) result.push_back(slot);
    }
    return result;
  }
  std::vector<Key> listed() const {
    std::vector<Key> result;
    result.reserve(keys_.size());
    for (const std::size_t i : order()) result.push_back(keys_[i]);
    return result;
  }

 private:
  static constexpr std::size_t kLeastSize = 8;
  static constexpr std::uint32_t kFree = 0xffffffffU;
  static constexpr std::size_t kLarge = 50'000;  ///< larger tables grow by two

  /// The key's slot, or the free one where it belongs.
  std::uint32_t& find(const Key& key, std::uint64_t hash) {
    const std::uint64_t mask = slots_.size() - 1;
    std::uint64_t i = hash & mask;
    for (std::uint64_t perturbation = hash;; perturbation >>= 5U) {
      std::uint32_t& slot = slots_[i & mask];
      if (slot == kFree || (hashes_[slot] == hash && keys_[slot] == key)) return slot;
      i = (i << 2U) + i + perturbation + 1;
    }
  }

  void grow() {
    const std::size_t least = keys_.size() * (keys_.size() > kLarge ? 2 : 4);
    std::size_t size = kLeastSize;
    while (size <= least) size *= 2;
    const std::vector<std::uint32_t> old = std::move(slots_);
    slots_.assign(size, kFree);
    for (const std::uint32_t slot : old) {
      if (slot != kFree) find(keys_[slot], hashes_[slot]) = slot;
    }
  }

  std::vector<Key> keys_;
  std::vector<std::uint64_t> hashes_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace plumbline::inters
