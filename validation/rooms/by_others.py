#!/usr/bin/env python3
"""Holds the rooms that Plumbline finds against those that ezdxf and Shapely find.

Usage: by_others.py PLUMBLINE DRAWING[,UNIT]...
Prints a Markdown page; exit code 1 if anything differs. UNIT is given to `rooms --unit`.
"""
import collections
import json
import pathlib
import subprocess
import sys
import tempfile
from fractions import Fraction

import ezdxf
import shapely

import lines_and_texts

UNITS = {"in": 0.0254, "ft": 0.3048, "mm": 0.001, "cm": 0.01, "m": 1.0}
RELATIVE = 1e-9
SLIVER = 1e-12  # of the extent: as wide as digits of doubles tell, and no wider
CIRCLE = 0.02  # as precise as Plumbline says that its circles are


class Wrong(Exception):
    pass


def run(*command):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=600)
    if result.returncode != 0:
        raise Wrong(result.stderr[-300:])
    return result.stdout


def width(polygon, precision):
    return 2 * shapely.maximum_inscribed_circle(polygon, tolerance=precision).length


class Theirs:
    """Rooms by Shapely, from lines and texts."""

    def __init__(self, drawing, min_area, min_width):
        lines = shapely.unary_union(shapely.linestrings(drawing.segments))
        self.faces = list(shapely.get_parts(shapely.polygonize(shapely.get_parts(lines))))
        self.min_area, self.min_width = min_area, min_width
        self.widths = [width(face, min_width / 1000) for face in self.faces]
        self.rooms = [i for i, face in enumerate(self.faces) if self.is_room(i, 1)]
        self.doubtful = {i for i in range(len(self.faces)) if self.is_room(i, 1 - CIRCLE) != self.is_room(i, 1 + CIRCLE)}
        slightest = SLIVER * lines_and_texts.extent(drawing)
        self.doubtful |= {i for i, across in enumerate(self.widths) if across < slightest}
        self.tree = shapely.STRtree(self.faces)
        self.names = {i: set() for i in self.rooms}
        self.outside = 0
        for words, place in drawing.texts:
            self.add_text(words, shapely.Point(place), lines)
        for words, polygon in drawing.named:
            for room in self.rooms:
                if polygon.contains(self.faces[room].representative_point()):
                    self.names[room].add(words)

    def is_room(self, i, factor):
        return self.faces[i].area >= self.min_area and self.widths[i] >= factor * self.min_width

    def face_at(self, point):
        found = self.tree.query(point, predicate="within")
        return int(found[0]) if len(found) else None

    def room_around(self, face):
        """The face itself, if it is a room, else the smallest room whose outline it lies in."""
        if face in self.names:
            return face
        inside = self.faces[face].representative_point()
        around = [r for r in self.rooms if shapely.Polygon(self.faces[r].exterior).contains(inside)]
        return min(around, key=lambda r: shapely.Polygon(self.faces[r].exterior).area, default=None)

    def add_text(self, words, point, lines):
        face = None if lines.intersects(point) else self.face_at(point)
        room = None if face is None else self.room_around(face)
        if room is None:
            self.outside += 1
        else:
            self.names[room].add(words)


def ours_of(program, drawing, options, folder):
    files = [pathlib.Path(folder) / name for name in ["rooms.geojson", "rooms.json"]]
    for file in files:
        summary = run(program, "rooms", drawing, "--lenient", "--json", *options, "-o", file)
    polygons, full = [json.loads(file.read_text()) for file in files]
    parts = collections.defaultdict(list)  # a rounding may part a room
    for feature in polygons["features"]:
        parts[feature["properties"]["room"]].append(shapely.geometry.shape(feature["geometry"]))
    rooms = []
    for room, more in zip(json.loads(summary)["rooms"], full["rooms"], strict=True):
        largest = max(parts[room["room"]], key=lambda part: part.area)
        rooms.append((largest, room["area"], more["width"], set(room["names"])))
    return rooms, full, json.loads(summary)["texts_outside"]


