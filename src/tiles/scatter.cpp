// From a drawing to the segments of each tile, and from the segments of some tiles to those of
// others.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "plumbline/error.hpp"
#include "tiles/manifest.hpp"
#include "tiles/segment_file.hpp"
#include "tiles/segment_source.hpp"

namespace plumbline::tiles {
namespace {

/// How a drawing is read.
std::string text_of(const ReadOptions& o) {
  std::string text = fmt::format("{} {} {} {}{}{}{} {}", o.format, exact_text(o.chord_tolerance),
                                 shortest_text(o.angle_bound), int{o.hidden}, int{o.hatches},
                                 int{o.join_curves}, int{o.shortest_decimals}, o.layer_property);
  for (const std::string& layer : o.layers) text += " +" + layer;
  for (const std::string& layer : o.without_layers) text += " -" + layer;
  return text;
}

/// The file, its size, when it was written, and how it is read.
std::string identity(const std::filesystem::path& drawing, const ReadOptions& options) {
  std::error_code error;
  const auto size = std::filesystem::file_size(drawing, error);
  const std::string how = text_of(options);
  if (error) return line_text(drawing.string() + " " + how);
  const auto time = std::filesystem::last_write_time(drawing, error).time_since_epoch().count();
  return line_text(fmt::format("{} {} {} {}", drawing.string(), size, time, how));
}

/// What a first reading tells: bounds, and x of some ends.
class Survey {
 public:
  void add(const SegmentSet& piece) {
    for (std::size_t s = 0; s < piece.segments.size(); ++s, ++count_) {
      const auto n = piece.segments.numbers(s);
      if (count_ == 0) bounds_ = {n[0], n[1], n[0], n[1]};
      for (const std::size_t i : {0U, 2U}) {
        if (n[i] < bounds_.left) bounds_.left = n[i];
        if (n[i] > bounds_.right) bounds_.right = n[i];
        if (n[i + 1] < bounds_.bottom) bounds_.bottom = n[i + 1];
        if (n[i + 1] > bounds_.top) bounds_.top = n[i + 1];
      }
      if (count_ % stride_ != 0) continue;
      sample_.push_back(n[0]);
      if (sample_.size() == kMost) halve();
    }
  }

  Manifest manifest(std::size_t tiles) {
    Manifest result;
    result.segments = count_;
    result.bounds = bounds_;
    for (const Number& x : sample_) {
      result.digits = std::max(result.digits, x.is_decimal() ? x.digits() : Number::kMaxDigits);
    }
    std::sort(sample_.begin(), sample_.end());
    std::vector<Number> cuts;
    for (std::size_t i = 1; i < tiles; ++i) {
      const Number& x = sample_[i * sample_.size() / tiles];
      if (x == bounds_.left || x == bounds_.right) continue;
      const Number cut = off_grid(x, result.digits);
      if (cuts.empty() || cuts.back() < cut) cuts.push_back(cut);
    }
    for (std::size_t i = 0; i <= cuts.size(); ++i) {
      Tile tile;
      tile.number = result.next++;
      if (i > 0) tile.strip.left = cuts[i - 1];
      if (i < cuts.size()) tile.strip.right = cuts[i];
      result.tiles.push_back(tile);
    }
    return result;
  }

  /// Next to x where no number of so many decimals is, nor half of one.
  static Number off_grid(const Number& x, int digits) {
    return x + Number(Rational(371) / power_of_ten(digits + 3));
  }
  static Rational power_of_ten(int exponent) {
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
    return power;
  }

 private:
  static constexpr std::size_t kMost = 1U << 17;

  void halve() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < sample_.size(); i += 2) std::swap(sample_[kept++], sample_[i]);
    sample_.resize(kept);
    stride_ *= 2;
  }

  std::uint64_t count_ = 0, stride_ = 1;
  Bounds bounds_;
  std::vector<Number> sample_;
};

/// Writes segments to the tiles that they meet.
class Scattering {
 public:
  Scattering(const std::filesystem::path& folder, std::vector<Tile>& tiles) : tiles_(tiles) {
    for (const Tile& tile : tiles) writers_.emplace_back(segments_of(folder, tile.number));
  }
  void add(const NumberedSegment& segment) {
    const Number& low = segment.low();
    auto i = static_cast<std::size_t>(std::partition_point(tiles_.begin(), tiles_.end(),
                                                           [&](const Tile& tile) {
                                                             return tile.strip.right &&
                                                                    *tile.strip.right < low;
                                                           }) -
                                      tiles_.begin());
    for (; i < tiles_.size() && meets(segment, tiles_[i].strip); ++i) writers_[i].write(segment);
  }
  void close() {
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
      writers_[i].close();
      tiles_[i].segments = writers_[i].count();
      tiles_[i].hash = writers_[i].hash();
    }
  }

 private:
  std::vector<Tile>& tiles_;
  std::vector<SegmentWriter> writers_;
};

