#!/usr/bin/env python3
"""Has other programs read what Plumbline writes, and compares number by number.

Usage: read_by_others.py PLUMBLINE DRAWING...
Prints a Markdown page; exit code 1 if anything differs. Everything is compared with the GeoJSON file, whose numbers are
read with Python's json, and this with the exact complex of `arrange -o drawing.json`.
"""
import collections
import csv
import fractions
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import ezdxf
import pyogrio
import shapely

F = fractions.Fraction
CELLS = ["faces", "edges", "vertices"]


class Wrong(Exception):
    pass


def demand(condition, what):
    if not condition:
        raise Wrong(what)


def run(*command):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=600,
                            env=os.environ | {"QT_QPA_PLATFORM": "offscreen"})
    demand(result.returncode == 0, f"{pathlib.Path(str(command[0])).name} {command[1]}: {result.stderr[-300:]}")
    return result.stdout


def twice_area(ring):
    """Exact, of a ring of doubles whose first point is repeated."""
    points = [(F(x), F(y)) for x, y in ring]
    return sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(points, points[1:]))


def area_of(rings):
    """Holes run the other way."""
    return sum(map(twice_area, rings)) / 2


def rounding_bound(rings):
    """By how much the area can differ where every coordinate was rounded to the nearest double: per side, the strip that
    it can sweep."""
    half = max(F(math.ulp(c)) for ring in rings for point in ring for c in point) / 2
    sides = [(p, q) for ring in rings for p, q in zip(ring, ring[1:])]
    return sum(half * (abs(F(p[0]) - F(q[0])) + abs(F(p[1]) - F(q[1])) + 2 * half) for p, q in sides)


def from_least(ring):
    points = [tuple(p) for p in ring[:-1]]
    least = points.index(min(points))
    return tuple(points[least:] + points[:least])


def undirected(ring):
    return min(from_least(ring), from_least(ring[::-1]))


def segment(p, q):
    return (min(tuple(p), tuple(q)), max(tuple(p), tuple(q)))


def polygon_key(rings):
    return tuple(sorted(map(undirected, rings)))


def key_of_shape(shape):
    return polygon_key([ring.coords[:] for ring in [shape.exterior, *shape.interiors]])


class Files:
    """All formats of one drawing, in a folder."""

    def __init__(self, program, drawing, folder):
        self.program, self.drawing, self.folder = program, drawing, pathlib.Path(folder)
        self.exact = json.loads(self.write("exact.json", []).read_text())
        self.geojson = {}
        for cells in CELLS:
            text = self.write(f"{cells}.geojson", ["--cells", cells]).read_text()
            self.note = json.loads(text)["numbers"]
            self.geojson[cells] = [(f["geometry"]["coordinates"], f["properties"]) for f in json.loads(text)["features"]]
        self.is_same = "same incidences" in self.note
        self.rounded = self.write("rounded.lines", ["--safe"])
        self.edges = {segment(*points) for points, _ in self.geojson["edges"]}
        self.polygons = collections.Counter(polygon_key(rings) for rings, _ in self.geojson["faces"])

    def write(self, name, options):
        run(self.program, "arrange", self.drawing, "--lenient", *options, "-o", self.folder / name)
        return self.folder / name

    def signature(self, file):
        return re.search(r"signature (\w+)", run(self.program, "arrange", file, "--lenient"))[1]

    def check(self, file, *options):
        run(self.program, "check", self.rounded, "--against", file, *options)


def geojson(files):
    same = files.is_same
    exact = collections.Counter(f["area"] for f in files.exact["faces"][1:])
    faces = files.geojson["faces"]
    if same:
        demand(collections.Counter(p["area_exact"] for _, p in faces) == exact, "areas are not those of the complex")
        demand(len(files.edges) == len(files.exact["edges"]), "edges are missing")
    for rings, properties in faces:
        demand(shapely.Polygon(rings[0], rings[1:]).is_valid, "a polygon is invalid")
        area = F(properties["area_exact"])
        demand(properties["area"] == area.numerator / area.denominator, "area is not the double nearest to area_exact")
        off = abs(area_of(rings) - area)
        demand(off <= (rounding_bound(rings) if same else 0), "the polygon has another area")
    if faces:  # a file without features claims nothing
        files.check(files.folder / "faces.geojson", "--tolerance", "0")
    files.check(files.folder / "edges.geojson", "--tolerance", "0")
    by_gdal = shapely.from_wkb(pyogrio.raw.read(files.folder / "faces.geojson")[2])
    demand(collections.Counter(map(key_of_shape, by_gdal)) == files.polygons, "GDAL reads other polygons")


