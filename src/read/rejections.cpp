#include "read/rejections.hpp"

#include <utility>

#include "geometry/rejected.hpp"

namespace plumbline {

void Rejections::add(const Source& source, const std::string& reason, const std::string& text) {
  if (listed_.size() < kListed) {
    listed_.push_back(make_rejected(source, reason, text));
    return;
  }
  const bool too_many = more_.size() >= kReasons && !more_.contains(reason);
  More& more = more_[too_many ? "for other reasons" : reason];
  if (more.count++ == 0) more.first = source;
}

std::vector<Rejected> Rejections::finish() && {
  for (auto& [reason, more] : more_) {
    const std::string count = std::to_string(more.count);
    listed_.push_back(make_rejected(more.first, reason, count + " more like this from here on"));
  }
  return std::move(listed_);
}

}  // namespace plumbline
