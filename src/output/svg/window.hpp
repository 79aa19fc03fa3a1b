#pragma once

#include <string>

#include "output/svg/kit.hpp"
#include "output/svg/panel.hpp"
#include "plumbline/complex.hpp"

namespace plumbline::svg {

/// An upright box of the plane that a panel shows, however small: `across` is its width; the height
/// follows from the panel.
struct Window {
  Point centre;
  Rational across;
};

/// The window around all vertices, with some room, for a panel of this shape.
Window window_around(const PointList& vertices, const Box& panel);

/// What the window shows of the complex, as SVG elements: faces by depth, edges, vertices as dots,
/// marked cells on top. Clipped in **exact** numbers, so distances below the precision of doubles
/// are seen. Requires: as `panel`; a small complex.
std::string in_window(const ExactComplex& complex, const Window& window, const Box& panel,
                      bool y_up, const Marks& marks);

}  // namespace plumbline::svg
