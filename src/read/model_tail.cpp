#include "read/model_tail.hpp"

#include <utility>

namespace plumbline {
namespace {

template <class Item>
void drop(std::vector<Item>& items, std::size_t kept) {
  items.erase(items.begin() + static_cast<std::ptrdiff_t>(kept), items.end());
}

}  // namespace

TableSize size_of(const Model& table) {
  return {table.segments.size(), table.rows.size(), table.row_ids.size(), table.rings.size(),
          table.labels.size()};
}

Model split_off(Model& table, const TableSize& before) {
  Model tail;
  tail.source = table.source;
  for (std::size_t i = before.segments; i < table.segments.size(); ++i) {
    const auto n = table.segments.numbers(i);
    tail.segments.push_back(NumberPoint{n[0], n[1]}, NumberPoint{n[2], n[3]});
  }
  for (std::size_t i = before.rows; i < table.rows.size(); ++i) {
    Model::Row row = table.rows[i];
    if (row.id != 0) row.id -= static_cast<std::uint32_t>(before.row_ids);
    tail.rows.push_back(row);
  }
  for (std::size_t i = before.row_ids; i < table.row_ids.size(); ++i) {
    tail.row_ids.push_back(table.row_ids[i]);
  }
  for (std::size_t i = before.rings; i < table.rings.size(); ++i) {
    Ring ring = table.rings[i];
    ring.first -= static_cast<std::uint32_t>(before.segments);
    tail.rings.push_back(ring);
  }
  for (std::size_t i = before.labels; i < table.labels.size(); ++i) {
    Model::Text label = table.labels[i];
    label.row -= static_cast<std::uint32_t>(before.rows);
    tail.labels.push_back(std::move(label));
  }
  cut_off(table, before);
  return tail;
}

void cut_off(Model& table, const TableSize& before) {
  table.segments.truncate(before.segments);
  drop(table.rows, before.rows);
  drop(table.row_ids, before.row_ids);
  drop(table.rings, before.rings);
  drop(table.labels, before.labels);
}

void append(Model& table, const Model& more) {
  const TableSize size = size_of(table);
  for (std::size_t i = 0; i < more.segments.size(); ++i) {
    const auto n = more.segments.numbers(i);
    table.segments.push_back(NumberPoint{n[0], n[1]}, NumberPoint{n[2], n[3]});
  }
  for (Model::Row row : more.rows) {
    if (row.id != 0) row.id += static_cast<std::uint32_t>(size.row_ids);
    table.rows.push_back(row);
  }
  table.row_ids.insert(table.row_ids.end(), more.row_ids.begin(), more.row_ids.end());
  for (Ring ring : more.rings) {
    ring.first += static_cast<std::uint32_t>(size.segments);
    table.rings.push_back(ring);
  }
  for (Model::Text label : more.labels) {
    label.row += static_cast<std::uint32_t>(size.rows);
    table.labels.push_back(std::move(label));
  }
}

}  // namespace plumbline
