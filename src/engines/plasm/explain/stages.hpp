#pragma once

#include <string>

namespace plumbline::plasm {

/// The stages, by which attribution names them.
enum class Stage {
  Transform,
  Fragment,
  Merge,
  ComponentFilter,
  EdgeOrder,
  FaceWalk,
  OuterFace,
  Nesting
};
std::string to_text(Stage stage);
/// Throws: Error Internal for another text.
Stage stage_of(const std::string& text);

}  // namespace plumbline::plasm