def wkt_csv_wkb(files):
    for kind, parse in [("wkt", shapely.from_wkt), ("wkb", shapely.from_wkb)]:
        lines = files.write(f"f.{kind}", ["--cells", "faces"]).read_text().split("\n")[:-1]
        shapes = [parse(line) for line in lines]
        demand(all(map(shapely.is_valid, shapes)), f"a polygon of .{kind} is invalid")
        demand(collections.Counter(map(key_of_shape, shapes)) == files.polygons, f"other polygons in .{kind}")
        if shapes:
            files.check(files.folder / f"f.{kind}", "--tolerance", "0")
    csv.field_size_limit(1 << 30)
    with open(files.write("f.csv", ["--cells", "edges"]), newline="", encoding="utf-8") as text:
        rows = list(csv.DictReader(text))
    demand({segment(*shapely.from_wkt(row["wkt"]).coords) for row in rows} == files.edges, "other edges in .csv")


def segments_of(entity):
    if entity.dxftype() == "LINE":
        return [(entity.dxf.start.vec2, entity.dxf.end.vec2)]
    points = [(x, y) for x, y in entity.get_points("xy")]
    return list(zip(points, points[1:] + points[:1] if entity.closed else points[1:]))


def dxf(files):
    path = files.write("e.dxf", [])
    document = ezdxf.readfile(path)
    auditor = document.audit()
    demand(not auditor.errors, f"ezdxf: {auditor.errors[:1]}")
    demand(not auditor.fixes, f"ezdxf mends: {auditor.fixes[:1]}")
    drawn = [segment(p, q) for e in document.modelspace() for p, q in segments_of(e)]
    demand(len(drawn) == len(files.edges) and set(drawn) == files.edges, "ezdxf reads other edges")
    lines = shapely.from_wkb(pyogrio.raw.read(path)[2])
    drawn = {segment(p, q) for line in lines for p, q in zip(line.coords, line.coords[1:])}
    demand({segment(p[:2], q[:2]) for p, q in drawn} == files.edges, "GDAL reads other edges")
    back = files.folder / "back.lines"
    run(files.program, "arrange", path, "--safe", "-o", back)
    demand(back.read_bytes() == files.rounded.read_bytes(), "Plumbline reads another complex")
    all_cells = files.write("all.dxf", ["--cells", "faces,edges,vertices"])
    auditor = ezdxf.readfile(all_cells).audit()
    demand(not auditor.errors and not auditor.fixes, "ezdxf: faces and vertices")
    layers = {properties["layers"].split("; ")[0] for _, properties in files.geojson["edges"]}
    return f"{len(document.modelspace())} entities, {len(layers)} layers"


def librecad(files):
    if not shutil.which("librecad"):
        return "not installed"
    picture = files.folder / "e.pdf"
    run("librecad", "dxf2pdf", "-o", picture, files.folder / "e.dxf")
    demand(picture.exists() and picture.stat().st_size > 0, "LibreCAD makes no picture")
    return f"{picture.stat().st_size} bytes"


def topojson(files):
    path = files.write("f.topojson", [])
    topology = json.loads(path.read_text())
    shapes = shapely.from_wkb(pyogrio.raw.read(path, layer="faces")[2])
    demand(all(map(shapely.is_valid, shapes)), "GDAL reads an invalid polygon")
    demand(collections.Counter(map(key_of_shape, shapes)) == files.polygons, "GDAL reads other polygons of .topojson")
    path = files.write("all.topojson", ["--cells", "faces,edges,vertices"])
    lines = shapely.from_wkb(pyogrio.raw.read(path, layer="edges")[2])
    demand({segment(*line.coords) for line in lines} == files.edges, "GDAL reads other edges of .topojson")
    return f"{len(topology['arcs'])} arcs"


