#include "campaign/campaign.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <new>
#include <system_error>

#include "campaign/child.hpp"
#include "campaign/judge.hpp"
#include "campaign/minimise.hpp"
#include "plumbline/output.hpp"

namespace plumbline::campaign {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kBatch = 10'000;
constexpr double kHang = 60;         ///< seconds without a case done, in a batch
constexpr double kAlone = 180;       ///< seconds for a case on its own
constexpr double kTrial = 10;        ///< seconds for a smaller input that may hang as well
constexpr double kMinimising = 300;  ///< seconds for making one input small
constexpr std::size_t kMostFamilies = 64;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What parent and child both see.
struct Board {
  std::atomic<std::uint64_t> current = 0;
  std::atomic<bool> stop = false;
  std::array<FamilyTotals, kMostFamilies> families{};
  std::array<std::uint64_t, kRelations.size()> relations{};
};

class SharedBoard {
 public:
  SharedBoard() {
    void* memory =
        mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "mmap");
    board_ = new (memory) Board;
  }
  SharedBoard(const SharedBoard&) = delete;
  SharedBoard& operator=(const SharedBoard&) = delete;
  ~SharedBoard() { munmap(board_, sizeof(Board)); }
  Board& operator*() { return *board_; }
  Board* operator->() { return board_; }

 private:
  Board* board_ = nullptr;
};

volatile std::sig_atomic_t is_interrupted = 0;
void interrupt(int) { is_interrupted = 1; }

std::string judged(const Plan& plan, const Case& one) {
  return what_is_wrong(input_of(plan, one), one.relation, one.dice);
}

/// What is wrong with the first case that fails; which it is stands on the board.
std::string run_batch(const Plan& plan, std::uint64_t first, std::uint64_t end, Board& board) {
  for (std::uint64_t number = first; number < end && !board.stop; ++number) {
    board.current = number;
    const auto start = Clock::now();
    const Case one = case_of(plan, number);
    FamilyTotals& totals = board.families[one.family];
    ++totals.cases;
    ++board.relations[static_cast<std::size_t>(one.relation)];
    const SegmentSet input = input_of(plan, one);
    totals.segments += input.segments.size();
    totals.most_segments = std::max<std::uint64_t>(totals.most_segments, input.segments.size());
    std::string wrong = what_is_wrong(input, one.relation, one.dice);
    totals.seconds += seconds_since(start);
    if (!wrong.empty()) return wrong;
  }
  return "";
}

bool is_same_kind(const std::string& what, const std::string& other) {
  for (const char* kind : {"throws", "crash"}) {
    if (what.starts_with(kind)) return other.starts_with(kind);
  }
  return what == other;
}

/// Rows of a small input that fails in the same way, for some choices of its relation.
std::string small_rows(const Plan& plan, const Case& one, const std::string& what) {
  constexpr std::uint64_t kTries = 4;
  const auto start = Clock::now();
  const auto fails = [&](const SegmentSet& input) {
    for (std::uint64_t more = 0; more < kTries; ++more) {
      if (is_interrupted != 0 || seconds_since(start) > kMinimising) return false;
      const auto judge = [&] { return what_is_wrong(input, one.relation, one.dice + more); };
      if (is_same_kind(what, in_child(judge, kTrial))) return true;
    }
    return false;
  };
  return to_lines(minimised(input_of(plan, one), fails));
}

void print(const Plan& plan, const Failure& failure) {
  const Case& one = failure.failed;
  fmt::print(stderr, "# {}\n# family \"{}\", seed {}, {}, relation \"{}\", dice {}\n{}",
             failure.what, plan.families[one.family], one.seed,
             one.extent == inputs::Extent::Small ? "small" : "usual", to_text(one.relation),
             one.dice, failure.rows);
  std::fflush(stderr);
}

/// Waits for a batch, and ends it when a case takes too long.
void watch(Child& child, Board& board, const std::function<bool()>& is_over, std::uint64_t first) {
  std::uint64_t seen = board.current;
  auto since = Clock::now();
  while (!child.ended_within(0.2)) {
    if (is_over()) board.stop = true;
    if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r{} cases", board.current.load() - first);
    if (board.current != seen) {
      seen = board.current;
      since = Clock::now();
    } else if (seconds_since(since) > kHang) {
      child.end();
      return;
    }
  }
}

}  // namespace

Summary run(const Plan& plan, const Amount& amount) {
  ensure(plan.families.size() <= kMostFamilies, "the board has room for all families");
  is_interrupted = 0;
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    action.sa_handler = interrupt;
    sigaction(signal, &action, nullptr);
  }
  const auto start = Clock::now();
  const auto is_over = [&] { return is_interrupted != 0 || seconds_since(start) > amount.seconds; };
  SharedBoard board;
  Summary summary;
  const std::uint64_t end = amount.first + amount.cases;
  for (std::uint64_t next = amount.first; next < end && !is_over();) {
    const std::uint64_t batch_end = std::min(end, next + kBatch);
    board->current = next;
    Child child([&] { return run_batch(plan, next, batch_end, *board); });
    watch(child, *board, is_over, amount.first);
    next = batch_end;
    if (child.outcome().empty()) continue;
    next = board->current + 1;
    const Case one = case_of(plan, board->current);
    const std::string what = in_child([&] { return judged(plan, one); }, kAlone);
    if (what.empty()) {
      ++summary.slow;
      continue;
    }
    ++board->families[one.family].failures;
    summary.failures.push_back({one, what, small_rows(plan, one, what)});
    print(plan, summary.failures.back());
    if (summary.failures.size() == kMostFailures) break;
  }
  if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r");
  summary.families.assign(
      board->families.begin(),
      board->families.begin() + static_cast<std::ptrdiff_t>(plan.families.size()));
  summary.relations = board->relations;
  summary.seconds = seconds_since(start);
  return summary;
}

}  // namespace plumbline::campaign
