// Drawings larger than memory: `arrange --tiles`, and the processes that it starts.

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <thread>

#include "cli/commands.hpp"
#include "cli/losses.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "plumbline/error.hpp"
#include "plumbline/tiles/files.hpp"

namespace plumbline::cli {
namespace {

namespace fs = std::filesystem;

/// Starts a process with this program's signals. Returns its number.
template <class Then>
::pid_t start_process(Then then) {
  const ::pid_t child = ::fork();
  if (child < 0) throw Error(ErrorCode::Limit, "cannot start a process");
  if (child > 0) return child;
  ::sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  then();
  ::_exit(kInternal);
}

/// A folder for temporary files that is gone when this process is, however it ends: a shell waits
/// for the end of a pipe that this process holds open, and removes it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "plumbline-tiles-XXXXXX").string();
    int ends[2] = {-1, -1};
    if (::mkdtemp(name.data()) == nullptr || ::pipe2(ends, O_CLOEXEC) != 0) {
      throw Error(ErrorCode::BadFile, "cannot make a folder for temporary files", {name, 0, 0});
    }
    path_ = name;
    open_ = ends[1];
    remover_ = start_process([&] {
      ::setsid();
      ::dup2(ends[0], STDIN_FILENO);
      const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
      ::dup2(nowhere, STDOUT_FILENO);
      ::dup2(nowhere, STDERR_FILENO);
      ::execl("/bin/sh", "sh", "-c", "read -r _; sleep 0.3; exec rm -rf -- \"$0\"", name.c_str(),
              nullptr);
    });
    ::close(ends[0]);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    ::kill(remover_, SIGKILL);
    ::waitpid(remover_, nullptr, 0);
    ::close(open_);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
  int open_ = -1;
  ::pid_t remover_ = 0;
};

/// The folder that -o names, or a temporary one.
class Folder {
 public:
  explicit Folder(const std::optional<std::string>& output) {
    if (!output) {
      path_ = temporary_.emplace().path();
      return;
    }
    path_ = *output;
    std::error_code error;
    fs::create_directories(path_, error);
    if (error) throw Error(ErrorCode::BadFile, "cannot make this folder", {*output, 0, 0});
  }
  const fs::path& path() const { return path_; }
  /// What is not needed once all is done.
  void remove_segments() const {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
      const fs::path kind = entry.path().extension();
      if (kind == ".segments" || kind == ".error") fs::remove(entry.path(), ignored);
    }
  }

 private:
  std::optional<TemporaryFolder> temporary_;
  fs::path path_;
};

/// Processes that arrange tiles, some at a time.
class Workers {
 public:
  Workers(const ArrangeArguments& arguments, const fs::path& folder)
      : arguments_(arguments), folder_(folder) {
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    count_ = arguments.workers > 0 ? arguments.workers : cores;
  }
  std::size_t count() const { return count_; }

  /// Until each tile has its part. Tiles that need more memory than there may be are split, cuts
  /// through vertices moved, once nothing else runs.
  void run(Progress& progress) {
    while (true) {
      const std::vector<std::uint64_t> missing = missing_tiles();
      if (missing.empty()) return;
      problems_.clear();
      for (std::size_t i = 0; i < missing.size(); ++i) {
        progress.tell(static_cast<double>(i) / static_cast<double>(missing.size()));
        while (running_.size() >= count_) wait();
        start(missing[i]);
      }
      while (!running_.empty()) wait();
      solve();
    }
  }
  std::size_t splits() const { return splits_; }

 private:
  std::vector<std::uint64_t> missing_tiles() const {
    std::vector<std::uint64_t> missing;
    for (const tiles::Tile& tile : tiles::read_manifest(folder_).tiles) {
      if (!tiles::has_part(folder_, tile)) missing.push_back(tile.number);
    }
    return missing;
  }

  fs::path errors_of(std::uint64_t tile) const { return folder_ / fmt::format("{}.error", tile); }

  /// A process of this program that ends with this one.
  void start(std::uint64_t tile) {
    std::vector<std::string> words{"plumbline", "tile", folder_.string(), std::to_string(tile),
                                   "-q"};
    if (arguments_.limits.bytes) {
      words.insert(words.end(), {"--max-memory", arguments_.limits.memory});
    }
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const std::string errors = errors_of(tile).string();
    const ::pid_t child = start_process([&] {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (std::freopen(errors.c_str(), "w", stderr) != nullptr) {
        ::execv("/proc/self/exe", argv.data());
      }
    });
    running_[child] = tile;
  }

  void wait() {
    int status = 0;
    const ::pid_t child = ::waitpid(-1, &status, 0);
    const auto found = running_.find(child);
    if (found == running_.end()) return;
    const std::uint64_t tile = found->second;
    running_.erase(found);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
    problems_.emplace_back(tile, status);
  }

  std::string said(std::uint64_t tile) const {
    std::ifstream file(errors_of(tile));
    std::string text;
    std::getline(file, text);
    return text;
  }

