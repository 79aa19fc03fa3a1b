#!/usr/bin/env python3
"""Shapely's faces of real drawings, checked with `plumbline check --against`.

usage: shapely_faces.py PLUMBLINE DIRECTORY

Of each drawing below DIRECTORY with at most LARGEST segments GEOS nodes the lines (unary_union) and
makes faces of them (polygonize). Faces and noded lines are written as GeoJSON and as WKT, which must
give the same findings. Prints Markdown; exit code 1 if the two formats differ or a check fails.
"""
import collections
import json
import os
import subprocess
import sys
import tempfile
from fractions import Fraction

import shapely.wkt
from shapely.geometry import GeometryCollection, LineString, mapping
from shapely.ops import polygonize, unary_union

LARGEST = 20000
ENDINGS = (".svg", ".dxf", ".lines", ".geojson", ".wkt", ".json", ".csv")


def segments(plumbline, folder, file):
    """The drawing's segments in doubles; none of a drawing that can't be arranged."""
    out = os.path.join(folder, "exact.json")
    run = subprocess.run([plumbline, "arrange", file, "-o", out], stdout=subprocess.DEVNULL,
                         stderr=subprocess.DEVNULL, check=False, timeout=300)
    if run.returncode != 0:
        return []
    with open(out) as text:
        listed = json.load(text)["segments"]
    return [tuple(tuple(float(Fraction(x)) for x in s[end]) for end in ("from", "to"))
            for s in listed]


def by_kind(listed):
    kinds = collections.Counter(f"{f['kind']} {f['disagreement']}" for f in listed)
    return ", ".join(f"{kind} {n}" for kind, n in sorted(kinds.items()))


def findings(plumbline, folder, file, result):
    """Findings by kind, those of the result and those of the rounded input; of a failure its message."""
    out = os.path.join(folder, "report.json")
    run = subprocess.run([plumbline, "check", file, "--against", result, "-o", out, "--no-advice"],
                         stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
    if run.returncode not in (0, 1):
        return "failed: " + run.stderr.strip(), ""
    with open(out) as text:
        report = json.load(text)
    return by_kind(report["findings"]) or "agrees", by_kind(report["conversion"]) or "none"


def main():
    plumbline, directory = sys.argv[1:] if len(sys.argv) == 3 else sys.exit(__doc__)
    failures, agreeing, count = [], 0, 0
    files = sorted(os.path.join(folder, name) for folder, _, names in os.walk(directory)
                   for name in names if name.lower().endswith(ENDINGS))
    print("| drawing | segments | faces | findings | of rounding alone |\n"
          "| --- | ---: | ---: | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        for file in files:
            lines = [s for s in segments(plumbline, folder, file) if s[0] != s[1]]
            if not 3 <= len(lines) <= LARGEST:
                continue
            noded = unary_union([LineString(s) for s in lines])
            faces = list(polygonize(noded))
            whole = GeometryCollection(faces + list(getattr(noded, "geoms", [noded])))
            paths = [os.path.join(folder, name) for name in ("r.geojson", "r.wkt")]
            with open(paths[0], "w") as text:
                json.dump(mapping(whole), text)
            with open(paths[1], "w") as text:
                # As many decimals as tell doubles apart: precision counts those behind the point.
                text.write(shapely.wkt.dumps(whole, rounding_precision=17))
            found = [findings(plumbline, folder, file, path) for path in paths]
            count += 1
            (found[0], rounding), (found[1], _) = found
            agreeing += found[0] == "agrees"
            name = os.path.relpath(file, directory)
            if found[0] != found[1] or found[0].startswith("failed"):
                failures.append(f"{name}: GeoJSON {found[0]}; WKT {found[1]}")
            if found[0] != "agrees":
                print(f"| {name} | {len(lines)} | {len(faces)} | {found[0]} | {rounding} |")
    print(f"\n{agreeing} of {count} drawings agree; the others are listed.")
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