def held_against(rooms, theirs, slack):
    """What differs, in words; how many names agree; the largest relative difference of areas."""
    differ, met, largest, names = [], set(), 0.0, 0
    for polygon, area, across, words in rooms:
        point = polygon.representative_point()
        face = theirs.face_at(point)
        where = f"room at ({point.x:.6g}, {point.y:.6g})"
        if face is None or face in met:
            differ.append(f"{where} is not theirs")
            continue
        met.add(face)
        other = theirs.faces[face]
        if face not in theirs.names and face not in theirs.doubtful:
            differ.append(f"{where} is no room to them: area {other.area:.6g}, width {theirs.widths[face]:.6g}")
        largest = max(largest, abs(other.area - area) / other.area)
        if abs(other.area - area) > RELATIVE * other.area + slack * other.length:
            differ.append(f"{where} has area {area!r}, theirs {other.area!r}")
        if abs(theirs.widths[face] - across) > CIRCLE * (theirs.widths[face] + theirs.min_width):
            differ.append(f"{where} is {across!r} wide, by them {theirs.widths[face]!r}")
        if face in theirs.names:
            names += len(words)
            plain = {" ".join(word.split()) for word in words}
            if plain != theirs.names[face]:
                differ.append(f"{where} is named {sorted(plain)}, by them {sorted(theirs.names[face])}")
    for face in set(theirs.rooms) - met - theirs.doubtful:
        point = theirs.faces[face].representative_point()
        differ.append(f"their room at ({point.x:.6g}, {point.y:.6g}) is not ours")
    return differ, names, largest


def row(program, argument, folder):
    path, _, unit = argument.partition(",")
    options = ["--unit", unit] if unit else []
    drawing = lines_and_texts.read(path, 1)
    sagitta = lines_and_texts.extent(drawing) * 1e-5
    if drawing.has_curves:
        drawing = lines_and_texts.read(path, sagitta)
        options += ["--flatten", f"{sagitta:.20f}"]
    rooms, full, outside = ours_of(program, path, options, folder)
    theirs = Theirs(drawing, float(Fraction(full["min_area"])), float(Fraction(full["min_width"])))
    metres = UNITS.get(unit) or drawing.metres
    differ, names, largest = held_against(rooms, theirs, 2 * sagitta if drawing.has_curves else 0)
    if metres and float(Fraction(full["min_width"])) * metres - 0.5 > 1e-9:
        differ.append(f"least width {full['min_width']} is not 0.5 m")
    if outside != theirs.outside:
        differ.append(f"{outside} texts outside, theirs {theirs.outside}")
    doubtful = theirs.doubtful.intersection(theirs.rooms)
    return differ, [f"`{pathlib.Path(path).name}`{' (' + unit + ')' if unit else ''}", len(drawing.segments),
                    "curves" if drawing.has_curves else "straight", len(theirs.faces), len(theirs.rooms) - len(doubtful),
                    len(doubtful), len(rooms), names, theirs.outside, f"{largest:.1g}"]


def main(program, arguments):
    print(HEAD.format(ezdxf=ezdxf.__version__, shapely=shapely.__version__,
                      geos=".".join(map(str, shapely.geos_version))))
    failed = False
    for argument in arguments:
        with tempfile.TemporaryDirectory() as folder:
            try:
                differ, cells = row(program, argument, folder)
            except Wrong as problem:
                differ, cells = [str(problem)], [f"`{pathlib.Path(argument).name}`", *[""] * 9]
        failed = failed or bool(differ)
        words = "same" if not differ else "**" + "; ".join(differ) + "**"
        print("| " + " | ".join(str(cell).replace("|", "\\|").replace("\n", " ") for cell in [*cells, words]) + " |",
              flush=True)
    return 1 if failed else 0


HEAD = """# Rooms, found by others

Made by `validation/rooms/run DRAWING[,UNIT]...` with ezdxf {ezdxf} and Shapely {shapely} (GEOS {geos}). A script reads the
drawing by itself: ezdxf explodes inserts and leaves out what is hidden; `unary_union` and `polygonize` make faces. A room is
a face that is as large as `rooms` says that one is at least, with a circle in it (`maximum_inscribed_circle`) as wide as
that; texts belong to the room that they lie in, or whose outline is the smallest around the face that they lie in.
*Same* is: the same rooms, one by one; areas that differ by 1e-9 of their size at most; widths that
differ by 2 percent, of the room's and of the least one; the same names of each; as many texts in no room. Least sizes are
those that `rooms` has chosen, 0.5 m where the unit is known; *either*: faces as wide as that within 2 percent,
and slivers of a 1e-12th of the extent, which doubles make and `rooms` joins. Of drawings with curves both sides make
chords within 1e-5 of the drawing's extent, and areas may differ by twice that along the perimeter.

| drawing | segments | lines | their faces | their rooms | either | ours | names | texts outside | areas within | rooms and names |
| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"""

if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2:]))
