#!/usr/bin/env python3
"""Compares what Plumbline reads from DXF files with what ezdxf reads, segment by segment.

Usage: dxf_against_ezdxf.py PLUMBLINE_SEGMENTS DIRECTORY. Prints a Markdown table of the DXF files
below DIRECTORY; if DIRECTORY/index.json counts their segments, with its counts. Exit code 1 if something
that Plumbline is to draw differs or an index has another count than straight + zero length + not drawn -
only in Plumbline. Needs Debian's python3-ezdxf, python3-shapely and python3-scipy.

Straight segments are matched one to one, ends within 1e-9 of the drawing's size. Curves are compared as
point sets: no end of a chord may be further from ezdxf's curve, and no point of ezdxf's curve further
from the chords, than CURVE of the drawing's size; both are flattened to FINE. Inserts are followed by
ezdxf's matrices, which its explosion of arrays and of sheared blocks within blocks contradicts.
"""

import collections
import json
import logging
import math
import pathlib
import subprocess
import sys
import warnings

import ezdxf
import ezdxf.math
import ezdxf.recover
import numpy
import scipy.spatial
import shapely.geometry
import shapely.strtree

SAME = 1e-9
CURVE = 1e-4
FINE = 1e-5  # blocks may be enlarged

STRAIGHT = {"LINE", "SOLID", "TRACE", "3DFACE"}
CURVED = {"ARC", "CIRCLE", "ELLIPSE", "SPLINE"}
COMPOSED = {"LWPOLYLINE", "POLYLINE"}
TILTED = " not in the plane"


class Reading:
    """Segments and curves of a drawing, with the type of the entity that they came from."""

    def __init__(self):
        self.segments = []  # (origin, (ax, ay, bx, by))
        self.curves = []  # (origin, points)


def is_flat(entity):
    """Whether Plumbline can draw the entity: its extrusion is along z."""
    if entity.dxftype() in ("LINE", "3DFACE", "SPLINE"):
        return True
    extrusion = entity.dxf.get("extrusion", (0, 0, 1))
    return extrusion[0] == 0 and extrusion[1] == 0


def explode(entity, matrix, origin, size, reading):
    """Adds what the entity draws below the map: inserts with their blocks, annotation by its parts."""
    kind = entity.dxftype()

    def add_segment(a, b, origin):
        (a, b) = matrix.transform_vertices([a, b])
        reading.segments.append((origin or kind, (a.x, a.y, b.x, b.y)))

    if kind == "INSERT":
        for copy in entity.multi_insert() if entity.mcount > 1 else [entity]:
            for part in copy.block() or []:
                explode(part, copy.matrix44() * matrix, origin, size, reading)
    elif kind == "LINE":
        add_segment(entity.dxf.start, entity.dxf.end, origin)
    elif kind in STRAIGHT:
        points = list(entity.wcs_vertices())
        for a, b in zip(points, points[1:] + points[:1]):
            add_segment(a, b, origin)
    elif kind in COMPOSED:
        inside = origin or (kind if is_flat(entity) else kind + TILTED)
        parts = list(entity.virtual_entities())
        if entity.is_closed and parts[-1].dxftype() == "LINE" and parts[-1].dxf.start == parts[-1].dxf.end:
            parts.pop()  # ezdxf closes again what ends at its start
        for part in parts:
            explode(part, matrix, inside, size, reading)
    elif kind in CURVED:
        points = matrix.transform_vertices(flattened(entity, size * FINE))
        reading.curves.append((origin or kind, [(p.x, p.y) for p in points]))
    elif kind != "POINT" and hasattr(entity, "virtual_entities"):  # annotation
        for part in entity.virtual_entities():
            explode(part, matrix, origin or kind, size, reading)


def flattened(entity, distance):
    if entity.dxftype() == "SPLINE" and not entity.control_points:
        return entity.construction_tool().flattening(distance)
    return entity.flattening(distance)


def open_with_ezdxf(file):
    """The document, and a list of its model space and blocks."""
    if pathlib.Path(file).read_bytes().startswith(b"AutoCAD Binary DXF"):
        document = ezdxf.readfile(file)
    else:
        document, _ = ezdxf.recover.readfile(file)
    spaces = list(document.blocks) + [document.modelspace()]
    for space in spaces:
        for insert in space.query("INSERT"):
            if insert.dxf.get("zscale", 1) == 0:  # right for a flat drawing, but ezdxf inverts it
                insert.dxf.zscale = 1
    return document, spaces


def read_with_ezdxf(file, size):
    """What Plumbline is to draw, and by type the count of the segments of what it is not to draw."""
    document, spaces = open_with_ezdxf(file)

    def reading():
        result = Reading()
        for entity in document.modelspace():
            explode(entity, ezdxf.math.Matrix44(), None, size, result)
        return result

    kinds = sorted({entity.dxftype() for space in spaces for entity in space})
    current = reading()
    not_drawn = collections.Counter()
    for kind in kinds:
        if kind in STRAIGHT | CURVED | COMPOSED | {"INSERT", "MLINE"}:
            continue
        for space in spaces:
            for entity in list(space.query(kind)):
                space.delete_entity(entity)
        rest = reading()
        if len(rest.segments) < len(current.segments):
            not_drawn[kind] = len(current.segments) - len(rest.segments)
        current = rest
    return current, not_drawn


