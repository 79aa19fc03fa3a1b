#pragma once

#include "output/json/writer.hpp"

namespace plumbline::json {

inline auto source_members(const Source& s) {
  return members(member("file", s.file), member("line", s.line), member("column", s.column),
                 member("element", s.element), member("id", s.id), member("path", s.path),
                 when(!s.layer.empty(), [&s] { return member("layer", s.layer); }));
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
