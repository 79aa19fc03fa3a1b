#pragma once

#include <string>

namespace plumbline::inters {

/// The stages of the pipeline, by which attribution names them.
enum class Stage {
  Transform,
  Quantise,  ///< coordinates rounded to fixed decimals
  Bucket,    ///< segments that meet share no bucket
  Intersect,
  Prune,
  Simplify,         ///< edges kept that became a point
  ComponentFilter,  ///< bridges, dangling edges, components left out
  EdgeOrder,
  FaceWalk,
  OuterFace,
  Nesting
};
std::string to_text(Stage stage);
/// Throws: Error Internal for another text.
Stage stage_of(const std::string& text);

}  // namespace plumbline::inters
