"""Results: a row for each engine's configuration, drawing and truth, in one Parquet file.

While a run goes on, rows are in pieces beside the file, each whole or not there; they become part
of it at its end, or when the next run begins.
"""

from __future__ import annotations

import fcntl
import os
import uuid
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq

_TEXT = pa.string()

SCHEMA = pa.schema(
    [
        ("engine", _TEXT),
        ("version", _TEXT),
        ("configuration", _TEXT),
        ("group", _TEXT),
        ("family", _TEXT),
        ("size", pa.int64()),
        ("scale", _TEXT),
        ("seed", pa.int64()),
        ("order", pa.int64()),
        ("ratio", pa.float64()),  # of a sweep: tolerance to least feature meant; none: own one
        ("truth", _TEXT),
        # What the engine is.
        ("title", _TEXT),
        ("algorithm", _TEXT),
        ("configuration_title", _TEXT),
        ("tolerance_kind", _TEXT),
        ("tolerance", pa.float64()),
        ("source", _TEXT),
        # What the drawing is.
        ("segments", pa.int64()),
        ("exact_vertices", pa.int64()),
        ("exact_edges", pa.int64()),
        ("exact_faces", pa.int64()),
        ("feature_size", pa.float64()),
        ("perimeter", pa.float64()),  # of the region, where it is rings
        ("fits_doubles", pa.bool_()),
        ("both_engines", pa.bool_()),
        # What came of it.
        ("outcome", _TEXT),
        ("kind", _TEXT),
        ("all_kinds", _TEXT),
        ("vertices", pa.int64()),
        ("edges", pa.int64()),
        ("faces", pa.int64()),
        ("faces_wrong", pa.int64()),
        ("area", pa.float64()),
        ("displacement", pa.float64()),
        ("compare_tolerance", pa.float64()),
        ("answer", _TEXT),
        ("seconds", pa.float64()),
        ("message", _TEXT),
    ]
)
KEY = tuple(SCHEMA.names[:11])
"""What a row is told by; the last is the truth."""
UNIT = KEY[:-1]
DRAWING = UNIT[4:-1]

Row = dict[str, Any]


def load(path: Path) -> pa.Table:
    """All rows of a file; none where there is no file. Columns that older files do not have are
    without values."""
    return pq.read_table(path, schema=SCHEMA) if path.exists() else SCHEMA.empty_table()


def units_done(table: pa.Table) -> set[tuple[Any, ...]]:
    """Units that are in results."""
    columns = list(UNIT)
    rows = table.select(columns).group_by(columns).aggregate([])
    return set(zip(*(rows.column(name).to_pylist() for name in columns)))


def write_piece(path: Path, rows: Iterable[Row]) -> None:
    """Puts rows beside the file, all or none."""
    folder = _pieces(path)
    folder.mkdir(parents=True, exist_ok=True)
    name = uuid.uuid4().hex
    table = pa.Table.from_pylist(list(rows), schema=SCHEMA)
    pq.write_table(table, folder / f".{name}", compression="zstd")
    os.replace(folder / f".{name}", folder / f"{name}.parquet")


def gather(path: Path) -> pa.Table:
    """Makes the pieces part of the file, and returns it all: by key, a unit once."""
    if not _pieces(path).exists():
        return load(path)
    with open(_pieces(path) / ".lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # of runs side by side one gathers at a time
        pieces = sorted(_pieces(path).glob("*.parquet"))
        if pieces:
            tables = [load(path), *(pq.read_table(piece, schema=SCHEMA) for piece in pieces)]
            write(path, pa.concat_tables(tables))
        for piece in pieces:
            piece.unlink()
        return load(path)


def write(path: Path, table: pa.Table) -> None:
    """By key, the first of equal keys alone; all or nothing."""
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(f".{path.name}.part")
    pq.write_table(sorted_once(table), part, compression="zstd")
    os.replace(part, path)


def sorted_once(table: pa.Table) -> pa.Table:
    numbered = table.append_column("row", pa.array(range(len(table)), pa.int64()))
    first = numbered.group_by(list(KEY)).aggregate([("row", "min")])
    return table.take(first["row_min"]).sort_by([(name, "ascending") for name in KEY])


def _pieces(path: Path) -> Path:
    return path.with_name(f"{path.name}.pieces")
