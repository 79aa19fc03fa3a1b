"""CDT: a constrained Delaunay triangulation that resolves crossing constraints.

Edges are its fixed edges; faces are its triangles, joined across edges that are not fixed.
"""

from __future__ import annotations

from importlib.metadata import version

import numpy as np
import pythoncdt as cdt
from study_adapter import (
    Clock,
    Configuration,
    Engine,
    Floats,
    Ints,
    Model,
    edges_once,
    endpoints,
    serve,
)
from triangle_faces import faces_of_triangles


def resolved(segments: Floats, clock: Clock, distance: float | None) -> Model:
    """`distance` is CDT's min_dist_to_constraint_edge."""
    points, pairs = endpoints(segments)
    constraints = np.array(edges_once(pairs), dtype=np.uintc).reshape(-1, 2)
    if not len(constraints):
        return {"V": [], "EV": [], "polygons": []}
    with clock:
        t = cdt.Triangulation(
            cdt.VertexInsertionOrder.AUTO,
            cdt.IntersectingConstraintEdges.TRY_RESOLVE,
            distance,
        )
        t.insert_vertices(points)
        t.insert_edges(constraints)
        t.erase_super_triangle()
    return _model(t)


def _model(t: cdt.Triangulation) -> Model:
    records = t.vertices_array()
    vertices = np.stack([records["x"], records["y"]], axis=1)
    triangles: Ints = t.triangles_array()["vertices"].astype(np.int64)
    fixed = edges_once(np.array([(e.v1, e.v2) for e in t.fixed_edges_iter()], dtype=np.int64))
    return {
        "V": vertices.tolist(),
        "EV": fixed,
        "polygons": faces_of_triangles(vertices, triangles, fixed),
    }


CONFIGURATIONS = [
    Configuration(
        "try-resolve",
        "TRY_RESOLVE",
        ("none", 0),
        "CDT: TRY_RESOLVE is its way to take constraints that cross",
        resolved,
    ),
    Configuration(
        "try-resolve-1e-9",
        "TRY_RESOLVE, vertices within 1e-9 on edges",
        ("snap", 1e-9),
        "CDT, minDistToConstraintEdge: 'distance within which point is considered to be lying "
        "on a constraint edge'",
        resolved,
        promise="some",  # nothing of vertices that are near each other
        way="TRY_RESOLVE, vertices near edges on them",
    ),
]

if __name__ == "__main__":
    serve(
        Engine("cdt", "CDT", version("pythoncdt"), "CDT", "MPL-2.0", CONFIGURATIONS),
    )
