#pragma once

#include <utility>

#include "output/json/writer.hpp"

namespace plumbline::json {

/// Of a source that stays until it is written.
inline auto source_members(const Source& s) {
  return members(member("file", s.file), member("line", s.line), member("column", s.column),
                 member("element", s.element), member("id", s.id), member("path", s.path),
                 when(!s.layer.empty(), [&s] { return member("layer", s.layer); }));
}

/// Of one that does not: the members keep its texts.
inline auto source_members(Source&& s) {
  return members(member("file", s.file), member("line", s.line), member("column", s.column),
                 member("element", std::move(s.element)), member("id", std::move(s.id)),
                 member("path", std::move(s.path)), when(!s.layer.empty(), [layer = s.layer] {
                   return member("layer", std::string(layer));
                 }));
}

/// "rejected", "remarks" and "ledger".
Part losses(const std::vector<Rejected>& rejected, const std::vector<Remark>& remarks,
            const std::vector<Replacement>& ledger);

/// "crs", where there is one.
Part crs_member(const std::string& crs);

/// Where a drawing's items come from: "crs", "files", "sources", "segments", "rejected",
/// "remarks", "ledger".
/// Documented in docs/json.md.
Part input_members(const SegmentSet& input);

}  // namespace plumbline::json
