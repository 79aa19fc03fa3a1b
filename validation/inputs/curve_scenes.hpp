#pragma once

#include <cstdint>
#include <string>

namespace plumbline::inputs {

/// A drawing of lines and curves that closes, as a program prints it that computes in doubles, and
/// how many faces it has, the unbounded one too, if every curve meets what it was drawn to meet.
/// Nothing dangles.
struct CurveScene {
  std::string name;  ///< what is drawn and how, e.g. "fillets, mirrored arcs"
  std::string file;  ///< "scene.dxf" or "scene.svg"
  std::string text;
  std::size_t faces;
};

/// The scene of this number, the same on every machine: sectors, rings, fillets, slots, columns
/// with walls, doors, lenses, tangents, crossing circles, bays of an ellipse; turned, scaled and
/// moved; their numbers printed with 15 to 17 digits; as lines and ARCs, mirrored ARCs, bulges, in
/// a turned block, or in SVG.
CurveScene curve_scene(std::uint64_t number);

}  // namespace plumbline::inputs
