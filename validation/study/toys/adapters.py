"""Adapters as programs: which there are, and cases put to them. ../adapters/README.md has the
protocol."""

from __future__ import annotations

import json
import os
import select
import signal
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).resolve().parent.parent / "adapters"
NOT_HERE = 3
_SECONDS_TO_LIST = 60

Answer = dict[str, Any]


@dataclass(frozen=True)
class Listed:
    """An engine as its adapter lists it, or why it is not here."""

    name: str
    listed: dict[str, Any] | None
    reason: str = ""

    @property
    def configurations(self) -> list[str]:
        return [c["name"] for c in self.listed["configurations"]] if self.listed else []

    @property
    def takes_rings(self) -> bool:
        """Whether cases are rings, and not segments."""
        return self.listed is not None and self.listed.get("input") == "rings"


def engines() -> list[Listed]:
    """All, by their names."""
    return [_listed(path.parent.name) for path in sorted(FOLDER.glob("*/adapter"))]


def _listed(name: str) -> Listed:
    command = [str(FOLDER / name / "adapter"), "--list"]
    try:
        run = subprocess.run(
            command, capture_output=True, text=True, timeout=_SECONDS_TO_LIST, check=False
        )
    except subprocess.TimeoutExpired:
        return Listed(name, None, f"its adapter lists nothing in {_SECONDS_TO_LIST} s")
    said = run.stderr.strip().splitlines() or [f"its adapter ends with code {run.returncode}"]
    if run.returncode == NOT_HERE:
        return Listed(name, None, said[0])
    if run.returncode != 0:
        return Listed(name, None, f"broken: {said[-1]}")
    return Listed(name, json.loads(run.stdout))


class Stopped(Exception):
    """An adapter that ended, or that gave no answer in time."""


class Adapter:
    """A running adapter of one configuration."""

    def __init__(self, engine: str, configuration: str) -> None:
        self._process = subprocess.Popen(
            [FOLDER / engine / "adapter", configuration],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            start_new_session=True,  # so that what it starts can be ended with it
        )
        self._unread = b""

    def ask(
        self,
        case: int,
        segments: list[list[float]],
        seconds: float,
        tolerance: float | str | None = None,
    ) -> Answer:
        """The answer to one case. None: the configuration's own tolerance.

        Raises Stopped where none comes within so many seconds.
        """
        given: dict[str, Any] = {"case": case, "segments": segments}
        if tolerance is not None:
            given["tolerance"] = tolerance
        return self._ask(given, seconds)

    def ask_rings(
        self, case: int, rings: list[list[tuple[float, float]]], rule: str, seconds: float
    ) -> Answer:
        """The same of an engine of rings."""
        return self._ask({"case": case, "rings": rings, "rule": rule}, seconds)

    def _ask(self, case: dict[str, Any], seconds: float) -> Answer:
        assert self._process.stdin is not None
        line = json.dumps(case)
        try:
            self._process.stdin.write(line.encode() + b"\n")
            self._process.stdin.flush()
        except BrokenPipeError:
            raise self._ended() from None
        answer: Answer = json.loads(self._line(time.monotonic() + seconds))
        return answer

    def _line(self, deadline: float) -> bytes:
        assert self._process.stdout is not None
        out = self._process.stdout.fileno()
        while b"\n" not in self._unread:
            left = deadline - time.monotonic()
            if left <= 0 or not select.select([out], [], [], left)[0]:
                raise Stopped("timeout")
            read = os.read(out, 1 << 16)
            if not read:
                raise self._ended()
            self._unread += read
        line, _, self._unread = self._unread.partition(b"\n")
        return line

    def _ended(self) -> Stopped:
        code = self._process.wait()
        return Stopped(
            f"crash, {signal.Signals(-code).name}" if code < 0 else f"ended, code {code}"
        )

    def close(self) -> None:
        """Ends it and what it started."""
        assert self._process.stdin is not None and self._process.stdout is not None
        with suppress(BrokenPipeError):
            self._process.stdin.close()
        try:
            self._process.wait(timeout=10)
        except subprocess.TimeoutExpired:
            os.killpg(self._process.pid, signal.SIGKILL)
            self._process.wait()
        self._process.stdout.close()

    def kill(self) -> None:
        """Ends it and what it started, at once."""
        if self._process.poll() is None:
            os.killpg(self._process.pid, signal.SIGKILL)
        self.close()


@contextmanager
def running(engine: str, configuration: str) -> Iterator[Adapter]:
    adapter = Adapter(engine, configuration)
    try:
        yield adapter
    except Stopped:
        adapter.kill()
        raise
    finally:
        adapter.close()
