"""The table that a page has of a study: a row for each engine."""

from __future__ import annotations

import re

from study import tables
from study.tables import ENGINE, Engine, Study
from study.words import LOUD, RIGHT, SILENT

_BEGIN, _END = "<!-- validation/study/report -->", "<!-- end -->"
_COLUMNS = ("engine", "drawings", "right", "silently wrong", "says so", "as intended: right")


def summary(study: Study) -> str:
    """Markdown: of each engine the configuration that is right most often over the doubles, the
    most often right first, and how often it is as was intended. Per cent. Empty without answers."""
    doubles, intended = (tables.counts(study.fair(t), ENGINE) for t in ("doubles", "intended"))
    right = {e: tables.share(doubles[e], RIGHT) for e in study.engines if e in doubles}
    chosen: dict[str, Engine] = {}
    for engine in sorted(right, key=lambda e: (-right[e].value, study.of(e))):
        chosen.setdefault(study.of(engine).partition(":")[0], engine)
    lines = [_COLUMNS, ("---",) * len(_COLUMNS)] if chosen else []
    for engine in chosen.values():
        shares = [right[engine], *(tables.share(doubles[engine], o) for o in (SILENT, LOUD))]
        shares.append(tables.share(intended.get(engine, {}), RIGHT))
        cells = (str(s).replace(" %", "") for s in shares)
        lines.append((study.of(engine), str(right[engine].n), *cells))
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def in_page(page: str, text: str) -> str:
    """A page with this text between its two marks. Throws: ValueError where it has not both."""
    marked = re.compile(f"(?s)({re.escape(_BEGIN)}\n).*?({re.escape(_END)}\n)")
    if len(marked.findall(page)) != 1:
        raise ValueError(f"no place for a table: {_BEGIN} and {_END}, once")
    return marked.sub(lambda found: f"{found[1]}\n{text}\n{found[2]}", page)
