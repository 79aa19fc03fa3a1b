#!/usr/bin/env python3
"""Writes DXF files of random entities, nested blocks, arrays and mirrored inserts.

Usage: random_dxf.py DIRECTORY COUNT. File i is made from the seed i. Needs Debian's python3-ezdxf.
"""

import math
import pathlib
import random
import sys

import ezdxf

VERSIONS = ["R12", "R2000", "R2004", "R2010", "R2018"]


class Maker:
    def __init__(self, seed):
        self.random = random.Random(seed)
        self.version = self.random.choice(VERSIONS)
        self.document = ezdxf.new(self.version)
        for name in ("WALLS", "DOORS"):
            self.document.layers.new(name)

    def number(self, low=-10, high=10):
        return round(self.random.uniform(low, high), self.random.choice([0, 1, 3, 12]))

    def point(self):
        return self.number(), self.number()

    def attributes(self, may_be_mirrored=True):
        result = {"layer": self.random.choice(["0", "WALLS", "DOORS"])}
        if may_be_mirrored and self.random.random() < 0.2:
            result["extrusion"] = (0, 0, -1)
        return result

    def angle(self):
        return self.random.choice([0, 90, 180, 270, self.number(-400, 400)])

    def polyline(self, space):
        points = [self.point() + (self.random.choice([0, 0, self.number(-2, 2)]),)
                  for _ in range(self.random.randint(2, 7))]
        closed = self.random.random() < 0.5
        if self.version == "R12":
            space.add_polyline2d(points, format="xyb", close=closed, dxfattribs=self.attributes())
        else:
            space.add_lwpolyline(points, format="xyb", close=closed, dxfattribs=self.attributes())

    def ellipse(self, space):
        major = self.point()
        if major == (0, 0) or self.version == "R12":
            return
        # ezdxf draws nothing between s and s + 2 pi unless s is 0
        start, end = self.random.choice([(0, math.tau), (self.number(0, 6), self.number(0, 6) + 0.01)])
        space.add_ellipse(self.point(), major, self.random.uniform(0.1, 1), start, end, self.attributes())

    def spline(self, space):
        if self.version == "R12":
            return
        degree = self.random.randint(1, 5)
        points = [self.point() for _ in range(degree + self.random.randint(1, 5))]
        knots = sorted(self.number(0, 9) for _ in range(len(points) - degree - 1))
        knots = [-1] * (degree + 1) + knots + [10] * (degree + 1)
        if self.random.random() < 0.5:
            space.add_open_spline([p + (0,) for p in points], degree, knots)
        else:
            weights = [round(self.random.uniform(0.2, 3), 2) for _ in points]
            space.add_rational_spline([p + (0,) for p in points], weights, degree, knots)

    def entity(self, space):
        kind = self.random.randrange(8)
        if kind == 0:
            space.add_line(self.point(), self.point(), self.attributes(False))
        elif kind == 1:
            space.add_circle(self.point(), self.random.uniform(0.1, 5), self.attributes())
        elif kind == 2:
            start = self.angle()
            space.add_arc(self.point(), self.random.uniform(0.1, 5), start,
                          start + self.random.uniform(1, 359), dxfattribs=self.attributes())
        elif kind == 3:
            space.add_solid([self.point() for _ in range(self.random.choice([3, 4]))], self.attributes())
        elif kind == 4:
            self.ellipse(space)
        elif kind == 5:
            self.spline(space)
        else:
            self.polyline(space)

    def insert(self, space, block):
        attributes = self.attributes()
        sx = self.random.choice([1, -1, self.number(0.5, 3)])
        attributes.update(xscale=sx, yscale=self.random.choice([sx, 1, -2]), rotation=self.angle())
        if self.random.random() < 0.3:
            attributes.update(column_count=self.random.randint(1, 3), row_count=self.random.randint(1, 3),
                              column_spacing=self.number(1, 30), row_spacing=self.number(-30, -1))
        space.add_blockref(block, self.point(), attributes)

    def make(self, file):
        names = [f"B{i}" for i in range(self.random.randint(0, 4))]
        for i, name in enumerate(names):
            block = self.document.blocks.new(name, base_point=self.point())
            for _ in range(self.random.randint(1, 4)):
                self.entity(block)
            for inner in names[:i]:
                if self.random.random() < 0.5:
                    self.insert(block, inner)
        space = self.document.modelspace()
        for _ in range(self.random.randint(1, 6)):
            self.entity(space)
        for name in names:
            self.insert(space, name)
        binary = self.random.random() < 0.2
        self.document.saveas(file, fmt="bin" if binary else "asc")


def main():
    directory, count = sys.argv[1:] if len(sys.argv) == 3 else sys.exit(__doc__)
    directory = pathlib.Path(directory)
    directory.mkdir(parents=True, exist_ok=True)
    for seed in range(int(count)):
        Maker(seed).make(directory / f"random-{seed:04}.dxf")


main()
