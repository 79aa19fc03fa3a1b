#pragma once

#include "plumbline/engine.hpp"
#include "plumbline/engines/plasm.hpp"

namespace plumbline::plasm {

/// The edges of a graph as line work; vertices of no edge are none.
LineWork line_work(const Graph& graph);
/// What goes into the faces: the edges of the merged graph that are in a component; where there is
/// no result all of them.
LineWork kept_work(const Trace& trace);

/// The result, right or wrong, edges with their sources; where there is none the merged graph
/// without faces. In canonical order.
FloatComplex result_complex(const Trace& trace);

}  // namespace plumbline::plasm
