#include "arrange/bucket/job.hpp"

#include <boost/sort/spreadsort/integer_sort.hpp>
#include <utility>

#include "plumbline/error.hpp"

namespace plumbline::bucket {

void throw_too_many() {
  throw Error(ErrorCode::Limit, "an arrangement has less than 2^31 ends and crossings");
}

Job::Job(std::size_t threads, std::function<bool(double)> progress)
    : threads_(threads), progress_(std::move(progress)), caller_(std::this_thread::get_id()) {}

void Job::begin_step(double share) {
  done_ += share_;
  share_ = share;
  tell(0);
}

void Job::sort_integers(std::vector<std::uint64_t>& values) const {
  if (is_parallel()) {
    tbb::parallel_sort(values.begin(), values.end());
  } else {
    boost::sort::spreadsort::integer_sort(values.begin(), values.end());
  }
}

void Job::tell(double done_of_step) {
  if (!progress_ || std::this_thread::get_id() != caller_) return;
  told_ = std::max(told_, std::min(1.0, done_ + share_ * done_of_step));
  if (!progress_(told_)) throw Error(ErrorCode::Cancelled, "cancelled");
}

}  // namespace plumbline::bucket
