#!/usr/bin/env python3
"""Holds repaired plans against their rooms once more, and what others make of the damaged ones.

Usage: by_others.py < OUTPUT-OF-plumbline_rooms_again
Prints Markdown tables; exit code 1 where Shapely finds other rooms in a repaired plan, a room came
to harm without a word, or damages of walls below a quarter of the details are not repaired in 99 of 100 plans (doors aside).
"""
import collections
import fractions
import json
import math
import sys

import shapely
from shapely.geometry import LineString, MultiPoint, Point

RELATIVE = 1e-9
GRID = 1e-8  # doubles of turned plans do not lie on their lines
GOAL = 0.99
SMALL = fractions.Fraction(1, 4)


def lines_of(rows):
    return [LineString([row[:2], row[2:]]) for row in rows if row[:2] != row[2:]]


def noded(lines):
    return shapely.unary_union(lines, grid_size=GRID)


def polygons_of(union):
    return [face for face in shapely.polygonize([union]).geoms]


def are_right(union, rooms, size):
    """Each room is one polygon with its area, but for a border moved by the size; there are no others."""
    polygons = polygons_of(union)
    if len(polygons) != len(rooms):
        return False
    tree = shapely.STRtree(polygons)
    found = set()
    for x, y, area, perimeter in rooms:
        hits = [int(i) for i in tree.query(Point(x, y), predicate="within")]
        if len(hits) != 1 or hits[0] in found:
            return False
        if abs(polygons[hits[0]].area - area) > size * perimeter + RELATIVE * area:
            return False
        found.add(hits[0])
    return True


def snapped(lines, size):
    union = noded(lines)
    return noded(shapely.snap(union, union, size))


def closed_gaps(lines, size):
    """Ends within the size of each other, transitively, go to the middle of their cluster."""
    ends = [Point(point) for line in lines for point in line.coords]
    clusters = noded([end.buffer(size / 2) for end in ends])
    middles = MultiPoint([part.centroid for part in getattr(clusters, "geoms", [clusters])])
    return noded([shapely.snap(line, middles, size) for line in lines])


def extended(lines, size):
    longer = []
    for line in lines:
        (ax, ay), (bx, by) = line.coords
        factor = size / math.hypot(bx - ax, by - ay)
        dx, dy = (bx - ax) * factor, (by - ay) * factor
        longer.append(LineString([(ax - dx, ay - dy), (bx + dx, by + dy)]))
    return noded(longer)


OTHERS = {"GEOS snap": snapped, "close gaps": closed_gaps, "extend all": extended}
WITH_DOORS = ["doors", "doors by corners", "all"]
OUTCOMES = ["exact", "right", "listed", "unsaid", "harm"]


class Cell:
    def __init__(self):
        self.plans = 0
        self.of = {"one": collections.Counter(), "auto": collections.Counter()}
        self.others = collections.Counter()
        self.given_up = self.differ = 0

    def add(self, plan):
        self.plans += 1
        rooms, size = plan["rooms"], plan["size"]
        for way in self.of:
            self.of[way][plan[way][0]] += 1
        self.given_up += plan["one"][2] > 0
        ours = are_right(noded(lines_of(plan["repaired"])), rooms, size)
        # Neighbours are counted on the other side only.
        if ours != (plan["one"][0] in ("exact", "right")):
            self.differ += 1
            print(f"differs: {plan['damage']}, {plan['ratio']}, seed {plan['seed']}: {plan['one']}", file=sys.stderr)
        self.others["nothing"] += are_right(noded(lines_of(plan["damaged"])), rooms, size)
        self.others["LAR"] += are_right(noded(lines_of(plan["lar"])), rooms, size)
        for name, rule in OTHERS.items():
            self.others[name] += are_right(rule(lines_of(plan["damaged"]), size), rooms, size)

    def share(self, way):
        return (self.of[way]["exact"] + self.of[way]["right"]) / self.plans


def percent(share):
    return "100" if share == 1 else f"{math.floor(share * 1000) / 10:.1f}"


def share_right(cells):
    return sum(cell.share("one") * cell.plans for cell in cells) / max(1, sum(cell.plans for cell in cells))


def print_tables(cells):
    names = ["nothing", "LAR", *OTHERS]
    print("| damage | size | plans | ours | exactly | auto | " + " | ".join(names) + " |")
    print("| --- | ---" + " | ---:" * (4 + len(names)) + " |")
    for (damage, ratio), cell in cells.items():
        row = [cell.share("one"), cell.of["one"]["exact"] / cell.plans, cell.share("auto"),
               *[cell.others[name] / cell.plans for name in names]]
        print(f"| {damage} | {ratio} | {cell.plans} | " + " | ".join(map(percent, row)) + " |")
    print("""
Plans that are not right. *Listed*: each room that is not is near something refused, or on the list of changed faces;
*unsaid*: a room that the damage took is still missing, and nothing is said of it; *harm*: a room that was there is gone, or
there is a new face, and nothing says so. *Given up*: plans with welds or an operation given up for the sake of a promise.
""")
    print("| damage | size | listed | unsaid | harm | given up | auto: listed | unsaid | harm |")
    print("| --- | ---" + " | ---:" * 7 + " |")
    for (damage, ratio), cell in cells.items():
        row = [cell.of["one"][o] for o in OUTCOMES[2:]] + [cell.given_up] + [cell.of["auto"][o] for o in OUTCOMES[2:]]
        if any(row):
            print(f"| {damage} | {ratio} | " + " | ".join(map(str, row)) + " |")


def main():
    cells = collections.defaultdict(Cell)
    for line in sys.stdin:
        plan = json.loads(line)
        ratio = "" if plan["damage"].startswith("doors") else plan["ratio"]
        cells[plan["damage"], ratio].add(plan)
    print_tables(cells)
    plans, differ = sum(c.plans for c in cells.values()), sum(c.differ for c in cells.values())
    harm = sum(c.of[way]["harm"] for c in cells.values() for way in c.of)
    small = {key: c for key, c in cells.items() if not key[1] or fractions.Fraction(key[1]) < SMALL}
    walls = share_right([c for (damage, _), c in small.items() if damage not in WITH_DOORS])
    print(f"\n{plans} plans. Damages below a quarter of the details: of walls {percent(walls)} percent right, with doors"
          f" {percent(share_right(small.values()))}. Rooms that came to harm without a word: in {harm} repairs. Shapely"
          f" {shapely.__version__} (GEOS {shapely.geos_version_string}) finds other rooms in {differ} repaired plans.")
    return 1 if harm or differ or walls < GOAL else 0


if __name__ == "__main__":
    sys.exit(main())