def read_with_plumbline(program, file, tolerance):
    run = subprocess.run([program, file, f"{tolerance:.12f}"], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise RuntimeError(run.stderr.strip())
    segments, rejected = [], []
    for line in run.stdout.splitlines():
        words = line.split(maxsplit=3)
        if words[0] == "segment":
            segments.append((words[1], tuple(float(x) for x in words[3].split())))
        else:
            rejected.append((words[1], words[3]))
    return segments, rejected


def size_of(segments):
    xs = [x for _, s in segments for x in s[0::2]] or [0, 1]
    ys = [y for _, s in segments for y in s[1::2]] or [0, 1]
    return max(max(xs) - min(xs), max(ys) - min(ys)) or 1


def match(ours, theirs, size):
    """Pairs of equal segments, greatest distance first; what remains of both."""
    if not ours or not theirs:
        return 0, 0.0, list(ours), list(theirs)
    tree = scipy.spatial.cKDTree(numpy.array([s for _, s in ours]))
    used = [False] * len(ours)
    left, worst, pairs = [], 0.0, 0
    for origin, (ax, ay, bx, by) in theirs:
        best = None
        for candidate in ((ax, ay, bx, by), (bx, by, ax, ay)):
            for i in tree.query_ball_point(candidate, 2 * SAME * size):
                distance = math.dist(ours[i][1], candidate)
                if not used[i] and (best is None or distance < best[0]):
                    best = (distance, i)
        if best is None:
            left.append((origin, (ax, ay, bx, by)))
        else:
            used[best[1]] = True
            worst = max(worst, best[0])
            pairs += 1
    return pairs, worst, [s for s, u in zip(ours, used) if not u], left


def farthest(points, lines):
    """The largest distance of a point from the nearest of the lines."""
    if not points or not lines:
        return 0.0 if not points else math.inf
    tree = shapely.strtree.STRtree(lines)
    worst = 0.0
    for p in points:
        point = shapely.geometry.Point(p)
        worst = max(worst, point.distance(tree.nearest(point)))
    return worst


def compare(program, file):
    first, _ = read_with_plumbline(program, file, 0)
    size = size_of(first)
    ours, rejected = read_with_plumbline(program, file, size * FINE)
    theirs, not_drawn = read_with_ezdxf(file, size)
    straight = [s for s in theirs.segments if s[1][:2] != s[1][2:]]
    pairs, worst, extra, missing = match(ours, straight, size)
    only_ours = [s for s in extra if s[0] in STRAIGHT | {"MLINE"}]
    extra = [s for s in extra if s[0] not in STRAIGHT | {"MLINE"}]
    curves = [points for origin, points in theirs.curves if not origin.endswith(TILTED)]
    chords = [shapely.geometry.LineString([s[:2], s[2:]]) for _, s in extra]
    pieces = [shapely.geometry.LineString(pair) for points in curves for pair in zip(points, points[1:])]
    tilted = sum(1 for origin, _ in missing if origin.endswith(TILTED))
    if tilted:
        not_drawn["POLYLINE" + TILTED] = tilted
    return {
        "index": len(theirs.segments) - tilted + sum(not_drawn.values()),
        "straight": pairs + len(only_ours),
        "zero": sum(1 for _, reason in rejected if reason == "zero-length segment"),
        "their_zero": len(theirs.segments) - len(straight),
        "worst": worst / size,
        "missing": len(missing) - tilted,
        "only_ours": collections.Counter(kind for kind, _ in only_ours),
        "not_drawn": not_drawn,
        "chords": len(first) - pairs - len(only_ours),
        "off_curve": farthest([p for _, s in extra for p in (s[:2], s[2:])], pieces) / size,
        "off_chords": farthest([p for points in curves for p in points], chords) / size,
    }


def is_explained(result, index_count):
    return (result["missing"] == 0 and result["zero"] == result["their_zero"]
            and result["off_curve"] <= CURVE and result["off_chords"] <= CURVE
            and index_count in (None, result["index"]))


def listed(counter):
    return ", ".join(f"{count} of {kind}" for kind, count in sorted(counter.items()))


def main():
    logging.disable(logging.CRITICAL)
    warnings.simplefilter("ignore")  # Shapely announces its version 2
    program, directory = sys.argv[1:] if len(sys.argv) == 3 else sys.exit(__doc__)
    directory = pathlib.Path(directory)
    index_file = directory / "index.json"
    counts = {}
    if index_file.exists():
        counts = {f["file"]: f["segments"] for f in json.loads(index_file.read_text())["files"]}
    print("| file | index | straight | zero length | not drawn | only in Plumbline | chords | farthest end "
          "| chords off curve | curve off chords | |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    good = True
    for file in sorted(f for f in directory.rglob("*") if f.suffix.lower() == ".dxf"):
        name = file.relative_to(directory).as_posix()
        try:
            r = compare(program, str(file))
        except RuntimeError as error:
            print(f"| `{file.name}` | refused: {error} |")
            good = False
            continue
        verdict = "equal" if is_explained(r, counts.get(name)) else "**DIFFERENT**"
        good &= verdict == "equal"
        print(f"| `{file.name}` | {counts.get(name, '')} | {r['straight']} | {r['zero']} "
              f"| {listed(r['not_drawn'])} | {listed(r['only_ours'])} | {r['chords']} | {r['worst']:.0e} "
              f"| {r['off_curve']:.0e} | {r['off_chords']:.0e} | {verdict} |", flush=True)
    sys.exit(0 if good else 1)


main()