  /// Of neighbours one at a time: the others are seen again in the next round.
  void solve() {
    constexpr int kMostKills = 3;
    for (const auto& [tile, status] : problems_) {
      const std::string why = said(tile);
      if (WIFSIGNALED(status)) {  // killed from outside, which may have been for memory
        if (++kills_[tile] < kMostKills) continue;
        throw Error(ErrorCode::Limit,
                    fmt::format("its process was ended three times by signal {}", WTERMSIG(status)),
                    {}, fmt::format("tile {}", tile));
      }
      const int code = WEXITSTATUS(status);
      if (code == kCutThroughVertex || code == kCutThroughVertex + 1) {
        tiles::move_cut(folder_, tile, code == kCutThroughVertex ? tiles::kLeft : tiles::kRight);
        return;
      }
      const bool is_memory = code == kBadInput && why.find("memory") != std::string::npos;
      if (!is_memory || !tiles::split(folder_, tile)) {
        throw Error(code == kInternal ? ErrorCode::Internal : ErrorCode::Limit,
                    why.empty() ? "its process failed" : why, {}, fmt::format("tile {}", tile));
      }
      ++splits_;
    }
  }

  const ArrangeArguments& arguments_;
  fs::path folder_;
  std::size_t count_ = 1, splits_ = 0;
  std::map<::pid_t, std::uint64_t> running_;
  std::vector<std::pair<std::uint64_t, int>> problems_;  ///< tiles and how their processes ended
  std::map<std::uint64_t, int> kills_;
};

void check_options(const ArrangeArguments& arguments) {
  const std::pair<bool, const char*> others[] = {
      {arguments.format.has_value(), "--format"},
      {arguments.certificate.has_value(), "--certify"},
      {arguments.compact, "--compact"},
      {arguments.safe, "--safe"},
      {!arguments.cells.empty(), "--cells"},
      {arguments.both_engines, "--both-engines"},
      {arguments.unit_square, "--unit-square"},
      {!arguments.walls.empty(), "--walls"},
      {arguments.grid.decimals.has_value(), "--decimals"},
      {arguments.files.size() > 1, "several drawings"}};
  for (const auto& [is_given, name] : others) {
    if (is_given) throw Error(ErrorCode::BadInput, "not with --tiles", {}, name);
  }
}

}  // namespace

ExitCode run_in_tiles(const ArrangeArguments& arguments, Report& report) {
  check_options(arguments);
  const Folder folder(arguments.output);
  const std::vector<Rejected> rejected = [&] {
    Progress progress("reading " + arguments.file, arguments);
    return tiles::scatter(arguments.file, arguments.reading, arguments.tiles, folder.path(),
                          [&](std::uint64_t segments) {
                            progress.tell(fmt::format("reading {} segments, twice", segments));
                          });
  }();
  ensure_all_drawn(arguments, arguments.file, rejected, false);
  if (const tiles::Manifest done = tiles::read_manifest(folder.path());
      done.lost > 0 && !arguments.lenient) {
    throw Error(ErrorCode::BadInput,
                fmt::format("not all of the drawing is in these tiles: {} items that look like "
                            "geometry could not be read; --lenient goes on without them",
                            done.lost),
                {arguments.file, 0, 0});
  }
  Workers workers(arguments, folder.path());
  {
    Progress progress("arranging tiles", arguments);
    workers.run(progress);
  }
  const tiles::Manifest manifest = tiles::read_manifest(folder.path());
  const tiles::Totals totals = tiles::merged(folder.path());
  folder.remove_segments();
  report.set("segments", manifest.segments);
  report.set("rejected", manifest.rejected);
  report.set("lost", manifest.lost);
  report.set("tiles", manifest.tiles.size());
  report.set("workers", workers.count());
  report.set("vertices", totals.vertices);
  report.set("edges", totals.edges);
  report.set("faces", totals.faces);
  report.set("holes", totals.holes);
  report.set("components", totals.components);
  report.set("signature2", tiles::to_text(totals.signature));
  report.print("{} vertices, {} edges, {} faces with {} holes, {} components\n", totals.vertices,
               totals.edges, totals.faces, totals.holes, totals.components);
  report.print("{} segments in {} tiles{}, by {} process{}\nsignature2 {}\n", manifest.segments,
               manifest.tiles.size(),
               workers.splits() == 0 ? "" : fmt::format(", {} cut in two", workers.splits()),
               workers.count(), workers.count() == 1 ? "" : "es", tiles::to_text(totals.signature));
  if (arguments.output) report.say_written(*arguments.output);
  return kAgree;
}

ExitCode run(const TileArguments& arguments, Report& /*report*/) {
  try {
    tiles::arrange_tile(arguments.folder, arguments.tile);
  } catch (const tiles::CutThroughVertex& cut) {
    return static_cast<ExitCode>(kCutThroughVertex + (cut.side == tiles::kLeft ? 0 : 1));
  }
  return kAgree;
}

}  // namespace plumbline::cli
