#!/usr/bin/env python3
"""Recorded results of the original LAR module, checked with `plumbline check --against`.

usage: larlib_results.py PLUMBLINE DIRECTORY

Every recorded result of each drawing below DIRECTORY is held against the exact arrangement of the
drawing, its numbers read as decimals and as doubles. The findings of the minimal inputs of the
catalogue must be those that the catalogue says (EXPECTED, written by hand from it); for all
drawings the counts must be those that were recorded. Prints Markdown; exit code 1 if not.
"""
import collections
import json
import os
import subprocess
import sys
import tempfile
from decimal import Decimal

# LAR merges within 0.001, which moves a vertex by less, and rounds to 4 decimals.
TOLERANCE = 0.001

# Catalogue ids, case, reading (None: both), result: broken invariants, other findings (None: some).
EXPECTED = [
    ("I1", "degenerate-collinear-overlap", None, "lar", "vertex on edge",
     "edge merged 1, edge split 1"),
    ("I1", "degenerate-collinear-contained", None, "lar", "vertex on edge", "edge split 1"),
    ("I2 Q3", "degenerate-collinear-overlap-in-box", None, "lar", "crossing",
     "edge merged 1, edge split 1"),
    ("I2", "degenerate-collinear-overlap-in-box", None, "larFromLines", "",
     "edge missing 3, face merged 1, vertex missing 2"),
    ("I2", "svg-inters-house", None, "lar", "vertex on edge", "edge split 1"),
    ("I3", "divergence-room-7x11-wall", None, "lar", "vertex on edge", "edge merged 1"),
    ("I3", "divergence-room-7x11-wall", None, "larFromLines", "",
     "edge merged 1, edge missing 1, face merged 1, vertex missing 1"),
    ("I3", "divergence-variant-room-7x13-5", None, "lar", "vertex on edge", "edge merged 1"),
    ("I3", "divergence-variant-room-7x13-9", None, "lar", "vertex on edge", "edge merged 1"),
    ("I3", "divergence-variant-room-7x15-2", None, "larFromLines", "",
     "edge merged 1, edge missing 1, face merged 1, vertex missing 1"),
    ("I3", "divergence-wall-end-3000", None, "lar", "vertex on edge", "edge merged 1"),
    ("I4", "divergence-corner-7-11", None, "lar", "", ""),
    ("I5", "divergence-slanted-t-missed", "decimals", "lar", "", "edge merged 1"),
    ("I5", "divergence-slanted-t-missed", "doubles", "lar", "", ""),
    ("I5", "divergence-variant-slanted-t-1", None, "lar", "vertex on edge", "edge merged 1"),
    ("I6", "divergence-long-cross-params", None, "lar", "vertex on edge",
     "edge extra 2, edge missing 2, vertex extra 1"),
    ("I6", "scale-cross-100", None, "lar", "crossing", None),
    ("I6", "scale-random-20-s100", None, "lar", "crossing", None),
    ("I7", "scale-orthogonal-8-x0.0001", None, "lar", "", "edge merged 1, vertex merged 1"),
    ("I8", "scale-translated-1e9", None, "lar", "crossing", None),
    ("I10 Q10", "degenerate-point-segment", None, "lar", "index", "edge extra 1, vertex extra 1"),
    ("Q1", "degenerate-chain-radius", None, "lar", "", None),
    ("Q2", "degenerate-radius-exact", None, "lar", "", "edge merged 3, vertex merged 2"),
    ("Q2", "degenerate-radius-exact-shifted", None, "lar", "", ""),
    ("Q4", "divergence-merge-nontermination", None, "lar", "crossing", None),
    ("Q5", "divergence-merge-euler0", None, "lar", "crossing", "vertex merged 1"),
    ("Q5", "divergence-merge-euler0", None, "larFromLines", "crossing, euler",
     "edge missing 6, vertex merged 1, vertex missing 7"),
    ("Q6", "divergence-merge-partial", None, "larFromLines",
     "area, crossing, cyclic order, euler, halfedge in cycle, orientation", None),
    ("Q7", "degenerate-thin-rectangle", None, "lar", "", "edge merged 3, vertex merged 2"),
    ("Q7", "svg-inters-graph3", None, "lar", "", "edge merged 4, vertex merged 4"),
    ("F1", "seed-orthogonal-8", None, "larFromLines", "",
     "edge missing 6, face missing 1, vertex missing 5"),
    ("F2", "divergence-most-edges-not-largest", None, "larFromLines", "",
     "edge missing 4, face missing 1, vertex missing 4"),
    ("F1 F3", "divergence-hole-dropped", None, "larFromLines", "",
     "edge missing 4, face missing 1, hole missing 1, vertex missing 4"),
    ("F4", "divergence-two-triangles-vertex-nonterm", None, "allComponents", "no result", None),
    ("F4", "divergence-two-triangles-vertex-ok", None, "allComponents", "", ""),
    ("F5", "degenerate-single-square", None, "allComponents", "area, euler, halfedge in cycle",
     "face missing 1"),
    ("F3 F5 F5b", "degenerate-nested-siblings", None, "allComponents",
     "area, euler, halfedge in cycle, nesting", "face extra 4, face missing 1, hole missing 1"),
    ("F3 F5b", "divergence-hole-dropped", None, "allComponents",
     "area, euler, halfedge in cycle, nesting", "face extra 1, hole missing 1"),
    ("F8", "degenerate-cross", None, "larFromLines", "no result", None),
    ("P4", "divergence-lattice-level-vertices", None, "cells", "area, halfedge in cycle, nesting",
     "hole missing 1"),
    ("P5", "degenerate-squares-touch-vertex-inside", None, "cells",
     "area, cyclic order, halfedge in cycle", "face reshaped 1"),
    ("P7", "degenerate-nested-squares-5", None, "cells", "area, euler, halfedge in cycle, nesting",
     "face missing 2"),
    ("2018", "divergence-hole-dropped", None, "larFromLines 2018", "", ""),
    ("2018", "degenerate-three-disjoint-squares-largest-last", None, "larFromLines 2018",
     "area, cyclic order, euler, halfedge in cycle, nesting",
     "face extra 1, face reshaped 1, hole wrong parent 1"),
]


