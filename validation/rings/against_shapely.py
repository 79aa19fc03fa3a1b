#!/usr/bin/env python3
"""Holds what Plumbline says of random polygons against GEOS's isValidReason.

Usage: against_shapely.py PLUMBLINE COUNT
Prints a Markdown page; exit code 1 if a polygon is valid by one of them alone.
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
import shapely.wkt
from shapely.validation import explain_validity

VALID = "Valid Geometry"
CELL = 40  # apart from each other
SHOWN = 5


def geos_version():
    if hasattr(shapely, "geos_version"):
        return shapely.geos_version
    from shapely import geos  # before 2.0
    return geos.geos_version


def star(corners):
    angles = sorted(2 * math.pi * random.random() for _ in range(corners))
    radii = [random.uniform(2, 8) for _ in angles]
    return [(6 + round(r * math.cos(a)), 6 + round(r * math.sin(a))) for r, a in zip(radii, angles)]


def scribble(low, high, corners):
    return [(random.randint(low, high), random.randint(low, high)) for _ in range(corners)]


def hole():
    if random.random() < 0.5:
        return scribble(0, 10, 3)
    x, y, s = random.randint(-1, 11), random.randint(-1, 11), random.randint(1, 4)
    square, triangle = [(x, y), (x, y + s), (x + s, y + s), (x + s, y)], [(x, y), (x + s, y + s), (x + 2 * s, y)]
    return random.choice([square, triangle])


def part():
    shell = random.choice([lambda: [(0, 0), (12, 0), (12, 12), (0, 12)],
                           lambda: star(random.randint(3, 8)),
                           lambda: scribble(0, 8, random.randint(3, 6))])()
    return [shell] + [hole() for _ in range(random.choice([0, 0, 1, 1, 2, 3]))]


def text_of(parts, dx, dy):
    def ring(points):
        return "(" + ", ".join(f"{x + dx} {y + dy}" for x, y in points + points[:1]) + ")"

    polygons = ["(" + ", ".join(map(ring, rings)) + ")" for rings in parts]
    return f"POLYGON {polygons[0]}" if len(parts) == 1 else f"MULTIPOLYGON ({', '.join(polygons)})"


def diagnosed(program, lines):
    """Per line of WKT what is wrong: pairs of JTS's name and places."""
    with tempfile.TemporaryDirectory() as folder:
        drawing, result = pathlib.Path(folder, "rings.wkt"), pathlib.Path(folder, "rings.json")
        drawing.write_text("\n".join(lines) + "\n")
        subprocess.run([program, "info", drawing, "--diagnose", "--within", "0", "--list", "100000000", "-o", result],
                       check=True, stdout=subprocess.DEVNULL)
        report = json.loads(result.read_text())
    found = collections.defaultdict(list)
    for defect in report["defects"]:
        if defect["kind"] == "invalid ring":
            ring = defect["ring"]
            places = [p["nearest"] for p in (defect["where"], ring["until"]) if p]
            found[report["sources"][defect["sources"][0]]["line"]].append((ring["jts"], places))
    return found


def main(program, count):
    random.seed(count)
    side = math.isqrt(count) + 1
    lines = []
    for i in range(count):
        parts = [part() for _ in range(1 if random.random() < 0.7 else random.randint(1, 3))]
        lines.append(text_of(parts, CELL * (i % side), CELL * (i // side)))
    found = diagnosed(program, lines)
    counts, differences = collections.Counter(), []
    same_kind = same_place = invalid = 0
    for number, line in enumerate(lines, 1):
        reason = explain_validity(shapely.wkt.loads(line))
        ours = found[number]
        kind = reason.split("[")[0]
        if (reason == VALID) != (not ours):
            differences.append(f"{reason}: {line}")
            continue
        counts[kind] += 1
        if reason == VALID:
            continue
        invalid += 1
        place = [float(x) for x in reason.split("[")[1].rstrip("]").split()]
        same_kind += any(name.replace("distinct ", "") == kind for name, _ in ours)
        same_place += any(math.dist(place, p) < 1e-6 for _, places in ours for p in places)
    print("# Whether polygons are valid, by GEOS and by Plumbline\n")
    print(f"Made by `validation/rings/run {count}` with Shapely {shapely.__version__} (GEOS "
          f"{'.'.join(map(str, geos_version()))}): random polygons on a small grid, so that rings often")
    print("touch and run along each other. GEOS names one reason in doubles, Plumbline all in exact places; *reasons* are GEOS's.\n")
    print("| reason | polygons |\n| --- | ---: |")
    for kind, polygons in counts.most_common():
        print(f"| {kind} | {polygons} |")
    print(f"\nOf {count} polygons {len(differences)} are valid by one of them alone. Of the {invalid} that are not, Plumbline has GEOS's reason")
    print(f"among its own for {same_kind}, GEOS's place for {same_place}; where a ring runs along itself, GEOS says one of two things.")
    for difference in differences[:SHOWN]:
        print(f"\n    {difference}")
    return 1 if differences else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], int(sys.argv[2])))
