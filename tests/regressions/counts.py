#!/usr/bin/env python3
"""V, E, F, C of the arrangement of the lines and rects of SVG files, or of the rows of .lines files (x,y being an
isolated point), for tests to hold results against.

Usage: counts.py FILE...   Transforms and other elements are not read. All pairs of segments, in
fractions over the decimals of the file; shares nothing with the project.
"""
import sys
import xml.etree.ElementTree as ElementTree
from fractions import Fraction


def segments(file):
    result = set()
    for element in ElementTree.parse(file).getroot().iter():
        tag = element.tag.split("}")[-1]

        def number(name):
            return Fraction(element.get(name, "0"))

        if tag == "line":
            ends = [(number("x1"), number("y1")), (number("x2"), number("y2"))]
            result.add(tuple(sorted(ends)))
        elif tag == "rect":
            x, y, w, h = (number(name) for name in ("x", "y", "width", "height"))
            corners = [(x, y), (x + w, y), (x + w, y + h), (x, y + h)]
            result |= {tuple(sorted((corners[i - 1], corners[i]))) for i in range(4)}
    return [s for s in result if s[0] != s[1]]


def rows(file):
    numbers = [[Fraction(x) for x in row.split(",")] for row in open(file) if row.strip()]
    lines = {tuple(sorted(((r[0], r[1]), (r[2], r[3])))) for r in numbers if len(r) == 4}
    return [s for s in lines if s[0] != s[1]], {tuple(r) for r in numbers if len(r) == 2}


def cross(o, a, b):
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])


def is_on(a, b, p):
    in_box = all(min(a[i], b[i]) <= p[i] <= max(a[i], b[i]) for i in (0, 1))
    return in_box and cross(a, b, p) == 0


def common_points(s, t):
    (a, b), (p, q) = s, t
    found = [x for x in (a, b) if is_on(p, q, x)] + [x for x in (p, q) if is_on(a, b, x)]
    d = (b[0] - a[0]) * (q[1] - p[1]) - (b[1] - a[1]) * (q[0] - p[0])
    if d != 0:
        u = ((p[0] - a[0]) * (q[1] - p[1]) - (p[1] - a[1]) * (q[0] - p[0])) / d
        x = (a[0] + u * (b[0] - a[0]), a[1] + u * (b[1] - a[1]))
        if is_on(a, b, x) and is_on(p, q, x):
            found.append(x)
    return found


def counts(lines, isolated=()):
    points = [set(s) for s in lines]
    for x in isolated:
        for i, s in enumerate(lines):
            if is_on(*s, x):
                points[i].add(x)
    for i, s in enumerate(lines):
        for j in range(i):
            for x in common_points(s, lines[j]):
                points[i].add(x)
                points[j].add(x)
    edges = {e for on_line in points for e in zip(sorted(on_line), sorted(on_line)[1:])}
    root = {v: v for e in edges for v in e} | {x: x for x in isolated}

    def find(v):
        while root[v] != v:
            v = root[v]
        return v

    for a, b in edges:
        root[find(a)] = find(b)
    components = sum(root[v] == v for v in root)
    return len(root), len(edges), 1 + components - len(root) + len(edges), components


if __name__ == "__main__":
    if len(sys.argv) < 2 or "--help" in sys.argv:
        sys.exit(__doc__)
    for name in sys.argv[1:]:
        drawn = rows(name) if name.endswith(".lines") else (segments(name), ())
        print(name, "V %d E %d F %d C %d" % counts(*drawn))
