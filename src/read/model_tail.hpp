#pragma once

#include "plumbline/structure/model.hpp"

namespace plumbline {

/// How much a table holds.
struct TableSize {
  std::size_t segments = 0, rows = 0, row_ids = 0, rings = 0, labels = 0;
};
TableSize size_of(const Model& table);

/// Takes what was added to a table since it had this size, as a table of its own.
Model split_off(Model& table, const TableSize& before);
/// Drops it.
void cut_off(Model& table, const TableSize& before);
/// Adds the rows of one table to another.
void append(Model& table, const Model& more);

}  // namespace plumbline
