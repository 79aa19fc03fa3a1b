#!/usr/bin/env python3
"""Holds `plumbline coverage` against GEOS's CoverageValidator and CoverageCleaner, on random layers of polygons.

Usage: against_shapely.py PLUMBLINE COUNT
Prints a Markdown page; exit code 1 if a layer is a coverage by one of them alone, or what Plumbline makes is none, or does
not cover what the layer covered.
"""
import collections
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

import shapely

SIZE = 4  # of a grid, in cells
CELL = 100
SHOWN = 4


def grid(step, share):
    """Cells of a grid whose corners each cell has for itself, some of them moved by up to `step`."""
    places = {(i, j): (CELL * i + random.randint(-20, 20), CELL * j + random.randint(-20, 20))
              for i in range(SIZE + 1) for j in range(SIZE + 1)}

    def moved(corner):
        x, y = places[corner]
        is_moved = random.random() < share
        return (x + random.randint(-step, step), y + random.randint(-step, step)) if is_moved else (x, y)

    return [[moved(corner) for corner in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]
            for i in range(SIZE) for j in range(SIZE)]


def valid_grid():
    return grid(0, 0)


def small_faults():
    return grid(2, 0.1)


def large_faults():
    return grid(15, 0.5)


def missing_vertices():
    """Rectangles, of which some have vertices in the middle of sides that others lack."""
    cells = []
    for i in range(SIZE):
        for j in range(SIZE):
            corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            cell = []
            for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1]):
                cell.append((CELL * ax, CELL * ay))
                if random.random() < 0.1:
                    cell.append((CELL * (ax + bx) // 2, CELL * (ay + by) // 2))
            cells.append(cell)
    return cells


def triangles(count=6):
    result = []
    while len(result) < count:
        corners = [(random.randint(0, 40), random.randint(0, 40)) for _ in range(3)]
        if shapely.Polygon(corners).area > 0:
            result.append(corners)
    return result


def two_triangles():
    return triangles(2)


FAMILIES = [valid_grid, missing_vertices, two_triangles, triangles, small_faults, large_faults]


def asked(program, polygons):
    """What is wrong, and the clean polygons, by their numbers."""
    with tempfile.TemporaryDirectory() as folder:
        drawing, clean = pathlib.Path(folder, "layer.geojson"), pathlib.Path(folder, "clean.geojson")
        features = [{"type": "Feature", "properties": {}, "geometry": shapely.geometry.mapping(p)} for p in polygons]
        drawing.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
        run = subprocess.run([program, "coverage", drawing, "--clean", "-o", clean, "--json"], capture_output=True, text=True)
        again = subprocess.run([program, "coverage", clean, "-q"])
        if run.returncode != 0:
            sys.exit(run.stderr)
        made = json.loads(clean.read_text())["features"]
    return json.loads(run.stdout), [shapely.geometry.shape(f["geometry"]) for f in made], again.returncode == 0


def nearly(a, b):
    return math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-6)


def vertices(polygons):
    return set(map(tuple, shapely.get_coordinates(polygons)))


def crossings(polygons):
    """All vertices that a clean coverage may have: those of the union of all sides."""
    return vertices([shapely.union_all([p.boundary for p in polygons])])


def moved_from(made, allowed):
    """How many vertices are more than 1e-9 from all that there were."""
    tree = shapely.STRtree([shapely.Point(p) for p in allowed])
    places = [shapely.Point(p) for p in vertices(made)]
    near = tree.query_nearest(places, max_distance=1e-9, all_matches=False) if places else [[]]
    return len(places) - len(set(near[0]))


def look_at(program, polygons, counts):
    """Counts what both say; whether that is as it should be."""
    report, ours, is_clean = asked(program, polygons)
    found = {fault["kind"] for fault in report["faults"]} - {"gap"}
    theirs_valid = bool(shapely.coverage_is_valid(polygons))
    counts["valid"] += theirs_valid
    counts["same verdict"] += theirs_valid == (not found)
    gaps = sum(f["area"] for f in report["changes"] if f["kind"] == "gap")
    covered = shapely.union_all(polygons).area
    is_whole = nearly(sum(p.area for p in ours), covered + gaps)
    counts["clean"] += is_clean and bool(shapely.coverage_is_valid(ours))
    counts["whole"] += is_whole
    allowed = crossings(polygons)
    counts["moved"] += moved_from(ours, allowed) > 0
    theirs = list(shapely.coverage_clean(polygons, gap_width=1e9))
    counts["their clean"] += bool(shapely.coverage_is_valid(theirs))
    counts["their whole"] += nearly(sum(p.area for p in theirs), covered + gaps)
    counts["their moved"] += moved_from(theirs, allowed) > 0
    counts["same areas"] += all(nearly(a.area, b.area) for a, b in zip(ours, theirs))
    counts["layers"] += 1
    return theirs_valid == (not found) and is_clean and is_whole


def main(program, count):
    random.seed(count)
    print("# Layers of polygons as coverages, by GEOS and by Plumbline\n")
    print(f"Made by `validation/coverages/run {count}` with Shapely {shapely.__version__} (GEOS {shapely.geos_version_string}): random layers")
    print("whose corners are integers. *coverage*: GEOS says that neither overlaps nor unmatched vertices are there; *the same verdict*: so")
    print("does Plumbline. Then both give overlaps and gaps of any width to the polygon with the longest border. *clean*: the result is a")
    print("coverage, by GEOS; *whole*: its area is that of the union with the gaps, to 1e-9 of it; *moved*: a vertex is more than 1e-9 from all")
    print("corners and crossings of the layer; *all areas the same*: both chose the same polygons.\n")
    print("| family | layers | coverage | the same verdict | clean: Plumbline, GEOS | whole | moved | all areas the same |")
    print("| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |")
    wrong = []
    for family in FAMILIES:
        counts = collections.Counter()
        for _ in range(count):
            polygons = [shapely.Polygon(corners) for corners in family()]
            if all(p.is_valid for p in polygons) and not look_at(program, polygons, counts):
                wrong.append(shapely.GeometryCollection(polygons).wkt)
        print(f"| {family.__name__.replace('_', ' ')} | {counts['layers']} | {counts['valid']} | {counts['same verdict']} | {counts['clean']}, {counts['their clean']} "
              f"| {counts['whole']}, {counts['their whole']} | {counts['moved']}, {counts['their moved']} | {counts['same areas']} |")
    print(f"\n{len(wrong)} layers are coverages by one of them alone, or made into what is none or covers something else by Plumbline.")
    for text in wrong[:SHOWN]:
        print(f"\n    {text}")
    pair = [shapely.Polygon([(1, 0), (1, 1), (1, 3), (4, 0)]), shapely.Polygon([(0, 4), (1, 3), (1, 0)])]
    _, ours, _ = asked(program, pair)
    theirs = [p.area for p in shapely.coverage_clean(pair)]
    print(f"\nThe triangles of GEOS #1525 have areas {[p.area for p in pair]}; clean {[p.area for p in ours]} by Plumbline, {theirs} by GEOS.")
    return 1 if wrong else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], int(sys.argv[2])))
