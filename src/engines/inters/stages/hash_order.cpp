#include "engines/inters/stages/hash_order.hpp"

namespace plumbline::inters {
namespace {

constexpr std::uint64_t kMultiplier = 1'000'003;
/// -1 marks an error in CPython, so no hash is -1.
std::uint64_t valid(std::uint64_t hash) { return hash == ~std::uint64_t{0} ? hash - 1 : hash; }

std::uint64_t tuple_hash(std::span<const VertexId> items) {
  constexpr std::uint64_t kSeed = 0x345678, kStep = 82520, kEnd = 97531;
  std::uint64_t hash = kSeed, multiplier = kMultiplier;
  std::uint64_t left = items.size();
  for (const VertexId item : items) {
    --left;
    hash = (hash ^ python_hash(static_cast<std::size_t>(item))) * multiplier;
    multiplier += kStep + 2 * left;
  }
  return valid(hash + kEnd);
}

}  // namespace

std::uint64_t python_hash(std::string_view text) {
  if (text.empty()) return 0;
  const auto byte = [](char c) {
    return static_cast<std::uint64_t>(static_cast<unsigned char>(c));
  };
  std::uint64_t hash = byte(text.front()) << 7U;
  for (const char c : text) hash = (kMultiplier * hash) ^ byte(c);
  return valid(hash ^ text.size());
}

std::uint64_t python_hash(std::size_t number) { return number; }

std::uint64_t python_hash(const VertexPair& pair) { return tuple_hash(pair); }

std::uint64_t python_hash(const Cell& cell) {
  return tuple_hash(std::span(cell.vertices).first(cell.vertices[0] == cell.vertices[1] ? 1 : 2));
}

std::uint64_t python_hash(const std::vector<VertexId>& tuple) { return tuple_hash(tuple); }

}  // namespace plumbline::inters
