#pragma once

#include <string>

namespace plumbline::lar {

/// The stages of the pipeline, by which attribution names them.
enum class Stage { Transform, Intersect, Prune, EdgeOrder, FaceWalk, OuterFace, Nesting };
std::string to_text(Stage stage);
/// Throws: Error Internal for another text.
Stage stage_of(const std::string& text);

}  // namespace plumbline::lar
