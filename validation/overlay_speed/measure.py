"""Runs all contenders of Booleans on all workloads, each run in a process of its own, and prints a page."""

import argparse
import os
import random
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

SIZES = {  # by workload: those of --quick, and of the page
    "checkerboard": ([30], [30, 200]),
    "apart": ([30], [30, 200]),
    "net": ([30], [128, 384]),
    "spiral": ([1000], [10_000, 300_000]),
    "windows": ([30], [30, 200]),
    "nested": ([100], [1000, 10_000]),
    "scattered": ([100], [300, 1000]),
}
LIMIT = 60  # seconds
REPETITIONS = 3


def contenders(programs, peers):
    return {
        "ours, 1 thread": [programs / "overlay_plumbline", "FILE", "1"],
        "ours, 2 threads": [programs / "overlay_plumbline", "FILE", "2"],
        "iOverlay i64": [peers, "ioverlay64", "FILE"],
        "iOverlay i32": [peers, "ioverlay32", "FILE"],
        "Clipper2": [peers, "clipper2", "FILE"],
        "GEOS": [programs / "overlay_geos", "FILE"],
        "CGAL": [programs / "overlay_cgal", "FILE"],
    }


def once(command, file):
    """(milliseconds, MiB, polygons, area), or why there is none."""
    words = [file if word == "FILE" else str(word) for word in command]
    try:
        done = subprocess.run(words, capture_output=True, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return f"> {LIMIT} s"
    if done.returncode == 3:
        return "invalid for it"
    if done.returncode != 0:
        return "fails"
    milliseconds, memory, polygons, area = done.stdout.split()
    return float(milliseconds), float(memory), int(polygons), float(area)


def median(runs):
    failed = [run for run in runs if isinstance(run, str)]
    return failed[0] if failed else (statistics.median(r[0] for r in runs), max(r[1] for r in runs), *runs[0][2:])


def row(file, commands):
    runs = {name: [] for name in commands}
    dice = random.Random(1)
    for _ in range(REPETITIONS):
        for name in dice.sample(list(commands), len(commands)):
            last = runs[name][-1] if runs[name] else None
            is_slow = isinstance(last, str) or (last is not None and last[0] > 20_000)
            runs[name].append(last if is_slow else once(commands[name], file))
    return {name: median(found) for name, found in runs.items()}


def seconds(found):
    return found if isinstance(found, str) else f"{found[0] / 1000:.3g}"


def cell(found, ours):
    if isinstance(found, str):
        return found
    text = f"{found[0] / 1000:.3g} ({found[0] / ours[0]:.2g} x)"
    is_same = abs(found[3] - ours[3]) <= 1e-9 * abs(ours[3])
    return text if is_same else f"{text}, area {found[3] / ours[3] - 1:+.1g}"


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--quick", action="store_true")
    for name in "commit", "programs", "peers":
        options.add_argument(f"--{name}", required=True)
    given = options.parse_args()
    commands = contenders(Path(given.programs), Path(given.peers))
    first, *others = commands
    print(f"""# Speed of Booleans of polygons

Made by `validation/overlay_speed/run{" --quick" if given.quick else ""}` at commit {given.commit}; {os.cpu_count()} threads, load
when started {os.getloadavg()[0]:.1f}. Seconds of one call in memory (the median of {REPETITIONS} processes, in random order), in brackets how many
times that of ours on one thread: below 1 it is faster than ours. Ours is exact, and its polygons know their sources; iOverlay
and Clipper2 round crossings to the grid of integers; GEOS rounds to doubles; CGAL is exact. Where the area is not ours to nine
digits it is said how far off. Ours gives polygons with their holes, areas and adjacency, as do GEOS, CGAL and iOverlay (valid
output on); Clipper2's paths have no nesting. "Invalid for it": the rings of a set cross or lie within each other.

| workload | edges | polygons | {" | ".join(commands)} | MiB of ours, iOverlay i64, Clipper2 |
|---|---:|---:|{"---:|" * len(commands)}---:|""")
    with tempfile.TemporaryDirectory() as folder:
        for name, (short, long) in SIZES.items():
            for n in short if given.quick else long:
                file = f"{folder}/{name}"
                subprocess.run([sys.executable, Path(__file__).parent / "workloads.py", name, str(n), file], check=True)
                with open(file) as text:
                    next(text)
                    edges = sum(line.count(" ") // 2 for line in text)
                found = row(file, commands)
                ours = found[first]
                if isinstance(ours, str):
                    sys.exit(f"{name} {n}: {ours}")
                cells = [seconds(ours)] + [cell(found[other], ours) for other in others]
                memory = [
                    "-" if isinstance(found[k], str) else f"{found[k][1]:.0f}"
                    for k in (first, "iOverlay i64", "Clipper2")
                ]
                print(f"| {name} {n} | {edges} | {ours[2]} | {' | '.join(cells)} | {', '.join(memory)} |", flush=True)


if __name__ == "__main__":
    main()
