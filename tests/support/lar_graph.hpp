#pragma once

#include "plumbline/engines/lar_stages.hpp"
#include "segments.hpp"

namespace plumbline::lar {

inline Graph graph(const std::string& text) { return to_doubles(segments(text), {1e-3}).graph; }

/// Splitting and simplification of drawings without near vertices.
inline Graph split_graph(const std::string& text) {
  const Graph drawn = graph(text);
  const std::vector<Box> boxes = containment_boxes(drawn, 1e-6);
  const Graph split = split_edges(drawn, cut_edges(drawn, boxes, box_buckets(boxes), 1e-6));
  return simplify(split, prune_vertices(split.vertices, 1e-6));
}

}  // namespace plumbline::lar
