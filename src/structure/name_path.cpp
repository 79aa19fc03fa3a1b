#include "structure/name_path.hpp"

#include "plumbline/structure.hpp"

namespace plumbline {

void NamePath::push(const std::string& name) {
  constexpr const char* kEllipsis = "/...";
  lengths_.push_back(text_.size());
  if (name.empty() || full_) return;
  if (text_.size() + 1 + name.size() > kMaxPathText) {
    text_ += kEllipsis;
    full_ = true;
    return;
  }
  if (!text_.empty()) text_ += '/';
  text_ += name;
}

void NamePath::pop() {
  if (text_.size() != lengths_.back()) full_ = false;
  text_.resize(lengths_.back());
  lengths_.pop_back();
}

}  // namespace plumbline
