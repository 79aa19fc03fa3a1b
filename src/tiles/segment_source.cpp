#include "tiles/segment_source.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>

#include "plumbline/error.hpp"
#include "plumbline/structure.hpp"

namespace plumbline::tiles {
namespace {

constexpr std::size_t kPiece = 4U << 20;

bool is_read_in_pieces(const std::filesystem::path& drawing, const ReadOptions& options) {
  std::error_code ignored;
  const bool is_lines =
      options.format.empty() ? drawing.extension() == ".lines" : options.format == "lines";
  return is_lines && !options.shortest_decimals &&
         std::filesystem::is_regular_file(drawing, ignored);
}

/// The next bytes up to the end of a line; rest is kept for the next call.
bool next_lines(std::istream& file, std::string& rest, std::string& lines) {
  lines = std::move(rest);
  rest.clear();
  const std::size_t kept = lines.size();
  lines.resize(kept + kPiece);
  file.read(lines.data() + kept, static_cast<std::streamsize>(kPiece));
  lines.resize(kept + static_cast<std::size_t>(file.gcount()));
  if (file.eof()) return !lines.empty();
  const std::size_t end = lines.find_last_of('\n');
  if (end == std::string::npos) return true;
  rest = lines.substr(end + 1);
  lines.resize(end + 1);
  return true;
}

}  // namespace

std::vector<Rejected> for_each_piece(const std::filesystem::path& drawing,
                                     const ReadOptions& options,
                                     const std::function<void(const SegmentSet&)>& visit) {
  if (!is_read_in_pieces(drawing, options)) {
    const SegmentSet all =
        evaluate(read(drawing, options), {kMaxEvaluatedWords, options.max_segments});
    visit(all);
    return all.rejected;
  }
  std::ifstream file(drawing, std::ios::binary);
  if (!file) throw Error(ErrorCode::BadFile, "cannot open it", {drawing.string(), 0, 0});
  std::vector<Rejected> rejected;
  std::uint32_t line = 0;
  std::size_t segments = 0;
  std::string rest, lines;
  while (next_lines(file, rest, lines)) {
    const SegmentSet piece = evaluate(read_lines(lines, drawing.string(), options));
    visit(piece);
    segments += piece.segments.size();
    if (segments > options.max_segments) {
      throw Error(ErrorCode::Limit, "more segments than --max-segments allows");
    }
    for (Rejected item : piece.rejected) {
      item.source.line += line;
      rejected.push_back(std::move(item));
    }
    line += static_cast<std::uint32_t>(std::count(lines.begin(), lines.end(), '\n'));
  }
  if (file.bad()) {
    throw Error(ErrorCode::BadFile, "cannot be read to its end", {drawing.string(), 0, 0});
  }
  return rejected;
}

}  // namespace plumbline::tiles