def decimal(number, reading):
    """The number as a decimal text: as it prints, or exactly as the double that it is."""
    return format(Decimal(number) if reading == "doubles" else Decimal(repr(number)), "f")


def cycle(edges):
    """The vertices along the edges of a simple cycle; none of another one."""
    neighbours = collections.defaultdict(list)
    for v, w in edges:
        neighbours[v].append(w)
        neighbours[w].append(v)
    if any(len(n) != 2 for n in neighbours.values()):
        return None
    ring = [edges[0][0], edges[0][1]]
    while ring[-1] != ring[0]:
        a, b = neighbours[ring[-1]]
        ring.append(b if a == ring[-2] else a)
    return ring[:-1]


def cells(outputs):
    """The cells with holes that cellsFromCycles makes of the components, as a LAR model."""
    rings = [cycle(component) for component in outputs.get("components", [])]
    numbers = outputs.get("cellsFromCycles")
    if not isinstance(numbers, list) or not rings or None in rings:
        return None
    return {"V": outputs["lar"]["V"], "EV": sum(outputs["components"], []),
            "polygons": [[rings[i] for i in cell] for cell in numbers]}


def results(record):
    """The recorded results by name, as LAR models."""
    outputs = record["outputs"]
    later = (record.get("head2018") or {}).get("outputs") or {}
    for name, source in (("lar", outputs), ("larFromLines", outputs)):
        if source.get(name):
            yield name, {k: source[name][k] for k in ("V", "FV", "EV") if k in source[name]}
    union = outputs.get("allComponents")
    if union:
        yield "allComponents", {"V": union["V"], "EV": union["EV"], "FV": union["FV_interior"]}
    if cells(outputs):
        yield "cells", cells(outputs)
    for name in ("lar", "larFromLines"):
        if later.get(name):
            keys = ("V", "FV", "EV", "polygons")
            yield name + " 2018", {k: later[name][k] for k in keys if k in later[name]}


