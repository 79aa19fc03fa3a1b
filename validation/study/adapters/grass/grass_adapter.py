"""GRASS: lines cleaned by v.clean, then areas of its own topology.

Runs itself again within a GRASS session, in which modules are programs. Areas are built of
boundaries; as the manual has it, those that dangle or are bridges become lines first.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable

import numpy as np
from study_adapter import (
    Clock,
    Configuration,
    Engine,
    EngineError,
    Floats,
    Ints,
    Model,
    distinct,
    edges_once,
    not_here,
    serve,
)

DECIMALS = 32
"""Of what GRASS prints, the most that it can: enough for doubles above 1e-15."""
SNAP = 1e-9


def module(*arguments: str, given: str | None = None) -> str:
    """What a GRASS module prints."""
    run = subprocess.run(arguments, input=given, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise EngineError(arguments[0], run.stderr.strip() or f"exit code {run.returncode}")
    return run.stdout


def cleaned_by(tools: str, *flags: str) -> Callable[[Floats, Clock, float | None], Model]:
    """The tolerance is the threshold of the tools snap and rmdangle; others have none."""

    def run(segments: Floats, clock: Clock, tolerance: float | None) -> Model:
        within = {"snap": repr(tolerance), "rmdangle": repr(tolerance)}
        thresholds = ",".join(within.get(tool, "0") for tool in tools.split(","))
        how = [*flags, "type=line", f"tool={tools}", f"threshold={thresholds}"]
        clean = ["v.clean", "--q", "--o", *how]
        if not len(segments):
            return {"V": [], "EV": [], "polygons": []}
        records = "".join(
            f"L 2 0\n {a!r} {b!r}\n {c!r} {d!r}\n" for a, b, c, d in segments.tolist()
        )
        module(
            "v.in.ascii", "--q", "--o", "-n", "in=-", "out=given", "format=standard", given=records
        )
        with clock:
            module(*clean, "in=given", "out=noded")
            has_areas = _build_areas()
        return _model(has_areas)

    return run


def _build_areas() -> bool:
    """Whether there may be any."""
    types = ["from_type=line", "to_type=boundary"]
    module("v.type", "--q", "--o", "in=noded", "out=boundaries", *types)
    to_lines = ["type=boundary", "tool=chdangle,chbridge", "threshold=-1,0"]
    module("v.clean", "--q", "--o", "in=boundaries", "out=closed", *to_lines)
    try:
        module("v.centroids", "--q", "--o", "in=closed", "out=areas")
    except EngineError as error:
        if "no boundaries" in str(error):  # all were dangling
            return False
        raise
    return True


def _model(has_areas: bool) -> Model:
    precision = f"precision={DECIMALS}"
    all_lines = ["in=noded", "format=standard", "type=line", "layer=-1"]
    lines = _lines(module("v.out.ascii", "--q", *all_lines, precision))
    of_areas = ["in=areas", "format=wkt", "type=area", precision]
    areas = module("v.out.ascii", "--q", *of_areas) if has_areas else ""
    rings = [_rings(line) for line in areas.splitlines() if line.startswith("POLYGON")]
    chains = lines + [ring for polygon in rings for ring in polygon]
    vertices, index = distinct(np.concatenate(chains) if chains else np.empty((0, 2)))
    numbered = np.split(index, np.cumsum([len(c) for c in chains])[:-1]) if chains else []
    pairs: list[Ints] = [np.stack([c[:-1], c[1:]], axis=1) for c in numbered[: len(lines)]]
    around = iter(numbered[len(lines) :])
    return {
        "V": vertices.tolist(),
        "EV": edges_once(np.concatenate(pairs)) if pairs else [],
        "polygons": [[next(around)[:-1].tolist() for _ in polygon] for polygon in rings],
    }


def _lines(text: str) -> list[Floats]:
    """The lines of GRASS's standard format: L and a count, then as many points."""
    result: list[Floats] = []
    rows = iter(text.partition("VERTI:")[2].splitlines())
    for row in rows:
        head = row.split()
        if head and head[0] == "L":
            points = [next(rows).split()[:2] for _ in range(int(head[1]))]
            result.append(np.array(points, dtype=np.float64))
            for _ in range(int(head[2]) if len(head) > 2 else 0):
                next(rows)  # categories
    return result


def _rings(wkt: str) -> list[Floats]:
    texts = re.findall(r"\(([^()]+)\)", wkt)
    return [np.array([p.split() for p in text.split(",")], dtype=np.float64) for text in texts]


CONFIGURATIONS = [
    Configuration(
        "break",
        "v.clean break, rmdupl",
        ("none", 0),
        "v.clean manual: breaking lines should be followed by removing duplicates",
        cleaned_by("break,rmdupl"),
    ),
    Configuration(
        "snap-1e-9-break",
        "v.clean snap 1e-9, break, rmdupl",
        ("snap", SNAP),
        "v.clean manual: what was snapped may need break, rmdupl; "
        "order of the tools as in the manual's examples",
        cleaned_by("snap,break,rmdupl"),
        promise="some",  # vertices of the input that are near each other
        way="v.clean snap, break, rmdupl",
    ),
    Configuration(
        "break-snap-1e-9-break",
        "v.clean break, snap 1e-9, break, rmdupl",
        ("snap", SNAP),
        "v.clean manual: snap joins vertices to vertices only, so crossings are to be there",
        cleaned_by("break,snap,break,rmdupl"),
        promise="some",  # vertices that are near each other, and not near edges
        way="v.clean break, snap, break, rmdupl",
    ),
    Configuration(
        "combined-snap-1e-9",
        "v.clean -c snap 1e-9",
        ("snap", SNAP),
        "v.clean manual, flag -c: 'combine tools with recommended follow-up tools', here break, "
        "rmdupl, rmsa, repeated",
        cleaned_by("snap", "-c"),
        promise="some",  # as above
        way="v.clean -c snap",
    ),
]

REPAIRS = [
    Configuration(
        "break-snap-break-rmdangle",
        "v.clean break, snap, break, rmdupl, rmdangle",
        ("snap", SNAP),
        "v.clean manual: snap, and rmdangle, which removes dangles up to the threshold",
        cleaned_by("break,snap,break,rmdupl,rmdangle"),
        way="v.clean break, snap, break, rmdupl, rmdangle",
    ),
]


def main() -> None:
    if shutil.which("grass") is None:
        not_here("there is no grass: Debian's package grass-core")
    if "GISRC" not in os.environ and "--list" not in sys.argv:
        session = ["grass", "--tmp-location", "XY", "--exec", sys.executable]
        os.execvp("grass", [*session, __file__, *sys.argv[1:]])
    version = subprocess.run(["grass", "--version"], capture_output=True, text=True, check=False)
    number = re.search(r"GRASS GIS ([0-9.]+)", version.stdout + version.stderr)
    serve(
        Engine(
            "grass",
            "GRASS v.clean",
            number[1] if number else "unknown",
            "GRASS",
            "GPL-2.0-or-later",
            CONFIGURATIONS,
            REPAIRS,
        )
    )


if __name__ == "__main__":
    main()
