#!/usr/bin/env python3
"""Edges rounded to decimals by plumbline and by GEOS (snap rounding, GEOSUnaryUnionPrec), compared.

usage: against_geos.py PLUMBLINE DIRECTORY

GEOS is given the drawing's segments in doubles and the grid. Vertices and edges are compared as sets of
integers in units of the grid. Prints Markdown.
"""
import collections
import ctypes
import os
import subprocess
import sys
import tempfile
from fractions import Fraction

LARGEST = 20000
DECIMALS = (6, 3, 2)
ENDINGS = (".svg", ".svgz", ".dxf", ".lines", ".geojson", ".wkt", ".json", ".csv")


class Geos:
    """The few functions of GEOS's C interface that are needed."""

    def __init__(self):
        self.lib = ctypes.CDLL("libgeos_c.so.1")
        self.lib.GEOS_init_r.restype = ctypes.c_void_p
        self.context = ctypes.c_void_p(self.lib.GEOS_init_r())
        for name, result, arguments in (
                ("GEOSWKTReader_create_r", ctypes.c_void_p, []),
                ("GEOSWKTReader_read_r", ctypes.c_void_p, [ctypes.c_void_p, ctypes.c_char_p]),
                ("GEOSUnaryUnionPrec_r", ctypes.c_void_p, [ctypes.c_void_p, ctypes.c_double]),
                ("GEOSWKTWriter_create_r", ctypes.c_void_p, []),
                ("GEOSWKTWriter_write_r", ctypes.c_void_p, [ctypes.c_void_p, ctypes.c_void_p]),
                ("GEOSFree_r", None, [ctypes.c_void_p]),
                ("GEOSGeom_destroy_r", None, [ctypes.c_void_p])):
            function = getattr(self.lib, name)
            function.restype = result
            function.argtypes = [ctypes.c_void_p] + arguments
        self.reader = self.lib.GEOSWKTReader_create_r(self.context)
        self.writer = self.lib.GEOSWKTWriter_create_r(self.context)

    def rounded(self, segments, decimals):
        """The distinct edges, in units of the grid; None if GEOS fails."""
        wkt = "MULTILINESTRING(" + ",".join(
            f"({a!r} {b!r},{c!r} {d!r})" for a, b, c, d in segments) + ")"
        geometry = self.lib.GEOSWKTReader_read_r(self.context, self.reader, wkt.encode())
        result = self.lib.GEOSUnaryUnionPrec_r(self.context, geometry, 10.0**-decimals)
        self.lib.GEOSGeom_destroy_r(self.context, geometry)
        if not result:
            return None
        text = self.lib.GEOSWKTWriter_write_r(self.context, self.writer, result)
        edges = edges_of_wkt(ctypes.string_at(text).decode(), 10**decimals)
        self.lib.GEOSFree_r(self.context, text)
        self.lib.GEOSGeom_destroy_r(self.context, result)
        return edges


def edges_of_wkt(wkt, factor):
    edges = set()
    for line in wkt.replace("MULTILINESTRING", "").replace("LINESTRING", "").split("("):
        points = [tuple(round(Fraction(x) * factor) for x in point.split())
                  for point in line.strip(") ,").split(",") if len(point.split()) == 2]
        edges.update(tuple(sorted(pair)) for pair in zip(points, points[1:]) if pair[0] != pair[1])
    return edges


def rows(file, number):
    with open(file) as text:
        return [tuple(number(x) for x in row.split(",")) for row in text if row.count(",") == 3]


def run(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                          check=False, timeout=600)


def vertices(edges):
    return {point for edge in edges for point in edge}


def main():
    plumbline, directory = sys.argv[1:] if len(sys.argv) == 3 else sys.exit(__doc__)
    geos = Geos()
    files = sorted(os.path.join(folder, name) for folder, _, names in os.walk(directory)
                   for name in names if name.lower().endswith(ENDINGS))
    tally = {n: collections.Counter() for n in DECIMALS}
    different = []
    with tempfile.TemporaryDirectory() as folder:
        lines, safe = (os.path.join(folder, name) for name in ("input.lines", "safe.lines"))
        for file in files:
            if run(plumbline, "eval", file, "-o", lines).returncode != 0:
                continue
            segments = rows(lines, lambda text: float(Fraction(text)))
            if not 3 <= len(segments) <= LARGEST:
                continue
            for n in DECIMALS:
                done = run(plumbline, "arrange", file, "--safe", "--decimals", str(n), "-o", safe)
                if done.returncode != 0:
                    continue
                snapped = "snap rounded" in done.stdout
                ours = {tuple(sorted(((a, b), (c, d)))) for a, b, c, d in rows(
                    safe, lambda text: round(Fraction(text) * 10**n))}
                theirs = geos.rounded(segments, n)
                kind = "snap rounded" if snapped else "same"
                tally[n][kind] += 1
                if theirs is None:
                    tally[n][kind + ", GEOS fails"] += 1
                elif theirs == ours:
                    tally[n][kind + ", equal"] += 1
                else:
                    different.append((os.path.relpath(file, directory), n, kind,
                                      len(vertices(ours)), len(vertices(theirs)),
                                      len(ours), len(theirs), len(ours ^ theirs)))
    print("| decimals | same incidences | of them GEOS has the same edges | snap rounded | of them GEOS "
          "has the same edges | GEOS fails |\n|---:|---:|---:|---:|---:|---:|")
    for n, t in tally.items():
        fails = t["same, GEOS fails"] + t["snap rounded, GEOS fails"]
        print(f"| {n} | {t['same']} | {t['same, equal']} | {t['snap rounded']} | "
              f"{t['snap rounded, equal']} | {fails} |")
    print("\n| drawing | decimals | ours is | V | V of GEOS | E | E of GEOS | edges in one only |\n"
          "|---|---:|---|---:|---:|---:|---:|---:|")
    for row in different:
        print("| " + " | ".join(str(cell) for cell in row) + " |")


if __name__ == "__main__":
    main()
