#!/usr/bin/env python3
"""Holds `plumbline validity` against GEOS, on public test cases and on random polygons.

Usage: against_shapely.py PLUMBLINE FOLDER COUNT
FOLDER has .xml files of JTS and GEOS and .geojson files, in folders or not. Prints a Markdown page; exit code 1 if a
polygon is valid by one of them alone, or if areas differ for another reason than those that are told.
"""
import collections
import decimal
import itertools
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import shapely
from shapely.validation import explain_validity

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "rings"))
import against_shapely as rings  # its random polygons

SHOWN = 8
METHODS = {"linework": {"method": "linework"}, "structure": {"method": "structure", "keep_collapsed": False}}


def wkt_of(text):
    """A polygon's text as WKT in one line, or None for what is none."""
    text = " ".join(text.split())
    if re.fullmatch("[0-9A-Fa-f]+", text):
        try:
            text = shapely.to_wkt(shapely.from_wkb(text), rounding_precision=-1)
        except shapely.errors.GEOSException:
            return None
    return text if re.fullmatch(r"(MULTI)?POLYGON\b[A-Z0-9 .,()+-]*", text, re.IGNORECASE) and "NAN" not in text.upper() else None


def of_xml(path):
    for case in ElementTree.parse(path).iter("case"):
        expected = {op.get("arg1", "A").upper(): op.text.strip().lower() for op in case.iter("op")
                    if op.get("name", "").lower() == "isvalid" and op.text}
        for name in "ab":
            for element in case.findall(name):
                if element.text and (text := wkt_of(element.text)):
                    yield text, expected.get(name.upper())


def of_geojson(value):
    """The polygons of a document, whatever else is wrong with it."""
    if isinstance(value, list):
        for item in value:
            yield from of_geojson(item)
    if not isinstance(value, dict):
        return
    kind, coordinates = value.get("type"), value.get("coordinates")
    if kind in ("Polygon", "MultiPolygon"):
        try:
            parts = [coordinates] if kind == "Polygon" else coordinates
            texts = ["(" + ", ".join("(" + ", ".join(f"{float(p[0])!r} {float(p[1])!r}" for p in ring) + ")" for ring in part) + ")"
                     for part in parts]
            yield f"POLYGON {texts[0]}" if kind == "Polygon" else f"MULTIPOLYGON ({', '.join(texts)})", None
        except (TypeError, IndexError, ValueError):
            return
    for key in ("features", "geometry", "geometries"):
        yield from of_geojson(value.get(key))


def cases_of(folder):
    """Per text of a polygon the file that has it and what that expects."""
    cases = {}
    for path in sorted(pathlib.Path(folder).rglob("*")):
        try:
            if path.suffix == ".xml":
                found = list(of_xml(path))
            elif path.suffix == ".geojson":
                found = list(of_geojson(json.loads(path.read_text())))
            else:
                continue
        except (ElementTree.ParseError, ValueError):
            continue
        for text, expected in found:
            if text not in cases or expected is not None:
                cases[text] = (str(path.relative_to(folder)), expected)
    return cases


def as_doubles(line):
    """The same in the decimals that the nearest doubles are, which is how GEOS has the numbers."""
    return re.sub(r"[-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?", lambda number: f"{decimal.Decimal(float(number[0])):f}", line)


def asked(program, lines, meaning):
    """Per line of WKT the faults and, of an invalid one, the area that is made of it."""
    with tempfile.TemporaryDirectory() as folder:
        drawing = pathlib.Path(folder, "polygons.wkt")
        drawing.write_text("\n".join(lines) + "\n")
        run = subprocess.run([program, "validity", drawing, "--lenient", "--make-valid", meaning, "--json"],
                             capture_output=True, text=True)
    if run.returncode > 1:
        sys.exit(run.stderr)
    report = json.loads(run.stdout)

    def line(feature):
        return int(re.search(r"polygons\.wkt:(\d+):", feature)[1])

    faults = collections.defaultdict(set)
    for fault in report["faults"]:
        faults[line(fault["features"][0])].add(fault["kind"])
    return faults, {line(change["feature"]): change["area"] for change in report["changes"]}


def geos_of(line):
    try:
        return shapely.from_wkt(line)
    except shapely.errors.GEOSException:
        return None


def nearly(a, b):
    return math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-9)


def is_one_point(geometry):
    return len(set(map(tuple, shapely.get_coordinates(geometry)))) == 1


def compare_valid(lines, cases, faults):
    """Prints the table; returns how many differ."""
    counts, differences, expected = collections.Counter(), [], collections.Counter()
    unread = points = 0
    for number, line in enumerate(lines, 1):
        geometry = geos_of(line)
        if geometry is None:
            unread += 1
            continue
        if is_one_point(geometry):
            points += 1
            continue
        ours = not faults[number]
        if cases[line][1] is not None:
            expected[cases[line][1] == str(ours).lower()] += 1
        reason = explain_validity(geometry).split("[")[0]
        counts[reason] += 1
        if geometry.is_valid != ours:
            differences.append((line, reason, ", ".join(sorted(faults[number])) or "valid"))
    print("| GEOS says | polygons |\n| --- | ---: |")
    for reason, count in counts.most_common():
        print(f"| {reason} | {count} |")
    print(f"\nOf {sum(counts.values())} polygons {len(differences)} are valid by one of them alone. Besides, GEOS does not read {unread} (a ring is open, or")
    print(f"has one point), and Plumbline, which drops points that are repeated, {points} of one point only. Of {sum(expected.values())} the file says whether")
    print(f"they are valid: Plumbline says the same of {expected[True]}.\n")
    for line, theirs, ours in differences[:SHOWN]:
        print(f"- {cases[line][0]}: GEOS {theirs}, Plumbline {ours}: `{line[:120]}`")
    return len(differences)