/// The segments of neighbouring tiles, each once.
void for_each_segment(const std::filesystem::path& folder, std::span<const Tile> tiles,
                      const std::function<void(const NumberedSegment&)>& visit) {
  std::vector<SegmentReader> readers;
  std::vector<std::optional<NumberedSegment>> next;
  for (const Tile& tile : tiles) {
    readers.emplace_back(segments_of(folder, tile.number));
    next.push_back(readers.back().next());
  }
  while (true) {
    const NumberedSegment* least = nullptr;
    for (const auto& segment : next) {
      if (segment && (least == nullptr || segment->number < least->number)) least = &*segment;
    }
    if (least == nullptr) return;
    const std::uint64_t number = least->number;
    visit(*least);
    for (std::size_t i = 0; i < next.size(); ++i) {
      if (next[i] && next[i]->number == number) next[i] = readers[i].next();
    }
  }
}

/// Replaces some tiles, which are neighbours, by two with this cut.
void recut(const std::filesystem::path& folder, Manifest& manifest, std::size_t first,
           std::size_t count, const Number& cut) {
  const auto begin = manifest.tiles.begin() + static_cast<std::ptrdiff_t>(first);
  const std::vector<Tile> old(begin, begin + static_cast<std::ptrdiff_t>(count));
  std::vector<Tile> made(2);
  made[0].number = manifest.next++;
  made[1].number = manifest.next++;
  made[0].strip = {old.front().strip.left, cut};
  made[1].strip = {cut, old.back().strip.right};
  Scattering scattering(folder, made);
  for_each_segment(folder, old, [&](const NumberedSegment& s) { scattering.add(s); });
  scattering.close();
  const auto place = manifest.tiles.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  manifest.tiles.insert(place, made.begin(), made.end());
  write_manifest(folder, manifest);
  for (const Tile& tile : old) {
    std::error_code ignored;
    std::filesystem::remove(segments_of(folder, tile.number), ignored);
    std::filesystem::remove(part_of(folder, tile.number), ignored);
  }
}

}  // namespace

std::vector<Rejected> scatter(const std::filesystem::path& drawing, const ReadOptions& options,
                              std::size_t tiles, const std::filesystem::path& folder,
                              const Told& told) {
  if (has_manifest(folder)) {
    if (read_manifest(folder).drawing == identity(drawing, options)) return {};
    throw Error(ErrorCode::BadInput,
                "the folder has tiles of another drawing, or of one read in another way",
                {folder.string(), 0, 0});
  }
  Survey survey;
  std::uint64_t number = 0;
  const auto tell = [&](const SegmentSet& piece) {
    number += piece.segments.size();
    if (told) told(number);
  };
  std::vector<Rejected> rejected = for_each_piece(drawing, options, [&](const SegmentSet& piece) {
    survey.add(piece);
    tell(piece);
  });
  if (number == 0) {
    throw Error(ErrorCode::BadInput, "it has no segments", {drawing.string(), 0, 0});
  }
  Manifest manifest = survey.manifest(std::max<std::size_t>(tiles, 1));
  manifest.drawing = identity(drawing, options);
  manifest.rejected = rejected.size();
  manifest.lost = count_lost(rejected);
  Scattering scattering(folder, manifest.tiles);
  number = 0;
  for_each_piece(drawing, options, [&](const SegmentSet& piece) {
    for (std::size_t s = 0; s < piece.segments.size(); ++s) {
      const auto n = piece.segments.numbers(s);
      scattering.add({number + s, {n[0], n[1], n[2], n[3]}});
    }
    tell(piece);
  });
  ensure(number == manifest.segments, "the drawing is the same when it is read again");
  scattering.close();
  write_manifest(folder, manifest);
  return rejected;
}

bool split(const std::filesystem::path& folder, std::uint64_t number) {
  Manifest manifest = read_manifest(folder);
  const std::size_t place = place_of(manifest, number);
  const Tile tile = manifest.tiles[place];
  std::vector<Number> within;
  for_each_segment(folder, {&tile, 1}, [&](const NumberedSegment& segment) {
    for (const Number& x : {segment.at[0], segment.at[2]}) {
      const bool is_within = (!tile.strip.left || *tile.strip.left < x) &&
                             (!tile.strip.right || x < *tile.strip.right);
      if (is_within) within.push_back(x);
    }
  });
  if (within.empty()) return false;
  std::nth_element(within.begin(), within.begin() + static_cast<std::ptrdiff_t>(within.size() / 2),
                   within.end());
  const Number cut = Survey::off_grid(within[within.size() / 2], manifest.digits);
  const bool parts = (!tile.strip.left || *tile.strip.left < cut) &&
                     (!tile.strip.right || cut < *tile.strip.right) && cut < manifest.bounds.right;
  if (!parts) return false;
  recut(folder, manifest, place, 1, cut);
  return true;
}

void move_cut(const std::filesystem::path& folder, std::uint64_t number, Side side) {
  Manifest manifest = read_manifest(folder);
  const std::size_t place = place_of(manifest, number);
  ensure(side == kLeft ? place > 0 : place + 1 < manifest.tiles.size(), "a cut has two sides");
  const std::size_t first = side == kLeft ? place - 1 : place;
  const Number step(Rational(37) / Survey::power_of_ten(manifest.digits + 4));
  recut(folder, manifest, first, 2, *manifest.tiles[first].strip.right + step);
}

}  // namespace plumbline::tiles
