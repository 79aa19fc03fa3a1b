"""The table of validation/suites/run: suites of other libraries, case by case."""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path

from cases import cases_of
from judge import Verdict, judged

SUITES = (
    "jts-overlay",
    "jts-general",
    "geos-misc",
    "geos-issue",
    "clipper2",
    "ioverlay",
    "martinez",
    "polygon-clipping",
    "turf",
)
KINDS = ("equal", "rounded", "laws", "expectation wrong", "not decided", "ours wrong")


def main(folder: Path) -> int:
    """Prints the table; whether ours was wrong anywhere."""
    rows, listed, left_out = [], [], []
    wrong = 0
    rings: Counter[bool | None] = Counter()
    for suite in SUITES:
        if not (folder / suite).is_dir():
            continue
        counts: Counter[str] = Counter()
        reasons: Counter[str] = Counter()
        confirmed = 0
        for case in cases_of(folder / suite):
            if isinstance(case, str):
                reasons[case.rpartition(": ")[2]] += 1
                continue
            print(f"{suite}: {case.name}: {case.operation}", file=sys.stderr)
            verdict = _judged(case)
            counts[verdict.kind] += 1
            confirmed += verdict.by_slabs
            rings[verdict.same_rings] += 1
            if verdict.kind not in ("equal", "rounded", "laws"):
                said = f" The file says: {case.note}" if case.note else ""
                listed.append(
                    f"- {suite}: {case.name}, {case.operation}: {verdict.kind}: "
                    f"{verdict.reason}.{said}"
                )
        wrong += counts["ours wrong"]
        cells = " | ".join(str(counts[kind]) for kind in KINDS)
        rows.append(f"| {suite} | {counts.total()} | {cells} | {confirmed} |")
        if reasons:
            texts = [f"{reason} ({n})" for reason, n in reasons.most_common()]
            left_out.append(f"- {suite}: {', '.join(texts)}.")
    print(
        "| suite | cases | equal | equal within rounding | no expectation, laws hold | "
        "expectation wrong | not decided | ours wrong | confirmed by slabs |"
    )
    print("| --- |" + " ---: |" * 8)
    print("\n".join(rows))
    print(
        f"\nOf {rings[True] + rings[False]} expected counts of rings {rings[True]} are ours. The "
        "others are not judged: where\nrings touch, their number "
        "says nothing of which points are covered, and in integers what is thinner than a unit is none."
    )
    if listed:
        print("\n## Where expectation and result differ\n\n" + "\n".join(listed))
    if left_out:
        print("\n## What is not about areas, and left out\n\n" + "\n".join(left_out))
    return 1 if wrong else 0


def _judged(case: object) -> Verdict:
    try:
        return judged(case)  # type: ignore[arg-type]
    except Exception as error:  # an exception of ours is wrong, whatever it is
        return Verdict("ours wrong", f"{type(error).__name__}: {error}")


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