def odd(geometry):
    """The area within an odd number of rings: by the triangles between a corner and each side."""
    area = shapely.Polygon()
    for part in shapely.get_parts(geometry):
        for ring in (part.exterior, *part.interiors):
            first, *others = ring.coords[:-1]
            for a, b in itertools.pairwise(others):
                triangle = shapely.Polygon([first, a, b])
                area = area.symmetric_difference(triangle) if triangle.area > 0 else area
    return area.area


def structure(geometry, takes_outer_holes):
    """The definition of `structure`, by GEOS's own operations; holes outside are polygons if it takes them."""
    parts = []
    for part in shapely.get_parts(geometry):
        shell, *holes = [shapely.make_valid(shapely.Polygon(ring), **METHODS["structure"])
                         for ring in (part.exterior, *part.interiors)]
        parts.append(shapely.difference(shell, shapely.union_all([h for h in holes if shell.intersects(h)])))
        if takes_outer_holes and not shell.is_empty:
            parts += [hole for hole in holes if not shell.intersects(hole)]
    return shapely.union_all(parts).area


def reason_of(meaning, geometry, area, theirs, faults):
    """Why the areas differ, as far as it is known: both are what they should be by their own definitions."""
    if nearly(theirs, area):
        return "same"
    if meaning == "linework":
        return "twice" if nearly(odd(geometry), area) and faults & {"runs along", "too few points"} else "else"
    is_known = nearly(structure(geometry, False), area) and nearly(structure(geometry, True), theirs)
    return "outer" if is_known else "else"


def compare_made(title, lines, made):
    """Prints the table; returns how many differ for another reason than those that are known."""
    print(f"| {title} | polygons | the same area | lines drawn more than once | holes outside | else |")
    print("| --- | ---: | ---: | ---: | ---: | ---: |")
    shown, unknown = [], 0
    for meaning, method in METHODS.items():
        faults, areas = made[meaning]
        counts, shortest = collections.Counter(), {}
        for number, area in areas.items():
            line = lines[number - 1]
            geometry = geos_of(line)
            if geometry is None or is_one_point(geometry):
                continue
            theirs = shapely.make_valid(geometry, **method).area
            reason = reason_of(meaning, geometry, area, theirs, faults[number])
            counts[reason] += 1
            if reason != "same" and (reason not in shortest or len(line) < len(shortest[reason][0])):
                shortest[reason] = (line, theirs, area)
        print(f"| {meaning} | {sum(counts.values())} | {counts['same']} | {counts['twice']} | {counts['outer']} | {counts['else']} |")
        shown += [(meaning, *example) for example in shortest.values()]
        unknown += counts["else"]
    print()
    for meaning, line, theirs, ours in shown:
        print(f"- {meaning}: GEOS {theirs:g}, Plumbline {ours:g}: `{line[:160]}`")
    print()
    return unknown


def main(program, folder, count):
    cases = cases_of(folder)
    lines = list(cases)
    print("# Which polygons are valid, and what valid ones are made of the others, by GEOS and by Plumbline\n")
    print(f"Made by `validation/validity/run FOLDER {count}` with Shapely {shapely.__version__} (GEOS "
          f"{'.'.join(map(str, rings.geos_version()))}). Areas are the same up to 1e-9 of them.\n\n## Public test cases\n")
    doubles = [as_doubles(line) for line in lines]
    made = {meaning: asked(program, doubles, meaning) for meaning in METHODS}
    faults = made["linework"][0]
    differences = compare_valid(lines, cases, faults)
    of_decimals = asked(program, lines, "linework")[0]
    rounded = [n for n in range(1, len(lines) + 1) if bool(of_decimals[n]) != bool(faults[n])]
    print(f"These are the polygons in doubles, as GEOS has them. With the decimals that the files say, {len(rounded)} are valid in one of the two ways alone:")
    print("their places are nearer to each other than doubles are.\n\n## What is made of them\n")
    unknown = compare_made("Public cases", lines, made)
    random.seed(count)
    side = math.isqrt(count) + 1
    lines = [rings.text_of([rings.part() for _ in range(1 if random.random() < 0.7 else 2)],
                           rings.CELL * (i % side), rings.CELL * (i // side)) for i in range(count)]
    made = {meaning: asked(program, lines, meaning) for meaning in METHODS}
    unknown += compare_made("Random polygons", lines, made)
    print(EXPLAINED)
    return 1 if differences + unknown else 0


EXPLAINED = """## Why they differ

- Lines drawn more than once: Plumbline's `linework` is what lies within an odd number of rings, each line as often as it is drawn. GEOS takes lines as
  a set: where a hole and the outer ring share a piece, the rest of the hole no longer encloses anything, and is filled; a ring that goes back
  along itself closes what others leave open. By triangles put together with GEOS's own operations, the odd area is Plumbline's in all these cases.
- Holes outside: Plumbline's `structure` is a part's outer ring without its holes. GEOS makes a polygon of a hole that lies outside an outer ring with an area. Put together
  with GEOS's own operations, the first is Plumbline's area and the second GEOS's in all these cases."""


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2], int(sys.argv[3])))
