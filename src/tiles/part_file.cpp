// A head, then lists of plain records with their lengths, and a hash of it all behind.

#include "tiles/part_file.hpp"

#include <cstring>
#include <type_traits>
#include <vector>

#include "tiles/cell_hash.hpp"

namespace plumbline::tiles {
namespace {

constexpr std::uint64_t kMagic = 0x31'54'52'41'50'42'4c'50;  // "PLBPART1"

/// Calls `with` for each value and list of a part, in one order.
template <class Part, class With>
void for_each_member(Part& part, With with) {
  with(part.closed);
  with(part.components);
  for (auto& border : part.borders) {
    with(border.ports);
    with(border.faces);
  }
  with(part.pieces);
  with(part.chains);
  with(part.corners);
  with(part.faces);
}

class Writer {
 public:
  template <class T>
  void operator()(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  }
  template <class T>
  void operator()(const std::vector<T>& list) {
    (*this)(static_cast<std::uint64_t>(list.size()));
    for (const T& value : list) (*this)(value);
  }
  std::string bytes;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  void operator()(T& value) {
    is_whole = is_whole && bytes_.size() >= sizeof(value);
    if (!is_whole) return;
    std::memcpy(&value, bytes_.data(), sizeof(value));
    bytes_.remove_prefix(sizeof(value));
  }
  template <class T>
  void operator()(std::vector<T>& list) {
    std::uint64_t size = 0;
    (*this)(size);
    is_whole = is_whole && size <= bytes_.size() / sizeof(T);
    if (!is_whole) return;
    list.resize(size);
    for (T& value : list) (*this)(value);
  }
  bool is_whole = true;

 private:
  std::string_view bytes_;
};

}  // namespace

std::string to_bytes(const StripPart& part, const CellHash& segments) {
  Writer writer;
  writer(kMagic);
  writer(segments);
  for_each_member(part, [&](const auto& member) { writer(member); });
  const CellHash hash = bytes_hash(writer.bytes);
  writer(hash);
  return std::move(writer.bytes);
}

std::optional<StripPart> from_bytes(std::string_view bytes, const CellHash& segments) {
  if (bytes.size() < sizeof(CellHash)) return {};
  const std::string_view content = bytes.substr(0, bytes.size() - sizeof(CellHash));
  CellHash hash;
  Reader(bytes.substr(content.size()))(hash);
  if (hash != bytes_hash(content)) return {};
  Reader reader(content);
  std::uint64_t magic = 0;
  CellHash of;
  reader(magic);
  reader(of);
  if (magic != kMagic || of != segments) return {};
  StripPart part;
  for_each_member(part, [&](auto& member) { reader(member); });
  if (!reader.is_whole) return {};
  return part;
}

}  // namespace plumbline::tiles
