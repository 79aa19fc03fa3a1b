// The trace of LAR's inters as JSON, with the keys of the original's outputs.

#include <algorithm>

#include "output/json/writer.hpp"
#include "plumbline/engines/inters_show.hpp"

namespace plumbline {
namespace json {
namespace {

using namespace inters;

auto failure(const Failure& f) {
  return object(member("error", f.error), member("message", f.message), member("in", f.function));
}

template <class T>
auto outcome(const Outcome<std::vector<T>>& o)
    -> std::variant<std::span<const T>, decltype(failure(*o.failure))> {
  if (o.value) return std::span<const T>(*o.value);
  return failure(*o.failure);
}

auto model_members(const Model& m) {
  return members(member("V", m.vertices), member("FV", m.faces), member("EV", m.edges));
}

auto model(const Model& m) { return object(model_members(m)); }

auto face_members(const Faces& f) {
  return members(model_members(f.model), member("areas", f.areas), member("aborted", f.aborted));
}

auto intersections(const Trace& t) {
  const auto segment = [](const Fragment& f) { return f.segment; };
  const auto parameters = [](const Fragment& f) { return std::span(f.parameters); };
  return members(member("buckets", t.buckets), member("intersectionPoints", t.intersection_points),
                 member("frags", list(t.fragments, segment)),
                 member("params", list(t.fragments, parameters)));
}

auto one_complex(const Trace& t) {
  const auto cell = [](const VertexPair& v) { return std::span(v).first(v[0] == v[1] ? 1 : 2); };
  return members(
      member("raw", object(member("V", t.raw.vertices), member("EV", t.raw.edges),
                           member("EV_count_with_duplicates", t.raw_edge_count_with_duplicates))),
      member("prune", object(member("V", t.prune.vertices), member("vmap", t.prune.vertex_map),
                             member("clusters", t.prune.clusters), member("close", t.prune.close))),
      member("lar", object(member("V", t.lar.vertices), member("EV", list(t.lar.edges, cell)))));
}

auto all_components(const AllComponents& all) {
  const auto face = [&all](std::size_t f) { return all.faces.model.faces[f]; };
  return object(face_members(all.faces), member("FV_interior", list(all.interior, face)));
}

auto two_complexes(const Trace& t) {
  return members(
      member("components", t.components), member("bridges", t.bridges),
      when(t.largest, [&t] { return member("largest", object(face_members(*t.largest))); }),
      when(t.lar_from_lines || t.components.empty(),
           [&t] { return member("larFromLines", given(t.lar_from_lines, model)); }),
      when(t.all_components,
           [&t] { return member("allComponents", all_components(*t.all_components)); }));
}

auto simple_cycles(const SimpleCycles& s) {
  return object(member("components", s.components), member("latticeArray", s.lattice),
                member("cellsFromCycles", s.cells));
}

auto cycles(const Trace& t) {
  return members(member("boundaryPolylines", list(t.boundary_polylines, outcome<Polyline>)),
                 member("boundaryCycles", list(t.boundary_cycles, outcome<SignedCycle>)),
                 when(t.lattice, [&t] { return member("latticeArray", *t.lattice); }),
                 when(t.cells, [&t] { return member("cellsFromCycles", *t.cells); }),
                 when(t.two_complex, [&t] { return member("twoComplex", model(*t.two_complex)); }),
                 when(t.bridge_edges, [&t] { return member("bridgeEdges", *t.bridge_edges); }),
                 when(t.simple_cycles,
                      [&t] { return member("simpleCycles", simple_cycles(*t.simple_cycles)); }),
                 when(t.faces_lattice, [&t] { return member("facesLattice", *t.faces_lattice); }));
}

bool has_output(const Trace& trace, std::string_view stage) {
  return std::none_of(trace.failures.begin(), trace.failures.end(),
                      [stage](const Failure& failure) { return failure.stage == stage; });
}

auto outputs(const Trace& t) {
  return object(member("boxes", t.boxes), when(has_output(t, "buckets"), [&t] {
                  return members(intersections(t), one_complex(t),
                                 when(has_output(t, "components"),
                                      [&t] { return members(two_complexes(t), cycles(t)); }));
                }));
}

}  // namespace
}  // namespace json

std::string to_json(const inters::Trace& trace) {
  using namespace json;
  const auto error = [](const inters::Failure& f) { return member(f.stage, failure(f)); };
  return document(object(
      member("format", "plumbline lar 1"), member("variant", "published"),
      member("decimals", trace.options.decimals), member("radius", trace.options.radius),
      member("input", object(member("lines", trace.lines))), member("outputs", outputs(trace)),
      member("errors", object(each(trace.failures, error)))));
}

}  // namespace plumbline
