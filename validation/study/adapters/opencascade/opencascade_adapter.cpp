// OpenCASCADE: lines as edges, fused (General Fuse), joined to wires, wires to faces.
#include <BOPAlgo_Builder.hxx>
#include <BOPAlgo_Tools.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pnt.hxx>

#include <sstream>

#include "adapter.hpp"

namespace {

using study::Clock;
using study::Edge;
using study::Model;
using study::Numbering;
using study::Ring;

std::int64_t numbered(const TopoDS_Vertex& vertex, Numbering& number) {
  const gp_Pnt p = BRep_Tool::Pnt(vertex);
  return number({p.X(), p.Y()});
}

std::vector<Edge> edges_of(const TopoDS_Shape& shape, Numbering& number) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  std::vector<Edge> result;
  for (int i = 1; i <= edges.Extent(); ++i) {
    TopoDS_Vertex a;
    TopoDS_Vertex b;
    TopExp::Vertices(TopoDS::Edge(edges(i)), a, b);
    if (a.IsNull() || b.IsNull()) continue;  // it leaves edges of no length without vertices
    result.push_back({numbered(a, number), numbered(b, number)});
  }
  return study::each_once(std::move(result));
}

Ring ring_of(const TopoDS_Wire& wire, Numbering& number) {
  Ring ring;
  for (BRepTools_WireExplorer at(wire); at.More(); at.Next())
    ring.push_back(numbered(at.CurrentVertex(), number));
  return ring;
}

std::vector<std::vector<Ring>> polygons_of(const TopoDS_Shape& faces, Numbering& number) {
  std::vector<std::vector<Ring>> result;
  for (TopExp_Explorer at(faces, TopAbs_FACE); at.More(); at.Next()) {
    const TopoDS_Face& face = TopoDS::Face(at.Current());
    const TopoDS_Wire outer = BRepTools::OuterWire(face);
    result.push_back({ring_of(outer, number)});
    for (TopExp_Explorer wire(face, TopAbs_WIRE); wire.More(); wire.Next()) {
      if (wire.Current().IsSame(outer)) continue;
      Ring ring = ring_of(TopoDS::Wire(wire.Current()), number);
      if (ring.size() > 2)
        result.back().push_back(std::move(ring));  // else an edge within the face
    }
  }
  return result;
}

Model fused(const std::vector<study::Segment>& segments, Clock& clock, double fuzzy) {
  if (segments.empty()) return {{}, {}, std::vector<std::vector<Ring>>()};
  if (segments.size() == 1) {  // it wants two or more
    return {{segments[0][0], segments[0][1]}, {{0, 1}}, std::vector<std::vector<Ring>>()};
  }
  clock.start();
  BOPAlgo_Builder builder;
  for (const study::Segment& s : segments) {
    builder.AddArgument(
        BRepBuilderAPI_MakeEdge(gp_Pnt(s[0][0], s[0][1], 0), gp_Pnt(s[1][0], s[1][1], 0)).Edge());
  }
  builder.SetFuzzyValue(fuzzy);
  builder.Perform();
  if (builder.HasErrors()) {
    std::ostringstream said;
    builder.DumpErrors(said);
    throw study::EngineError("BOPAlgo_Builder", said.str());
  }
  TopoDS_Shape wires;
  TopoDS_Shape faces;
  const int status = BOPAlgo_Tools::EdgesToWires(builder.Shape(), wires, Standard_True);
  if (status == 2) throw study::EngineError("EdgesToWires", "sharing of the edges has failed");
  if (status == 0) BOPAlgo_Tools::WiresToFaces(wires, faces);  // false where there are none
  clock.stop();
  Numbering number;
  Model model;
  model.edges = edges_of(builder.Shape(), number);
  model.polygons.emplace();
  if (!faces.IsNull()) model.polygons = polygons_of(faces, number);
  model.vertices = std::move(number).points();
  return model;
}

// Its fuzzy value is never less than what two points of any shape are told apart by.
Model fused_within(const std::vector<study::Segment>& segments, Clock& clock, double tolerance) {
  if (tolerance < Precision::Confusion()) {
    throw study::BadTolerance("the tolerance of an edge is 1e-7 or more");
  }
  try {
    return fused(segments, clock, tolerance);
  } catch (const Standard_Failure& failure) {
    throw study::EngineError(failure.DynamicType()->Name(), failure.GetMessageString());
  }
}

}  // namespace

int main(int argc, char** argv) {
  return study::serve(
      {"opencascade",
       "OpenCASCADE General Fuse",
       OCC_VERSION_COMPLETE,
       "OpenCASCADE",
       "LGPL-2.1 with exception",
       {
           {"fuzzy-0", "fuzzy 0", "snap", Precision::Confusion(),
            "Boolean Operations: General Fuse with the tolerances of its arguments, 1e-7",
            fused_within, "", "General Fuse, fuzzy value"},
           {"fuzzy-1e-6", "fuzzy 1e-6", "snap", 1e-6,
            "Boolean Operations: fuzzy value, an additional tolerance", fused_within, "",
            "General Fuse, fuzzy value"},
       }},
      argc, argv);
}
