#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "output/patch/dxf_text.hpp"

namespace plumbline::patch {

/// What new entities and layers of a DXF text need to know of it.
struct DxfNames {
  bool is_modern = false;           ///< from R13 on: entities have handles, owners and subclasses
  std::uint64_t next_handle = 1;    ///< greater than all that there are
  std::optional<DxfGroup> seed;     ///< the value of $HANDSEED
  std::string model_space;          ///< handle of its block record
  std::optional<DxfRecord> layer;   ///< one of the table, to go by
  std::optional<DxfRecord> layers;  ///< the table
  std::optional<DxfRecord> layers_end;  ///< its end
  bool has_virtual_layer = false;
  std::string dashed;  ///< a line type of dashes, else one of whole lines
};

DxfNames dxf_names(const DxfText& file);

/// Upper case digits.
std::string hex(std::uint64_t value);

}  // namespace plumbline::patch