def check(plumbline, folder, lines, model):
    """The report of `plumbline check`."""
    files = {name: os.path.join(folder, name) for name in ("in.lines", "model.json", "out.json")}
    with open(files["in.lines"], "w") as file:
        file.write(lines)
    with open(files["model.json"], "w") as file:
        json.dump(model, file)
    run = subprocess.run([plumbline, "check", files["in.lines"], "--against", files["model.json"],
                          "--tolerance", str(TOLERANCE), "-o", files["out.json"]],
                         stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
    if run.returncode not in (0, 1):
        raise RuntimeError(run.stderr)
    with open(files["out.json"]) as file:
        return json.load(file)


def wrong_counts(report, model, facts):
    """Counts that differ from the recorded ones: of the model, and of the exact arrangement."""
    exact, given = report["counts"]["exact"], report["counts"]["float"]
    faces = model.get("polygons", model.get("FV"))
    pairs = [("exact V", exact["vertices"], facts["V"]), ("exact E", exact["edges"], facts["E"]),
             ("exact F", exact["faces"], facts["bounded_faces"] + 1),
             ("exact C", exact["components"], facts["C"]),
             ("V", given["vertices"], len(model["V"])), ("E", given["edges"], len(model["EV"]))]
    if faces is not None:
        pairs.append(("F", given["faces"], len(faces) + 1))
    same = report["verdict"] != "agree" or all(
        exact[k] == given[k] for k in ("vertices", "edges") + (("faces",) if faces else ()))
    return [f"{name} {a}, not {b}" for name, a, b in pairs if a != b] + \
           ([] if same else ["agrees with other counts"])


def summary(report):
    """Broken invariants and the other findings by kind, as texts."""
    broken = {f["invariant"] for f in report["findings"] if f["disagreement"] == "invalid"}
    others = collections.Counter(f"{f['kind']} {f['disagreement']}" for f in report["findings"]
                                 if f["disagreement"] != "invalid")
    return ", ".join(sorted(broken)), ", ".join(f"{k} {n}" for k, n in sorted(others.items()))


def main():
    plumbline, directory = sys.argv[1:] if len(sys.argv) == 3 else sys.exit(__doc__)
    found, failures, totals = {}, [], collections.defaultdict(collections.Counter)
    with tempfile.TemporaryDirectory() as folder:
        for name in sorted(os.listdir(directory)):
            if not name.endswith(".json"):
                continue
            with open(os.path.join(directory, name)) as file:
                record = json.load(file)
            if record["kind"] != "inters" or not record["input"]["lines"]:
                continue
            facts = record["exact"]
            for reading in ("decimals", "doubles"):
                known = facts["doubles" if facts[reading] == "same as doubles" else reading]
                lines = "".join(",".join(decimal(x, reading) for p in line for x in p) + "\n"
                                for line in record["input"]["lines"])
                for result, model in results(record):
                    report = check(plumbline, folder, lines, model)
                    for problem in wrong_counts(report, model, known):
                        failures.append(f"{record['case']}, {reading}, {result}: {problem}")
                    found[record["case"], reading, result] = summary(report)
                    tally = totals[result]
                    tally["results"] += 1
                    tally["agree"] += report["verdict"] == "agree"
                    tally["invalid"] += not report["float_valid"]
                    for f in report["findings"]:
                        if f["disagreement"] != "invalid":
                            tally[f"{f['kind']} {f['disagreement']}"] += 1
    print_catalogue(found, failures)
    print_totals(totals)
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


def print_catalogue(found, failures):
    print("## The catalogue\n\n| id | drawing | read as | result | broken invariants | findings |\n"
          "| --- | --- | --- | --- | --- | --- |")
    for ids, case, only, result, broken, others in EXPECTED:
        for reading in [only] if only else ["decimals", "doubles"]:
            is_found = found.get((case, reading, result), ("no result", "none"))
            is_right = is_found[0] == broken and (is_found[1] if others is None else others) == is_found[1]
            if others is None and broken != "no result" and not is_found[1]:
                is_right = False
            if not is_right:
                failures.append(f"{ids} {case}, {reading}, {result}: {is_found}, not {broken, others}")
        print(f"| {ids} | {case} | {only or 'both'} | {result} | {is_found[0] or 'none'} | "
              f"{is_found[1] or 'none'} |")


def print_totals(totals):
    print("\n## All drawings\n\n| result | held against | agree | invalid | findings |\n"
          "| --- | ---: | ---: | ---: | --- |")
    for result, tally in totals.items():
        kinds = ", ".join(f"{k} {n}" for k, n in sorted(tally.items())
                          if k not in ("results", "agree", "invalid"))
        print(f"| {result} | {tally['results']} | {tally['agree']} | {tally['invalid']} | {kinds} |")


if __name__ == "__main__":
    sys.exit(main())
