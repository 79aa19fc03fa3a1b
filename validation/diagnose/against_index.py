#!/usr/bin/env python3
"""Compares what Plumbline's diagnosis counts with an index of the files, measured by others on doubles.

Usage: against_index.py PLUMBLINE_DIAGNOSE DIRECTORY
Prints two Markdown tables; exit code 1 if a difference has no explanation.
"""
import json
import pathlib
import subprocess
import sys

SUFFIXES = {".svg", ".dxf", ".lines", ".geojson", ".json", ".wkt"}
MEASURES = {"duplicates": "duplicates", "overlaps": "overlaps", "dangling_ends": "dangling_ends"}
KINDS = ["duplicate", "overlap", "gap", "undershoot", "overshoot", "near-miss", "dangle", "bridge",
         "sliver", "short edge", "nearly parallel", "invalid ring"]


def diagnosed(program, file):
    run = subprocess.run([program, file], capture_output=True, text=True, timeout=600)
    if run.returncode not in (0, 2):
        sys.exit(f"{file}: exit code {run.returncode}: {run.stderr}")
    return json.loads(run.stdout) if run.returncode == 0 else None


def index_near(measures):
    return measures.get("near_vertices_1e-9", 0) + measures.get("near_t_1e-9", 0)


def agrees(ours, measures):
    return all(ours[mine] == measures.get(theirs, 0) for mine, theirs in MEASURES.items())


def agrees_on_near(ours, measures):
    return (ours["near"] > 0) == (index_near(measures) > 0)


def verdict(entry, found):
    """Why the counts differ, if they do; None where nothing explains it."""
    measures, authored, doubles = entry["measures"], found["authored"], found["doubles"]
    if agrees(authored, measures) and agrees_on_near(authored, measures):
        return "equal"
    if agrees(doubles, measures) and agrees_on_near(doubles, measures):
        return "equal over the doubles: incidences of the decimals are lost there"
    if not measures.get("pairs_complete", True):
        return "the index gave up on this file's pairs"
    if entry["counts"].get("transform") or entry["format"] == "dxf":
        return "the index composes maps in doubles, which moves points"
    if entry["counts"].get("rect"):
        return "the index adds widths to corners in doubles, which moves points"
    if agrees(authored, measures) and index_near(measures) == 0:
        return "the index leaves out pairs of segments that share an end, and crossings"
    return None


def main(program, directory):
    rows, kinds, skipped, failures = [], [], {"curves": 0, "segments": 0, "refused": 0}, 0
    for entry in json.loads((directory / "index.json").read_text())["files"]:
        file = directory / entry["file"]
        if file.suffix.lower() not in SUFFIXES or not entry.get("segments"):
            continue
        found = diagnosed(program, file)
        if found is None:
            skipped["refused"] += 1
            continue
        kinds.append((entry["file"], found))
        if entry.get("curve_chords"):
            skipped["curves"] += 1
            continue
        measures = entry["measures"]
        if found["authored"]["segments"] != entry["segments"] - measures.get("zero_length", 0):
            skipped["segments"] += 1
            continue
        why = verdict(entry, found)
        failures += why is None
        cells = [f"{found['authored'][mine]} / {found['doubles'][mine]} / {measures.get(theirs, 0)}"
                 for mine, theirs in MEASURES.items()]
        cells.append(f"{found['authored']['near']} / {found['doubles']['near']} / {index_near(measures)}")
        rows.append((entry["file"], found["authored"]["segments"], cells, why or "**UNEXPLAINED**"))

    print(f"{len(rows)} files compared, {sum(why == 'equal' for *_, why in rows)} of them equal as authored. Not")
    print(f"compared: {skipped['curves']} with curves, which the index leaves out of these counts; {skipped['segments']} of which the")
    print(f"index has other segments (unclosed rings, refused geometries, several cases in a file); {skipped['refused']} that")
    print("are refused. Files without any of these defects are not listed.\n")
    print("| file | segments | duplicates | overlapping pairs | dangling ends | near | verdict |")
    print("| --- | ---: | ---: | ---: | ---: | ---: | --- |")
    for name, segments, cells, why in rows:
        if why != "equal" or any(cell != "0 / 0 / 0" for cell in cells):
            print(f"| {name} | {segments} | {' | '.join(cells)} | {why} |")
    print("\n## Kinds at the default search distance\n")
    print(f"| file | segments | {' | '.join(KINDS)} | cut short | seconds |")
    print("| --- |" + " ---: |" * (len(KINDS) + 3))
    for name, found in kinds:
        counts = [str(found["kinds"][kind]) for kind in KINDS]
        if any(count != "0" for count in counts):
            print(f"| {name} | {found['authored']['segments']} | {' | '.join(counts)} | "
                  f"{found['kinds']['cut short']} | {found['kinds']['seconds']:.3f} |")
    return 1 if failures else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], pathlib.Path(sys.argv[2])))
