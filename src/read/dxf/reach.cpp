#include "read/dxf/reach.hpp"

#include "plumbline/error.hpp"

namespace plumbline::dxf {
namespace {

/// Finds the spaces below the model space, without recursion.
class SpaceSearch {
 public:
  explicit SpaceSearch(const Drawing& drawing, const std::string& file_name)
      : drawing_(drawing), file_name_(file_name), state_(drawing.spaces.size(), State::New) {}

  std::vector<bool> find() && {
    enter(0);
    while (!open_.empty()) {
      auto& [space, next] = open_.back();
      const std::vector<const Reference*>& references = references_.back();
      if (next == references.size()) {
        state_[space] = State::Done;
        open_.pop_back();
        references_.pop_back();
      } else {
        follow(*references[next++]);
      }
    }
    std::vector<bool> reached;
    for (const State state : state_) reached.push_back(state == State::Done);
    return reached;
  }

 private:
  enum class State { New, Open, Done };
  struct Frame {
    std::size_t space;
    std::size_t next;  ///< index into its references
  };

  void enter(std::size_t space) {
    state_[space] = State::Open;
    open_.push_back({space, 0});
    references_.emplace_back();
    for (const auto& layer : drawing_.spaces[space].layers) {
      for (const auto& item : layer.items) {
        if (const Reference* reference = std::get_if<Reference>(&item)) {
          references_.back().push_back(reference);
        }
      }
    }
  }

  void follow(const Reference& reference) {
    const auto block = drawing_.blocks.find(reference.insert.block);
    if (block == drawing_.blocks.end()) return;
    if (state_[block->second] == State::Open) fail(reference, block->second);
    if (state_[block->second] == State::New) enter(block->second);
  }

  [[noreturn]] void fail(const Reference& reference, std::size_t repeated) const {
    std::string path;
    bool inside = false;
    for (const Frame& frame : open_) {
      inside = inside || frame.space == repeated;
      if (inside) path += drawing_.spaces[frame.space].name + "/";
    }
    throw Error(ErrorCode::BadInput, "a block is inserted in itself",
                {file_name_, reference.source.line, 0}, path + drawing_.spaces[repeated].name);
  }

  const Drawing& drawing_;
  const std::string& file_name_;
  std::vector<State> state_;
  std::vector<Frame> open_;
  std::vector<std::vector<const Reference*>> references_;  ///< per frame
};

}  // namespace

std::vector<bool> reached_spaces(const Drawing& drawing, const std::string& file_name) {
  return SpaceSearch(drawing, file_name).find();
}

}  // namespace plumbline::dxf
