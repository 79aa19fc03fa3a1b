#!/usr/bin/env python3
"""Compares the segments that Plumbline reads with an index of the files and with Shapely (GEOS).

Usage: formats_against_index.py PLUMBLINE_FORMATS DIRECTORY
Prints a Markdown table; exit code 1 if a difference has no explanation.
"""
import json
import pathlib
import re
import subprocess
import sys

from shapely import wkt
from shapely.geometry import shape

UNCLOSED = "ring is not closed; it is drawn as it is"
REFUSED = {  # reasons for which the index has segments of a geometry that Plumbline refuses as a whole
    "position without numbers", "positions are nested unevenly"}
EPSILON = 2.0 ** -53


def geometries(value):
    """The GeoJSON geometries in a GeoJSON value."""
    if not isinstance(value, dict):
        return
    for member in value.get("features") or []:
        yield from geometries(member)
    yield from geometries(value.get("geometry"))
    for member in value.get("geometries") or []:
        yield from geometries(member)
    if "coordinates" in value:
        yield value


def lines_of(geometry):
    """The lines of a Shapely geometry, rings as lines."""
    if hasattr(geometry, "geoms"):
        return [line for part in geometry.geoms for line in lines_of(part)]
    if geometry.geom_type == "Polygon":
        return [geometry.exterior, *geometry.interiors] if not geometry.is_empty else []
    return [] if geometry.geom_type == "Point" else [geometry]


def by_shapely(file):
    """Segments of some length and the sum of lengths; None where Shapely can't read the file."""
    try:
        if file.suffix == ".wkt":
            parts = re.split(r"\n(?=[A-Z])", file.read_text())
            found = [wkt.loads(part) for part in parts if part.strip()]
        else:
            found = [shape(g) for g in geometries(json.loads(file.read_text("utf-8-sig")))]
        count, length = 0, 0.0
        for line in (line for geometry in found for line in lines_of(geometry)):
            points = [point[:2] for point in line.coords]
            count += sum(p != q for p, q in zip(points, points[1:]))
            length += line.length
        return count, length
    except Exception:  # whatever Shapely raises for a file that breaks its format
        return None


def explanation(row, expected, zero_length):
    """Why the counts differ; empty if they agree, None if no one knows."""
    if "error" in row:
        return f"refused at {row['line']}:{row['column']}: {row['error']}"
    reasons = {key.split(": ", 1)[1]: count for key, count in row["rejected"].items()}
    if row["segments"] == expected - zero_length:
        return ""
    if UNCLOSED in reasons:
        return f"the index closes rings; {reasons[UNCLOSED]} elements have rings that are not closed"
    if REFUSED & reasons.keys():
        return "refused as a whole: " + ", ".join(REFUSED & reasons.keys())
    if expected == 0 and row["file"].endswith("-VFV.json"):
        return "faces without edges, which the index does not draw"
    return None


def main():
    tool, directory = sys.argv[1:] if len(sys.argv) == 3 else sys.exit(__doc__)
    directory = pathlib.Path(directory)
    index = json.loads((directory / "index.json").read_text())["files"]
    endings = (".geojson", ".wkt", ".json")
    entries = [entry for entry in index if entry["file"].endswith(endings)]
    output = subprocess.run([tool, *(str(directory / entry["file"]) for entry in entries)],
                            check=True, capture_output=True, text=True).stdout
    rows = [json.loads(line) for line in output.splitlines()]
    print("| file | index | zero length | Plumbline | listed | Shapely | lengths differ by | explanation |")
    print("|---|---:|---:|---:|---|---:|---:|---|")
    unexplained = same = 0
    for entry, row in zip(entries, rows):
        zero_length = (entry.get("measures") or {}).get("zero_length", 0)
        why = explanation(row, entry["segments"], zero_length)
        oracle = by_shapely(directory / entry["file"]) if "error" not in row else None
        if entry["file"].endswith(".json"):
            oracle = None
        apart = abs(oracle[1] - row["length"]) / max(oracle[1], 1e-300) if oracle else None
        # Of doubles, each of a segment's four coordinates is off by EPSILON times the largest at most;
        # as much again is left to the square roots and the sums.
        largest = (entry.get("measures") or {}).get("max_abs", 0)
        bound = 8 * EPSILON * largest * entry["segments"] / max(oracle[1], 1e-300) if oracle else 0
        agrees = oracle is None or (oracle[0] == row["segments"] and apart <= bound)
        if why is None or (not agrees and UNCLOSED not in str(row["rejected"])):
            unexplained += 1
            why = f"**unexplained** {why or ''}"
        same += why == ""
        listed = ", ".join(f"{count} x {reason}" for reason, count in row.get("rejected", {}).items())
        print(f"| {entry['file']} | {entry['segments']} | {zero_length} | {row.get('segments', '')} | {listed} | "
              f"{oracle[0] if oracle else ''} | {f'{apart:.1g}' if oracle else ''} | {why} |")
    print(f"\n{len(rows)} files: {same} as in the index, {len(rows) - same - unexplained} explained, "
          f"{unexplained} unexplained.")
    return 1 if unexplained else 0


if __name__ == "__main__":
    sys.exit(main())