def obj(files):
    points, areas, lines = [], [], set()
    for row in files.write("f.obj", []).read_text().split("\n"):
        kind, _, rest = row.partition(" ")
        if kind == "v":
            points.append(tuple(map(float, rest.split()[:2])))
        elif kind == "g" and rest.startswith("face"):
            areas.append(F(0))
        elif kind in "lf" and kind:
            corners = [points[int(i) - 1] for i in rest.split()]
            if kind == "l":
                lines.add(segment(*corners))
            else:
                areas[-1] += twice_area(corners + corners[:1]) / 2
    demand(lines == files.edges, "other edges in .obj")
    demand(areas == [area_of(rings) for rings, _ in files.geojson["faces"]], "triangles do not fill the faces")


def lar(files):
    path = files.write("m.lar.json", [])
    model = json.loads(path.read_text())
    demand(len(model["V"]) == len(files.exact["vertices"]), "vertices of LAR")
    demand(len(model["EV"]) == len(files.exact["edges"]), "edges of LAR")
    demand(len(model["FV"]) == len(files.exact["faces"]) - 1, "faces of LAR")
    if files.is_same:  # as the doubles that check reads are the same complex
        run(files.program, "check", files.drawing, "--lenient", "--against", path)
    rounded = files.write("rounded.lar.json", ["--safe"])
    files.check(rounded, "--tolerance", "0")
    demand(files.signature(path) == files.signature(files.drawing), "Plumbline reads another complex of LAR")


def lines(files):
    path = files.write("e.lines", [])
    if files.signature(path) == files.signature(files.drawing):
        return "exact"
    demand(path.read_bytes() == files.rounded.read_bytes(), "other edges in .lines")
    return "rounded"


STEPS = [geojson, wkt_csv_wkb, dxf, librecad, topojson, obj, lar, lines]


def main(program, drawings):
    print(HEAD.format(ezdxf=ezdxf.__version__, gdal=pyogrio.__gdal_version_string__, shapely=shapely.__version__,
                      geos=shapely.geos_version_string))
    print("| drawing | vertices | edges | faces | numbers | " + " | ".join(s.__name__ for s in STEPS) + " |")
    print("| --- | --- | --- | --- | --- |" + " --- |" * len(STEPS))
    failed = False
    for drawing in drawings:
        with tempfile.TemporaryDirectory() as folder:
            try:
                files = Files(program, drawing, folder)
            except (Wrong, subprocess.TimeoutExpired) as problem:
                failed = True
                print(f"| {pathlib.Path(drawing).name} | **{problem}** |".replace("\n", " "), flush=True)
                continue
            words = []
            for step in STEPS:
                try:
                    words.append(step(files) or "same")
                except (Wrong, subprocess.TimeoutExpired) as problem:
                    failed = True
                    words.append(f"**{problem}**")
            counts = [len(files.exact[cells]) for cells in ["vertices", "edges", "faces"]]
            row = [pathlib.Path(drawing).name, *counts, files.note.split(",")[0].split(":")[0], *words]
            print("| " + " | ".join(str(word).replace("|", "\\|").replace("\n", " ") for word in row) + " |", flush=True)
    return 1 if failed else 0


HEAD = """# What is written, read by others

Made by `validation/writers/run DRAWING...` with ezdxf {ezdxf}, GDAL {gdal}, Shapely {shapely} (GEOS {geos}) and LibreCAD.
Each drawing is written in all formats. *Same* is exact, coordinate by coordinate:

- *geojson*: Shapely calls every polygon valid. Where the rounding kept the incidences, `area_exact` are the areas of the exact
  complex; `area` is the nearest double of it; the exact area of the polygon's own doubles differs from it by no more
  than rounding its corners can make, else not at all. `check --against` at tolerance 0 agrees with the rounded complex, on
  faces and on edges; GDAL reads the same polygons.
- *wkt_csv_wkb*: Shapely reads the polygons and edges of the GeoJSON file, valid; `check --against` agrees at tolerance 0.
- *dxf*: ezdxf's audit has no error and mends nothing, with edges and with faces and vertices; ezdxf and GDAL read the edges of
  the GeoJSON file; Plumbline reads the identical complex. *librecad*: it makes a picture of them, a PDF file.
- *topojson*: GDAL reads the same polygons, valid, and edges. *obj*: triangles add up to the faces, exactly.
- *lar*: as many cells as the exact complex; Plumbline reads the identical exact complex; where the rounding kept the
  incidences, `check --against` agrees, and of the rounded complex always, at tolerance 0.
- *lines*: Plumbline reads the identical complex, exact or rounded.
"""

if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2:]))
