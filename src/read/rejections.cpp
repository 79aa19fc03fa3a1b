#include "read/rejections.hpp"

#include <utility>

#include "geometry/rejected.hpp"

namespace plumbline {

void Rejections::add(const Source& source, const std::string& reason, const std::string& text,
                     bool harmless) {
  if (listed_.size() < kListed) {
    listed_.push_back(make_rejected(source, reason, text, harmless));
    return;
  }
  const bool too_many = unlisted_.size() >= kReasons && !unlisted_.contains(reason);
  Unlisted& unlisted = unlisted_[too_many ? "for other reasons" : reason];
  if (unlisted.count++ == 0) unlisted.first = source;
  unlisted.harmless = unlisted.harmless && harmless;
}

std::vector<Rejected> Rejections::finish() && {
  for (auto& [reason, unlisted] : unlisted_) {
    const std::string count = std::to_string(unlisted.count);
    listed_.push_back(make_rejected(unlisted.first, reason, count + " more like this from here on",
                                    unlisted.harmless));
  }
  return std::move(listed_);
}

}  // namespace plumbline
