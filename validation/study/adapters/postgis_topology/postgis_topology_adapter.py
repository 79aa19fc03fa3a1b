"""PostGIS topology: lines added one by one, in a database server of the adapter's own.

Each case is a transaction that is rolled back, so that no case leaves anything to the next.
"""

from __future__ import annotations

import atexit
import ctypes
import os
import pwd
import shutil
import signal
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np
import psycopg
import shapely
from geometries import as_lines, model_of
from study_adapter import (
    BadTolerance,
    Clock,
    Configuration,
    Engine,
    EngineError,
    Floats,
    Model,
    not_here,
    serve,
)

PROGRAMS = Path("/usr/lib/postgresql/15/bin")
EXTENSION = Path("/usr/share/postgresql/15/extension/postgis_topology.control")
SNAP = 1e-9
_FOLDER = "plumbline-postgis-"
_SECONDS_TO_START = 30
_SET_PARENT_DEATH_SIGNAL = 1  # PR_SET_PDEATHSIG of prctl


def _as_postgres() -> dict[str, Any]:
    """A server does not run as root: Debian's package makes a user for it."""
    if os.geteuid() != 0:
        return {}
    account = pwd.getpwnam("postgres")
    return {"user": account.pw_uid, "group": account.pw_gid, "extra_groups": []}


def _ends_with_adapter() -> None:
    """However an adapter ends, its server does, too."""
    ctypes.CDLL(None).prctl(_SET_PARENT_DEATH_SIGNAL, signal.SIGQUIT)


def _remove_left_folders() -> None:
    """Of adapters that were killed."""
    for folder in Path(tempfile.gettempdir()).glob(f"{_FOLDER}*"):
        adapter = folder.name.removeprefix(_FOLDER).partition("-")[0]
        if not Path("/proc", adapter).exists():
            shutil.rmtree(folder, ignore_errors=True)


def start_server() -> psycopg.Connection[Any]:
    """A connection to a new server, which listens on a socket of a folder of its own."""
    _remove_left_folders()
    folder = Path(tempfile.mkdtemp(prefix=f"{_FOLDER}{os.getpid()}-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    user = _as_postgres()
    if user:
        os.chown(folder, user["user"], user["group"])
    data = folder / "data"
    options = ["-A", "trust", "-U", "study", "-N", "-E", "UTF8", "-D", str(data)]
    initdb = [str(PROGRAMS / "initdb"), *options]
    made = subprocess.run(initdb, cwd=folder, capture_output=True, text=True, check=False, **user)
    if made.returncode != 0:
        not_here(f"initdb: {made.stderr.strip()[-300:]}")
    server = subprocess.Popen(
        [PROGRAMS / "postgres", "-D", data, "-k", folder, "-c", "listen_addresses=", "-F"],
        cwd=folder,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        preexec_fn=_ends_with_adapter,
        **user,
    )
    atexit.register(_stop, server)
    connection = _connected(folder)
    connection.execute("CREATE EXTENSION postgis_topology CASCADE")
    connection.commit()
    return connection


def _stop(server: subprocess.Popen[bytes]) -> None:
    server.send_signal(signal.SIGQUIT)
    server.wait()


def _connected(folder: Path) -> psycopg.Connection[Any]:
    deadline = time.monotonic() + _SECONDS_TO_START
    while True:
        try:
            return psycopg.connect(host=str(folder), user="study", dbname="postgres")
        except psycopg.OperationalError:
            if time.monotonic() > deadline:
                not_here("the database server does not start")
            time.sleep(0.05)


_SERVER: list[psycopg.Connection[Any]] = []
"""The connection, once there is one."""


def added(segments: Floats, clock: Clock, tolerance: float | None) -> Model:
    """Within 0 is within what PostGIS chooses by the size of coordinates."""
    if not _SERVER:
        _SERVER.append(start_server())
    connection = _SERVER[0]
    lines = [shapely.to_wkb(line) for line in as_lines(segments)]
    try:
        with connection.cursor() as cursor:
            cursor.execute("SELECT topology.CreateTopology('t', 0, %s)", [tolerance])
            with clock:
                for line in lines:
                    add = "SELECT topology.TopoGeo_AddLineString('t', %s::geometry, %s)"
                    cursor.execute(add, [line, tolerance])
            edges = _geometries(cursor, "SELECT ST_AsBinary(geom) FROM t.edge_data")
            faces = _geometries(
                cursor,
                "SELECT ST_AsBinary(topology.ST_GetFaceGeometry('t', face_id)) FROM t.face "
                "WHERE face_id > 0 ORDER BY face_id",
            )
    except psycopg.Error as error:
        raise EngineError(type(error).__name__, str(error).partition("\n")[0]) from None
    finally:
        connection.rollback()
    return model_of(edges, faces)


def added_within(segments: Floats, clock: Clock, tolerance: float | None) -> Model:
    if not tolerance:
        raise BadTolerance("0 is PostGIS's own choice, configuration tolerance-0")
    return added(segments, clock, tolerance)


def _geometries(cursor: psycopg.Cursor[Any], query: str) -> Any:
    cursor.execute(query)
    return shapely.from_wkb(np.array([row[0] for row in cursor.fetchall()], dtype=object))


CONFIGURATIONS = [
    Configuration(
        "tolerance-0",
        "TopoGeo_AddLineString, tolerance 0",
        ("none", 0),
        "PostGIS manual, CreateTopology with precision 0, TopoGeo_AddLineString",
        added,
    ),
    Configuration(
        "tolerance-1e-9",
        "TopoGeo_AddLineString, tolerance 1e-9",
        ("snap", SNAP),
        "PostGIS manual, TopoGeo_AddLineString: snaps 'to existing nodes or edges within given "
        "tolerance'",
        added_within,
        way="TopoGeo_AddLineString",
    ),
]


def main() -> None:
    if not (PROGRAMS / "initdb").exists() or not EXTENSION.exists():
        not_here("there is no PostGIS: Debian's package postgresql-15-postgis-3")
    control = dict(
        line.split(" = ") for line in EXTENSION.read_text().splitlines() if " = " in line
    )
    serve(
        Engine(
            "postgis_topology",
            "PostGIS topology",
            control["default_version"].strip("'"),
            "PostGIS topology",
            "GPL-2.0-or-later",
            CONFIGURATIONS,
        )
    )


if __name__ == "__main__":
    main()
