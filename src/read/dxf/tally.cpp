#include "read/dxf/tally.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "geometry/rejected.hpp"
#include "number/bound_text.hpp"

namespace plumbline::dxf {
namespace {

std::string counted(const std::string& text, std::size_t count) {
  return count == 1 ? text : text + " (" + std::to_string(count) + " of them)";
}

template <class Item>
void sort_by_line(std::vector<Item>& items) {
  std::stable_sort(items.begin(), items.end(),
                   [](const Item& a, const Item& b) { return a.source.line < b.source.line; });
}

}  // namespace

void Tally::refuse(const Source& source, const Unusable& problem) {
  refused_.push_back(make_rejected(source, problem.reason, problem.text, problem.harmless));
}

void Tally::leave_out(const Source& source, const std::string& reason, bool harmless) {
  add(left_out_, {source.element, reason, {}}, {source, 1, 0, harmless});
}

void Tally::remark(const Source& source, const std::string& what) {
  add(remarks_, {source.element, what, {}}, {source, 1});
}

void Tally::replace(const Source& source, const Substitution& replaced) {
  add(replaced_, {source.element, replaced.what, replaced.unit}, {source, 1, replaced.bound});
}

void Tally::add(Counts& counts, const Key& key, const Count& more) {
  const auto [found, is_new] = counts.try_emplace(key, more);
  if (is_new) return;
  Count& count = found->second;
  if (more.first.line < count.first.line) count.first = more.first;
  count.count += more.count;
  count.bound = std::max(count.bound, more.bound);
  count.harmless = count.harmless && more.harmless;
}

void Tally::merge(Tally other) {
  std::move(other.refused_.begin(), other.refused_.end(), std::back_inserter(refused_));
  for (const auto& [key, count] : other.left_out_) add(left_out_, key, count);
  for (const auto& [key, count] : other.remarks_) add(remarks_, key, count);
  for (const auto& [key, count] : other.replaced_) add(replaced_, key, count);
}

void Tally::append_to(Structure& structure) const {
  std::vector<Rejected> rejected = refused_;
  for (const auto& [key, count] : left_out_) {
    rejected.push_back({count.first, counted(std::get<1>(key), count.count), {}, count.harmless});
  }
  sort_by_line(rejected);
  std::move(rejected.begin(), rejected.end(), std::back_inserter(structure.rejected));

  std::vector<Remark> remarks;
  for (const auto& [key, count] : remarks_) {
    remarks.push_back({count.first, counted(std::get<1>(key), count.count), {}});
  }
  sort_by_line(remarks);
  std::move(remarks.begin(), remarks.end(), std::back_inserter(structure.remarks));

  std::vector<Replacement> ledger;
  for (const auto& [key, count] : replaced_) {
    ledger.push_back({count.first, counted(std::get<1>(key), count.count),
                      bound_text(count.bound) + " " + std::get<2>(key)});
  }
  sort_by_line(ledger);
  std::move(ledger.begin(), ledger.end(), std::back_inserter(structure.ledger));
}

}  // namespace plumbline::dxf
