#pragma once

#include <string>
#include <vector>

#include "output/features/dxf_text.hpp"

namespace plumbline::features {

/// A row of the table of layers.
struct DxfLayer {
  std::string name;     ///< legal
  std::int64_t colour;  ///< AutoCAD's colour index
};

/// What a DXF R2000 file has around its entities.
struct DxfFrame {
  std::string comment;
  std::int64_t unit = 0;  ///< $INSUNITS
  PointD least, greatest;
  std::vector<DxfLayer> layers;  ///< "0" may be among them
};

/// The colour of what is white on black and black on white.
inline constexpr std::int64_t kWhiteOrBlack = 7;

/// Handle of the block that entities of the model space belong to.
inline constexpr const char* kModelSpace = "1F";

/// The whole file. Takes the handles for layers from `entities`.
std::string dxf_file(const DxfFrame& frame, Groups entities);

}  // namespace plumbline::features
