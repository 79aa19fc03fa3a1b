#include <algorithm>

#include "plumbline/detail/source.hpp"

namespace plumbline {
namespace {

/// A source is compared with this many kinds before it becomes a kind of its own: drawings
/// alternate between few.
constexpr std::size_t kComparedKinds = 8;

}  // namespace

Source SourceList::operator[](std::size_t i) const {
  const Row& row = rows_[i];
  Source source = kinds_[row.kind];
  source.line = row.line;
  source.column = row.column;
  if (row.id != 0) source.id = ids_[row.id - 1];
  return source;
}

Source SourceList::at(std::size_t i) const {
  static_cast<void>(rows_.at(i));
  return (*this)[i];
}

void SourceList::push_back(const Source& source) {
  const std::uint32_t kind = kind_of(source);
  if (!source.id.empty()) ids_.push_back(source.id);
  const auto id = source.id.empty() ? 0 : static_cast<std::uint32_t>(ids_.size());
  rows_.push_back({source.line, source.column, kind, id});
}

std::uint32_t SourceList::kind_of(const Source& source) {
  const auto last = kinds_.rbegin();
  const auto compared = last + static_cast<std::ptrdiff_t>(std::min(kinds_.size(), kComparedKinds));
  const auto known = std::find_if(last, compared, [&source](const Source& kind) {
    return kind.file == source.file && kind.element == source.element && kind.path == source.path &&
           kind.layer == source.layer;
  });
  if (known == compared) {
    kinds_.push_back({source.file, 0, 0, source.element, {}, source.path, source.layer});
    return static_cast<std::uint32_t>(kinds_.size() - 1);
  }
  return static_cast<std::uint32_t>(kinds_.rend() - known - 1);
}

}  // namespace plumbline
